// Expressions of the ISO family: what a word, a statement and a bracket hold, variables and
// numbers.
#include "cncsub/dialect/iso/expression.hpp"

#include <algorithm>

#include "cncsub/dialect/iso/plain_expression.hpp"

namespace cncsub {

namespace {

// Whatever the control allows: brackets inside each other. What is inside is read by functions
// inside each other.
constexpr int kDeepestBrackets = 64;
constexpr std::int64_t kComputed = -1;
constexpr const char* kNoVariable = "behind # stands a number, or an expression in brackets";

bool starts_name(Scanner& s) { return is_letter(s.peek()) || s.peek() == '_'; }

Ins computed(Ins raw) {
  switch (raw) {
    case Ins::LocalRaw:
      return Ins::Local;
    case Ins::CommonRaw:
      return Ins::Common;
    case Ins::VariableRaw:
      return Ins::Variable;
    case Ins::IndirectRaw:
      return Ins::Indirect;
    default:
      return raw;
  }
}

}  // namespace

std::nullopt_t ExpressionReader::refuse(Cause cause, std::uint32_t at, std::string detail) {
  if (!failed_) fault_ = {cause, at, 1, std::move(detail)};
  failed_ = true;
  return std::nullopt;
}

void ExpressionReader::emit(Ins op, std::uint32_t at, double value) {
  to_.expressions().emit({op, static_cast<std::uint8_t>(address_), at, value});
  depth_ += stack_effect(op);
}

std::uint32_t ExpressionReader::finish(std::uint32_t first, std::uint32_t at, std::uint32_t width) {
  depth_ += stack_effect(Ins::End);
  return to_.expressions().end(first, at, width);
}

/// Whether one more value has room on the stack.
bool ExpressionReader::room() {
  if (depth_ < kDeepest) return true;
  refuse(Cause::BracketsTooDeep, s_.offset());
  return false;
}

/// A comparison leaves 1 or 0, which is a number where the control says so.
bool ExpressionReader::is_number(Value& value) const {
  if (value.type == Type::Condition &&
      code_.control->macros.conditions.value.has(Condition::Values))
    value.type = Type::Number;
  return value.type == Type::Number;
}

/// From here on the value is a number: a vacant variable counts as 0.
bool ExpressionReader::arithmetic(Value& value) {
  if (!is_number(value)) {
    refuse(Cause::ExpressionFormat, s_.offset(), "the result of a comparison is not a number");
    return false;
  }
  if (value.raw >= 0) {
    Instruction& load = to_.expressions().instruction(static_cast<std::size_t>(value.raw));
    if (load.op == Ins::Constant) load.value = 0;
    load.op = computed(load.op);
    value.raw = -1;
  }
  return true;
}

std::optional<std::uint32_t> ExpressionReader::number() {
  const auto first = to_.expressions().next();
  s_.blanks();
  const std::uint32_t at = s_.offset();
  auto value = take(plain_expression(code_, s_));
  if (!value) value = expression();
  if (!value) return std::nullopt;
  if (!is_number(*value))
    return refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  return finish(first, at, s_.offset() - at);
}

std::optional<std::uint32_t> ExpressionReader::word_value(char address) {
  address_ = address;
  const auto first = to_.expressions().next();
  s_.blanks();
  const std::uint32_t at = s_.offset();
  const bool negative = s_.take('-');
  if (!negative) s_.take('+');
  const bool variable = s_.peek() == '#';
  if (const auto wrong =
          code_.lacks(variable ? StatementKind::Variables : StatementKind::Brackets, at))
    return refuse(wrong->cause, at, wrong->detail);
  auto value = variable ? variable_value() : bracket();
  if (!value) return std::nullopt;
  if (!is_number(*value))
    return refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  if (negative)
    emit(Ins::Negate, at);  // of a vacant variable it stays vacant: X-#1 is no word then
  return finish(first, at, s_.offset() - at);
}

std::optional<std::uint32_t> ExpressionReader::condition() {
  const auto first = to_.expressions().next();
  s_.blanks();
  const std::uint32_t at = s_.offset();
  const bool bare = code_.control->macros.conditions.value.has(Condition::Bare);
  if (!bare && s_.peek() != '[')
    return refuse(Cause::ExpressionFormat, at, "a condition stands in brackets");
  auto value = bare ? expression() : bracket();
  if (!value) return std::nullopt;
  const int most = code_.control->macros.max_condition_length.value;
  if (most > 0 && s_.offset() - at > static_cast<std::uint32_t>(most))
    return refuse(Cause::ExpressionFormat, at,
                  "a condition has at most " + std::to_string(most) + " characters");
  const bool any = bare || code_.control->macros.conditions.value.has(Condition::Values);
  if (any && value->type == Type::Number) {  // WHILE TRUE
    arithmetic(*value);
    value->type = Type::Condition;
  }
  if (value->type != Type::Condition)
    return refuse(Cause::ExpressionFormat, at, "a condition compares two values");
  return finish(first, at, s_.offset() - at);
}

// ---- variables ----

std::optional<ExpressionReader::Variable> ExpressionReader::variable(std::uint32_t hash) {
  const auto first = to_.expressions().next();
  const bool inside = s_.peek() == '[';
  const std::uint32_t at = inside ? s_.offset() : hash;
  const auto number = variable_number(at);
  if (!number) return std::nullopt;
  if (*number != kComputed) return Variable{*number, 0};
  return Variable{kComputed, finish(first, at, inside ? s_.offset() - at : 1)};
}

std::optional<ExpressionReader::Value> ExpressionReader::variable_value() {
  s_.blanks();
  const std::uint32_t at = s_.offset();
  s_.take('#');
  if (!room()) return std::nullopt;
  if (auto plain = take(plain_variable(code_, s_, at))) return plain;
  if (!is_digit(s_.peek()) && starts_name(s_) && !takes(VariableForm::Names))
    return refuse(Cause::ExpressionFormat, at, kNoVariable);
  const auto number = variable_number(at);
  if (!number) return std::nullopt;
  if (*number == kComputed)
    emit(Ins::IndirectRaw, at);
  else
    load(*number, at);
  return last();
}

/// The number of a variable, where it is written behind the #; else kComputed, and instructions
/// give it.
std::optional<std::int64_t> ExpressionReader::variable_number(std::uint32_t at) {
  const char first = s_.peek();
  if (first == '[') {
    auto inner = bracket();
    if (!inner || !arithmetic(*inner)) return std::nullopt;
    return kComputed;
  }
  if (!is_digit(first) && starts_name(s_) && takes(VariableForm::Names)) {
    emit(Ins::Named, at, to_.names().text(s_.take_name()));
    return kComputed;
  }
  const auto number = written_number();
  const bool indirect =
      takes(VariableForm::Indirect) && number && *number >= 9000 && *number <= 9999;
  if (!indirect) return number;
  load(*number - 9000, at);
  Value inner = last();
  arithmetic(inner);
  return kComputed;
}

std::optional<std::int64_t> ExpressionReader::written_number() {
  const char c = s_.peek();
  const std::uint32_t at = s_.offset();
  if (!is_digit(c)) return refuse(Cause::ExpressionFormat, at, kNoVariable);
  const Number number = scan_number(s_);
  const bool behind = number.points == 1 && number.decimals == 0 && number.any;
  const bool whole = number.points == 0 || (behind && takes(VariableForm::Point));
  if (!whole || number.digits > 9)
    return refuse(Cause::IllegalVariable, at, "a variable number is a whole number");
  return to_whole<std::int64_t>(number.value);
}

/// What was read at once, if anything was.
std::optional<ExpressionReader::Value> ExpressionReader::take(
    const std::optional<PlainExpression>& plain) {
  if (!plain || depth_ + 2 > kDeepest) return std::nullopt;
  for (std::size_t i = 0; i < plain->count; ++i)
    emit(plain->steps[i].op, plain->steps[i].at, plain->steps[i].value);
  s_.at = plain->end;
  return plain->may_be_vacant() ? last() : Value{};
}

bool ExpressionReader::takes(VariableForm form) const {
  return code_.control->macros.variable_forms.value.has(form);
}

/// The value of a variable, which may be vacant.
void ExpressionReader::load(std::int64_t number, std::uint32_t at) {
  const VariablePlace place = code_.place(number);
  const auto written = static_cast<double>(number);
  if (place.range != nullptr && place.kind == VariableKind::Vacant)
    emit(Ins::Constant, at, kVacant);
  else if (place.is_local())
    emit(Ins::LocalRaw, static_cast<std::uint32_t>(place.index), written);
  else if (place.is_common())
    emit(Ins::CommonRaw, static_cast<std::uint32_t>(place.index), written);
  else
    emit(Ins::VariableRaw, at, written);
}

// ---- operands ----

bool ExpressionReader::open() {
  s_.blanks();
  const std::uint32_t at = s_.offset();
  if (!s_.take('[')) {
    refuse(Cause::BracketNotOpened, at, "an opening bracket is missing here");
    return false;
  }
  ++brackets_;
  const int most = std::min(code_.control->macros.max_brackets.value, kDeepestBrackets);
  if (brackets_ > most) {
    refuse(Cause::BracketsTooDeep, at,
           "more than " + std::to_string(most) + " brackets inside each other");
    return false;
  }
  return true;
}

bool ExpressionReader::close() {
  const char c = s_.peek();
  if (c != ']') {
    if (c == '\0')
      refuse(Cause::BracketNotClosed, s_.offset(), "a closing bracket is missing");
    else
      refuse(Cause::ExpressionFormat, s_.offset(),
             "an operator or a closing bracket is missing here");
    return false;
  }
  ++s_.at;
  --brackets_;
  return true;
}

std::optional<ExpressionReader::Value> ExpressionReader::bracket() {
  if (!open()) return std::nullopt;
  auto inner = take(plain_expression(code_, s_));
  if (!inner) inner = expression();
  if (!inner || !close()) return std::nullopt;
  return inner;
}

std::optional<ExpressionReader::Value> ExpressionReader::operand() {
  const char c = s_.peek();
  if (c == '#') return variable_value();
  if (c == '[') return bracket();
  if (c == '-' || c == '+') return sign();
  if (is_digit(c) || c == '.') return constant();
  if (is_letter(c)) return word();
  return no_operand();
}

std::optional<ExpressionReader::Value> ExpressionReader::sign() {
  const std::uint32_t at = s_.offset();
  const bool negative = *s_.at++ == '-';
  const char next = s_.peek();
  if (next == '-' || next == '+')
    return refuse(Cause::ExpressionFormat, s_.offset(), "two signs in a row");
  auto value = operand();
  if (!value || !arithmetic(*value)) return std::nullopt;
  if (negative) emit(Ins::Negate, at);
  return value;
}

std::optional<ExpressionReader::Value> ExpressionReader::constant() {
  const std::uint32_t at = s_.offset();
  const Number number = scan_number(s_);
  if (number.points > 1) return refuse(Cause::IllegalDecimalPoint, at, "two points in one number");
  if (!number.any) return refuse(Cause::ExpressionFormat, at, "a point is no number");
  const int most = code_.control->macros.max_constant_digits.value;
  if (number.digits > static_cast<std::uint32_t>(most))
    return refuse(Cause::TooManyDigits, at,
                  "a number has at most " + std::to_string(most) + " digits");
  if (!room()) return std::nullopt;
  emit(Ins::Constant, at, number.value);
  return Value{};
}

std::nullopt_t ExpressionReader::no_operand() {
  const bool inside = brackets_ > 0;
  const std::uint32_t at = s_.offset();
  switch (s_.peek()) {
    case ']':
      return refuse(inside ? Cause::ExpressionFormat : Cause::BracketNotOpened, at,
                    "a value is missing before the bracket");
    case '\0':
      return refuse(inside ? Cause::BracketNotClosed : Cause::ExpressionFormat, at,
                    "a value is missing at the end");
    default:
      return refuse(Cause::ExpressionFormat, at, "a value is missing here");
  }
}

}  // namespace cncsub
