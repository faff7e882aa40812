// Variables by number and by name: their reading, their assignment and their display.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "cncsub/control/variable_table.hpp"
#include "cncsub/dialect/grblhal/built_in.hpp"
#include "cncsub/dialect/grblhal/expression.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub::grblhal {

namespace {

constexpr std::size_t kLongestName = 30;  // [gHp, NGC_MAX_PARAM_LENGTH]

/// Return whether what a name returns is asked: 0 the value, 1 whether there is one, -1 neither.
int returned_place(const std::string& name) {
  const auto* const found = std::find(std::begin(kReturned), std::end(kReturned), name);
  return found == std::end(kReturned) ? -1 : static_cast<int>(found - std::begin(kReturned));
}

}  // namespace

bool has_variable(std::int64_t number) {
  struct Range {
    std::int64_t first, last;
  };
  // [gHp, ngc_ro_params]
  constexpr Range kRead[] = {
      {1, kLastWritten}, {5061, 5070}, {5161, 5169}, {5181, 5189}, {5191, 5199}, {5210, 5219},
      {5220, 5230},      {5241, 5250}, {5261, 5270}, {5281, 5290}, {5301, 5310}, {5321, 5330},
      {5341, 5350},      {5361, 5370}, {5381, 5390}, {5399, 5410}, {5420, 5428}, {5599, 5599}};
  return std::any_of(std::begin(kRead), std::end(kRead),
                     [number](const Range& of) { return number >= of.first && number <= of.last; });
}

void ExpressionReader::push_load(std::int64_t number) {
  const VariablePlace place = to_.code().place(number);
  if (place.is_local() && of_caller_)
    return emit(Ins::Local, static_cast<double>(number),
                static_cast<std::uint32_t>(callers_locals(to_) + number));
  ngc_push_load(to_, line_, number);
}

std::int32_t callers_locals(Builder& to) {
  return to.names().hidden("variables of the caller", kLastLocal + 1);
}

bool ExpressionReader::of_caller(Value& value) {
  of_caller_ = true;
  const bool read = bracketed(value);
  of_caller_ = false;
  return read;
}

bool ExpressionReader::push_built_in(const std::string& name) {
  if (const int place = returned_place(name); place >= 0) {
    emit(Ins::Common, 0, static_cast<std::uint32_t>(to_.names().returned() + place));
    return true;
  }
  const BuiltIn* found = find_built_in(name);
  if (found == nullptr) return false;
  ngc_push_built_in(to_, line_, *found);
  return true;
}

bool ExpressionReader::read_variable(int depth) {
  if (line_.peek() == '<') return read_named();
  const std::size_t place = line_.place();
  const std::uint32_t first = to_.expressions().next();
  if (!read_value(depth)) return false;
  if (!constant_) {
    const std::uint32_t at = line_.offset(place - 1);  // of the #
    if (of_caller_)
      return wrong(Cause::CodeNotComputed, "the number of a caller's variable is not computed",
                   place);
    to_.expressions().emit({Ins::VariableNumber, 0, at, static_cast<double>(kLastVariable)});
    to_.expressions().emit({Ins::Indirect, 0, at, 0});
    return true;
  }
  const auto whole = nearly_whole(*constant_);
  if (!whole) return wrong(Cause::WholeNumberExpected, "the number of a variable is whole", place);
  const auto number = to_whole<std::int64_t>(*whole);
  if (!has_variable(number) && !to_.code().can_name(number, 0))
    return wrong(Cause::IllegalVariable, no_variable(to_.control(), "#", number), place);
  constant_.reset();
  to_.expressions().rollback(first);
  push_load(number);
  return true;
}

/// Read a name: <name>.
bool ExpressionReader::read_name(std::string& name) {
  const std::size_t place = line_.place();
  line_.take('<');
  if (!line_.take_up_to('>', name) || name.size() > kLongestName)
    return wrong(Cause::IllegalVariableName, "a name has at most 30 characters, and ends with >",
                 place);
  return true;
}

bool ExpressionReader::read_named() {
  const std::size_t place = line_.place();
  std::string name;
  if (!read_name(name)) return false;
  if (name.empty() || name == "_")
    return wrong(Cause::VariableNameUnknown, "a variable has a name", place);
  constant_.reset();
  if (push_built_in(name)) return true;
  if (tells_of_machine(name))
    return wrong(Cause::CodeNotComputed,
                 "#<" + name + "> depends on the machine, which cncsub does not have", place);
  if (const auto here = set_here_.find(name); here != set_here_.end()) {
    if (here->second.computed)
      return wrong(Cause::CodeNotComputed,
                   "a named variable that its own line computes and reads is not computed", place);
    constant_ = here->second.number;
    emit(Ins::Constant, *constant_);
    return true;
  }
  if (of_caller_ && !name.starts_with('_'))
    return wrong(Cause::CodeNotComputed,
                 "a value that is given back is computed with the caller's variables: #<" + name +
                     "> is not known here",
                 place);
  const std::uint32_t at = ngc_named(to_, name);
  const NamedVariable& variable = to_.code().named_variables[at];
  emit(variable.common ? Ins::NamedCommon : Ins::NamedLocal, at,
       static_cast<std::uint32_t>(variable.index));
  return true;
}

/// Read EXISTS[#<name>].
bool ExpressionReader::read_exists() {
  const std::size_t place = line_.place();
  std::string name;
  if (!line_.take("[#") || line_.peek() != '<')
    return wrong(Cause::BracketNotClosed, "EXISTS asks for a name: EXISTS[#<name>]", place);
  if (!read_name(name)) return false;
  if (!line_.take(']'))
    return wrong(Cause::BracketNotClosed, "EXISTS asks for a name: EXISTS[#<name>]", place);
  constant_.reset();
  if (find_built_in(name) != nullptr || tells_of_machine(name) || set_here_.contains(name)) {
    emit(Ins::Constant, 1);
    return true;
  }
  const int returned = returned_place(name);
  if (returned >= 0) {
    emit(Ins::CommonRaw, 0, static_cast<std::uint32_t>(to_.names().returned() + returned));
  } else {
    ngc_push_raw(to_, line_, name);
  }
  emit(Ins::IsSet);
  return true;
}

bool ExpressionReader::place(Place& place) {
  if (line_.peek() == '<') return named_place(place);
  const std::size_t start = line_.place();
  const std::uint32_t at = line_.offset();
  to_.expressions().begin();
  if (!read_value(0)) return false;
  if (!constant_) {
    emit(Ins::Floor);
    emit(Ins::VariableNumber, static_cast<double>(kLastWritten));
    place.target = Statement::Target::Indirect;
    place.number = to_.expressions().end(at, line_.width_from(at));
    return true;
  }
  const auto number = to_whole<std::int64_t>(std::clamp(std::trunc(*constant_), -1.0, 1e6));
  if (number < 1 || number > kLastWritten) {
    const Cause cause =
        has_variable(number) ? Cause::VariableWriteProtected : Cause::IllegalVariable;
    return wrong(cause, "programs write #1 to #5060", start);
  }
  ngc_assign_to(to_, number, place);
  return true;
}

bool ExpressionReader::named_place(Place& place) {
  const std::size_t start = line_.place();
  if (!read_name(place.name)) return false;
  if (place.name.empty() || place.name == "_")
    return wrong(Cause::VariableNameUnknown, "a variable has a name", start);
  if (find_built_in(place.name) != nullptr || tells_of_machine(place.name)) return true;
  if (const int returned = returned_place(place.name); returned >= 0) {
    place.target = Statement::Target::Common;
    place.index = to_.names().returned() + returned;
    return true;
  }
  const NamedVariable& variable = ngc_variable(to_, place.name);
  place.target = variable.common ? Statement::Target::Common : Statement::Target::Local;
  place.index = variable.index;
  return true;
}

bool ExpressionReader::shown(Value& value) {
  const std::uint32_t at = line_.offset();
  to_.expressions().begin();
  constant_.reset();
  if (std::string name; line_.peek() == '<') {
    if (!read_name(name)) return false;
    if (tells_of_machine(name)) return false;
    if (!push_built_in(name)) ngc_push_raw(to_, line_, name);
    return finish(value, at);
  }
  const std::string_view digits = line_.take_digits();
  std::int64_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (digits.size() > 9 || !has_variable(number))
    emit(Ins::Constant, kVacant);
  else
    push_load(number);
  return finish(value, at);
}

}  // namespace cncsub::grblhal
