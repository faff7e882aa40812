#include "cncsub/dialect/linuxcnc/expression.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "cncsub/control/variable_table.hpp"
#include "cncsub/dialect/linuxcnc/built_in.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub::linuxcnc {

namespace {

constexpr int kDeepest = 200;  // values inside each other, more than a line has room for

struct Function {
  std::string_view name;
  Ins op;
};
constexpr std::array<Function, 12> kFunctions = {{{"abs", Ins::Abs},
                                                  {"acos", Ins::ArcCosineOf},
                                                  {"asin", Ins::ArcSineOf},
                                                  {"cos", Ins::CosineOf},
                                                  {"fix", Ins::Floor},
                                                  {"fup", Ins::Ceil},
                                                  {"ln", Ins::Ln},
                                                  {"round", Ins::Round},
                                                  {"sin", Ins::SineOf},
                                                  {"sqrt", Ins::Sqrt},
                                                  {"tan", Ins::TangentOf},
                                                  {"exp", Ins::Raise}}};

struct OperatorName {
  std::string_view name;
  Ins op;
  int strength;
};
// `**` before `*`. All bind to the left, powers too.
constexpr std::array<OperatorName, 16> kOperators = {{{"**", Ins::Raise, 5},
                                                      {"*", Ins::Multiply, 4},
                                                      {"/", Ins::Divide, 4},
                                                      {"mod", Ins::PositiveModulo, 4},
                                                      {"+", Ins::Add, 3},
                                                      {"-", Ins::Subtract, 3},
                                                      {"eq", Ins::NearlyEqual, 2},
                                                      {"ne", Ins::NearlyNotEqual, 2},
                                                      {"ge", Ins::GreaterEqual, 2},
                                                      {"gt", Ins::Greater, 2},
                                                      {"le", Ins::LessEqual, 2},
                                                      {"lt", Ins::Less, 2},
                                                      {"and", Ins::BothTrue, 1},
                                                      {"or", Ins::EitherTrue, 1},
                                                      {"xor", Ins::OneTrue, 1},
                                                      {"]", Ins::End, 0}}};

}  // namespace

bool is_read_only(std::int64_t number) {
  return (number >= 5400 && number <= 5413) || (number >= 5420 && number <= 5428);
}

bool ExpressionReader::wrong(Cause cause, std::string text, std::size_t place) {
  const std::uint32_t at = line_.offset(place);
  Fault found{.cause = cause, .at = at, .width = line_.width_from(at), .detail = text};
  found.text = std::move(text);
  fault = std::move(found);
  return false;
}

void ExpressionReader::emit(Ins op, double value, std::uint32_t index) {
  const bool indexed = op == Ins::Local || op == Ins::LocalRaw || op == Ins::Common ||
                       op == Ins::CommonRaw || op == Ins::NamedLocal || op == Ins::NamedCommon;
  to_.expressions().emit({op, 0, indexed ? index : line_.offset(), value});
}

std::optional<double> ExpressionReader::whole_number(double value, std::size_t place) {
  const auto whole = nearly_whole(value);
  if (!whole) wrong(Cause::WholeNumberExpected, "Non integer value for integer", place);
  return whole;
}

std::optional<std::int64_t> ExpressionReader::variable_number(std::size_t place) {
  const auto whole = whole_number(constant_.value_or(0), place);
  if (!whole) return std::nullopt;
  const auto number = to_whole<std::int64_t>(*whole);
  if (to_.code().can_name(number, kLastVariable)) return number;
  wrong(Cause::IllegalVariable, "Parameter number out of range", place);
  if (fault) fault->detail = no_variable(to_.control(), number);
  return std::nullopt;
}

void ExpressionReader::emit_load(std::int64_t number) {
  const VariablePlace place = to_.code().place(number);
  const Ins load = place.is_local() ? Ins::Local : place.is_common() ? Ins::Common : Ins::Variable;
  emit(load, static_cast<double>(number), static_cast<std::uint32_t>(place.index));
}

/// The variable of a name, vacant where it is not set.
void ExpressionReader::emit_raw(const std::string& name) {
  const NamedVariable& variable = to_.code().named_variables[named(name)];
  emit(variable.common ? Ins::CommonRaw : Ins::LocalRaw, 0,
       static_cast<std::uint32_t>(variable.index));
}

/// The place of a name among Code::named_variables.
std::uint32_t ExpressionReader::named(const std::string& name) {
  return to_.names().variable(name, name.starts_with('_'));
}

bool ExpressionReader::finish(Value& value, std::uint32_t first, std::uint32_t at) {
  value.at = at;
  value.width = line_.width_from(at);
  value.computed = !constant_;
  value.number = constant_.value_or(0);
  if (value.computed)
    value.expression = to_.expressions().end(first, at, value.width);
  else
    to_.expressions().take_back(first);
  return true;
}

std::uint32_t ExpressionReader::expression_of(const Value& value) {
  if (value.computed) return value.expression;
  return to_.expressions().one({Ins::Constant, 0, value.at, value.number}, value.at, value.width);
}

bool ExpressionReader::value(Value& value) {
  const std::uint32_t first = to_.expressions().next(), at = line_.offset();
  return read_value(0) && finish(value, first, at);
}

bool ExpressionReader::bracketed(Value& value) {
  const std::uint32_t first = to_.expressions().next(), at = line_.offset();
  return read_bracket(0) && finish(value, first, at);
}

bool ExpressionReader::whole(Value& value) {
  const std::uint32_t first = to_.expressions().next(), at = line_.offset();
  const std::size_t place = line_.place();
  if (!read_value(0)) return false;
  if (constant_) {
    constant_ = whole_number(*constant_, place);
    if (!constant_) return false;
  } else {
    emit(Ins::WholeNumber);
  }
  return finish(value, first, at);
}

bool ExpressionReader::read_value(int depth) {
  const std::size_t place = line_.place();
  if (depth > kDeepest) return wrong(Cause::BracketsTooDeep, "Command too long", place);
  const char c = line_.peek(), next = line_.peek(1);
  if (c == '\0')
    return wrong(Cause::AddressWithoutValue, "No characters found in reading real value", place);
  if (c == '[') return read_bracket(depth + 1);
  if (c == '#') {
    line_.take();
    return read_variable(depth + 1);
  }
  if ((c == '+' || c == '-') && next != '\0' && !is_digit(next) && next != '.') {
    line_.take();
    if (!read_value(depth + 1)) return false;
    if (c == '+') return true;
    if (constant_) constant_ = -*constant_;
    emit(Ins::Negate);
    return true;
  }
  if (c >= 'a' && c <= 'z') return read_function(depth + 1);
  return read_number();
}

bool ExpressionReader::read_number() {
  const std::size_t place = line_.place();
  const std::string_view signs = line_.take_all("+-");
  const std::string_view digits = line_.take_all("0123456789.");
  const char* const end = digits.end();
  double number = 0;
  const auto read = std::from_chars(digits.begin(), end, number, std::chars_format::fixed);
  const std::string text = std::string(signs) + std::string(digits);
  if (signs.size() > 1 || read.ec != std::errc())
    return wrong(Cause::ExpressionFormat,
                 "bad number format (conversion failed) parsing '" + text + "'", place);
  if (read.ptr != end)
    return wrong(Cause::IllegalDecimalPoint,
                 "bad number format (trailing characters) parsing '" + text + "'", place);
  constant_ = signs == "-" ? -number : number;
  emit(Ins::Constant, *constant_);
  return true;
}

bool ExpressionReader::read_operator(Operator& found) {
  const std::size_t place = line_.place();
  for (const OperatorName& of : kOperators)
    if (line_.take(of.name)) {
      found = {of.op, of.strength};
      return true;
    }
  const char c = line_.peek();
  if (c == '\0') return wrong(Cause::BracketNotClosed, "Unclosed expression", place);
  line_.take();
  const bool begins = std::string_view("amoxengl").find(c) != std::string_view::npos;
  return wrong(
      Cause::ExpressionFormat,
      begins ? std::string("Unknown operation name starting with ") + c : "Unknown operation",
      place);
}

/// Operators wait for their second value until one comes that does not bind closer.
bool ExpressionReader::read_bracket(int depth) {
  line_.take('[');
  if (!read_value(depth)) return false;
  std::vector<Operator> waiting;
  for (;;) {
    Operator next;
    if (!read_operator(next)) return false;
    while (!waiting.empty() && waiting.back().strength >= next.strength) {
      emit(waiting.back().op);
      waiting.pop_back();
      constant_.reset();
    }
    if (next.strength == 0) return true;
    waiting.push_back(next);
    if (!read_value(depth)) return false;
    constant_.reset();
  }
}

bool ExpressionReader::read_variable(int depth) {
  if (line_.peek() == '<') return read_named();
  const std::size_t place = line_.place();
  const std::uint32_t first = to_.expressions().next();
  if (!read_value(depth)) return false;
  if (!constant_) {
    emit(Ins::VariableNumber, static_cast<double>(kLastVariable));
    emit(Ins::Indirect);
    return true;
  }
  const auto number = variable_number(place);
  if (!number) return false;
  constant_.reset();
  to_.expressions().take_back(first);
  emit_load(*number);
  return true;
}

bool ExpressionReader::built_in(const std::string& name) {
  const BuiltIn* found = find_built_in(name);
  if (found == nullptr) return false;
  for (const BuiltIn::Step& step : found->steps) {
    if (step.op == Ins::End) break;
    if (step.op == Ins::Common)
      emit(Ins::Common, 0,
           static_cast<std::uint32_t>(to_.names().returned() + to_whole<int>(step.value)));
    else
      emit(step.op, step.value);
  }
  return true;
}

/// <name>
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
  if (built_in(name)) return true;
  if (tells_of_machine(name))
    return wrong(Cause::CodeNotComputed, "#<" + name + "> tells of a machine", place);
  const std::uint32_t at = named(name);
  const NamedVariable& variable = to_.code().named_variables[at];
  const auto index = static_cast<std::uint32_t>(variable.index);
  if (set_here_.contains(name))
    emit(variable.common ? Ins::Common : Ins::Local, 0, index);
  else
    emit(variable.common ? Ins::NamedCommon : Ins::NamedLocal, at, index);
  return true;
}

bool ExpressionReader::read_function(int depth) {
  const std::size_t place = line_.place();
  if (line_.take("atan")) return read_arctangent(depth);
  if (line_.take("exists")) return read_exists(depth);
  for (const Function& function : kFunctions) {
    if (!line_.take(function.name)) continue;
    if (line_.peek() != '[')
      return wrong(Cause::ExpressionFormat, "Left bracket missing after unary operation name",
                   place);
    const bool power = function.op == Ins::Raise;  // of e
    if (power) emit(Ins::Constant, 2.71828182845904523536);
    if (!read_bracket(depth)) return false;
    constant_.reset();
    emit(function.op);
    return true;
  }
  const char c = line_.take();
  const bool begins = std::string_view("aceflrst").find(c) != std::string_view::npos;
  return wrong(Cause::ExpressionFormat,
               begins ? std::string("Unknown word starting with ") + c
                      : "Unknown word where unary operation could be",
               place);
}

bool ExpressionReader::read_arctangent(int depth) {
  const std::size_t place = line_.place();
  const auto bracket_missing = [&](const char* text) {
    return wrong(Cause::ExpressionFormat, text, place);
  };
  if (line_.peek() != '[')
    return bracket_missing("Left bracket missing after unary operation name");
  if (!read_bracket(depth)) return false;
  if (!line_.take('/')) return bracket_missing("Slash missing after first atan argument");
  if (line_.peek() != '[')
    return bracket_missing("Left bracket missing after slash with atan operator");
  if (!read_bracket(depth)) return false;
  constant_.reset();
  emit(Ins::ArcTangentOf);
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
      emit_raw(name);
      emit(Ins::IsSet);
    }
  } else {
    if (!read_value(depth)) return false;
    constant_.reset();
    emit(Ins::WholeNumber);  // of a number: whether there is a variable of this number
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
  const std::uint32_t first = to_.expressions().next(), at = line_.offset();
  if (!read_value(0)) return false;
  if (!constant_) {
    emit(Ins::VariableNumber, static_cast<double>(kLastVariable));
    place.target = Statement::Target::Indirect;
    place.number = to_.expressions().end(first, at, line_.width_from(at));
    return true;
  }
  to_.expressions().take_back(first);
  const auto number = variable_number(start);
  if (!number) return false;
  if (is_read_only(*number))
    return wrong(Cause::VariableWriteProtected, "Parameter is readonly", start);
  const VariablePlace where = to_.code().place(*number);
  place.target = where.is_local()    ? Statement::Target::Local
                 : where.is_common() ? Statement::Target::Common
                                     : Statement::Target::Variable;
  place.index = place.target == Statement::Target::Variable ? static_cast<std::int32_t>(*number)
                                                            : where.index;
  return true;
}

bool ExpressionReader::named_place(Place& place) {
  const std::size_t start = line_.place();
  std::string name;
  if (!read_name(name, start)) return false;
  if (is_read_only(name))
    return wrong(Cause::VariableWriteProtected,
                 "Cannot assign to read-only parameter #<" + name + ">", start);
  const NamedVariable& variable = to_.code().named_variables[named(name)];
  place.target = variable.common ? Statement::Target::Common : Statement::Target::Local;
  place.index = variable.index;
  set_here_.insert(name);
  return true;
}

bool ExpressionReader::shown(Value& value) {
  const std::uint32_t first = to_.expressions().next(), at = line_.offset();
  constant_.reset();
  if (std::string name; line_.peek() == '<') {
    if (!read_name(name, line_.place())) return false;
    if (!built_in(name)) emit_raw(name);
    return finish(value, first, at);
  }
  const std::string_view digits = line_.take_digits();
  std::int64_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (digits.size() > 9 || !to_.code().can_name(number, kLastVariable))
    emit(Ins::Constant, digits.size() <= 9 && number == 0 ? 0 : kVacant);
  else
    emit_load(number);
  return finish(value, first, at);
}

}  // namespace cncsub::linuxcnc
