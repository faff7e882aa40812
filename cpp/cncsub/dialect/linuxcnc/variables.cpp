// Variables by number and by name: their reading, their assignment and their display.
#include <charconv>

#include "cncsub/control/variable_table.hpp"
#include "cncsub/dialect/linuxcnc/built_in.hpp"
#include "cncsub/dialect/linuxcnc/expression.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub::linuxcnc {

namespace {

constexpr std::int64_t kFirstPosition = 5420, kLastPosition = 5428;
constexpr std::int64_t kPositionShown = 15040;  // the same, beyond what programs can name

bool push_built_in(Builder& to, const Line& line, const std::string& name) {
  const BuiltIn* found = find_built_in(name);
  if (found != nullptr) ngc_push_built_in(to, line, *found);
  return found != nullptr;
}

}  // namespace

bool is_read_only(std::int64_t number) {
  return (number >= 5400 && number <= 5413) ||
         (number >= kFirstPosition && number <= kLastPosition);
}

std::optional<std::int64_t> ExpressionReader::variable_number(std::size_t place) {
  const auto whole = whole_number(constant_.value_or(0), place);
  if (!whole) return std::nullopt;
  const auto number = to_whole<std::int64_t>(*whole);
  if (to_.code().can_name(number, kLastVariable)) return number;
  wrong(Cause::IllegalVariable, "Parameter number out of range", place);
  if (fault) fault->detail = no_variable(to_.control(), "#", number);
  return std::nullopt;
}

bool ExpressionReader::read_variable(int depth) {
  if (line_.peek() == '<') return read_named();
  const std::size_t place = line_.place();
  const std::uint32_t first = to_.expressions().next();
  if (!read_value(depth)) return false;
  if (!constant_) {
    const std::uint32_t at = line_.offset(place - 1);  // of the #
    emit_at(at, Ins::VariableNumber, static_cast<double>(kLastVariable));
    emit_at(at, Ins::Indirect);
    return true;
  }
  const auto number = variable_number(place);
  if (!number) return false;
  constant_.reset();
  to_.expressions().rollback(first);
  ngc_push_load(to_, line_, *number);
  return true;
}

/// Read a name: <name>.
bool ExpressionReader::read_name(std::string& name, std::size_t place) {
  line_.take('<');
  if (line_.take_up_to('>', name)) return true;
  return wrong(Cause::IllegalVariableName, "Named parameter not terminated", place);
}

bool ExpressionReader::read_named() {
  const std::size_t place = line_.place();
  std::string name;
  if (!read_name(name, place)) return false;
  constant_.reset();
  if (push_built_in(to_, line_, name)) return true;
  if (tells_of_machine(name))
    return wrong(Cause::CodeNotComputed,
                 "#<" + name + "> depends on the machine, which cncsub does not have", place);
  const std::uint32_t at = ngc_named(to_, name);
  const NamedVariable& variable = to_.code().named_variables[at];
  const auto index = static_cast<std::uint32_t>(variable.index);
  if (set_here_.contains(name))
    emit(variable.common ? Ins::Common : Ins::Local, 0, index);
  else
    emit(variable.common ? Ins::NamedCommon : Ins::NamedLocal, at, index);
  return true;
}

bool ExpressionReader::read_exists(int depth) {
  const std::size_t place = line_.place();
  if (line_.peek() != '[')
    return wrong(Cause::ExpressionFormat, "Left bracket missing after unary operation name", place);
  line_.take();
  if (!line_.take('#'))
    return wrong(Cause::ExpressionFormat, "Expected # reading parameter", place);
  if (line_.peek() == '<') {
    std::string name;
    if (!read_name(name, place)) return false;
    constant_.reset();
    if (is_read_only(name) || set_here_.contains(name)) {
      emit(Ins::Constant, 1);
    } else {
      ngc_push_raw(to_, line_, name);
      emit(Ins::IsSet);
    }
  } else {
    if (!read_value(depth)) return false;
    constant_.reset();
    emit(Ins::WholeNumber);  // a number asks whether there is a variable of this number
    emit(Ins::Constant, 1);
    emit(Ins::IsWithin, static_cast<double>(kLastVariable));
  }
  if (!line_.take(']'))
    return wrong(Cause::BracketNotClosed, "Expected ] reading bracketed parameter", place);
  return true;
}

bool ExpressionReader::place(Place& place) {
  if (line_.peek() == '<') return named_place(place);
  const std::size_t start = line_.place();
  const std::uint32_t at = line_.offset();
  to_.expressions().begin();
  if (!read_value(0)) return false;
  if (!constant_) {
    emit(Ins::VariableNumber, static_cast<double>(kLastVariable));
    place.target = Statement::Target::Indirect;
    place.number = to_.expressions().end(at, line_.width_from(at));
    return true;
  }
  const auto number = variable_number(start);
  if (!number) return false;
  if (is_read_only(*number))
    return wrong(Cause::VariableWriteProtected, "Parameter is readonly", start);
  ngc_assign_to(to_, *number, place);
  return true;
}

bool ExpressionReader::named_place(Place& place) {
  const std::size_t start = line_.place();
  std::string name;
  if (!read_name(name, start)) return false;
  if (is_read_only(name))
    return wrong(Cause::VariableWriteProtected,
                 "Cannot assign to read-only parameter #<" + name + ">", start);
  const NamedVariable& variable = ngc_variable(to_, name);
  place.target = variable.common ? Statement::Target::Common : Statement::Target::Local;
  place.index = variable.index;
  set_here_.insert(name);
  return true;
}

bool ExpressionReader::shown(Value& value) {
  const std::uint32_t at = line_.offset();
  to_.expressions().begin();
  constant_.reset();
  if (std::string name; line_.peek() == '<') {
    if (!read_name(name, line_.place())) return false;
    if (!push_built_in(to_, line_, name)) ngc_push_raw(to_, line_, name);
    return finish(value, at);
  }
  const std::string_view digits = line_.take_digits();
  std::int64_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (number >= kFirstPosition && number <= kLastPosition) {  // a message shows it at any time
    ngc_push_load(to_, line_, number - kFirstPosition + kPositionShown);
    return finish(value, at);
  }
  if (digits.size() > 9 || !to_.code().can_name(number, kLastVariable))
    emit(Ins::Constant, digits.size() <= 9 && number == 0 ? 0 : kVacant);
  else
    ngc_push_load(to_, line_, number);
  return finish(value, at);
}

}  // namespace cncsub::linuxcnc
