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

bool takes(const Code& code, VariableForm form) {
  return code.control->macros.variable_forms.value.has(form);
}

bool starts_name(Scanner& s) { return is_letter(s.peek()) || s.peek() == '_'; }

}  // namespace

std::optional<std::uint32_t> ExpressionReader::number() {
  const auto first = out_.first();
  s_.blanks();
  const std::uint32_t at = s_.offset();
  auto value = take(plain_expression(code_, s_));
  if (!value) value = take(plain_bracket(code_, s_));
  if (!value) value = expression();
  if (!value) return std::nullopt;
  if (!out_.is_number(*value))
    return out_.refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  return out_.finish(first, at, s_.offset() - at);
}

std::optional<std::uint32_t> ExpressionReader::word_value(char address) {
  out_.begin_word(address);
  const auto first = out_.first();
  s_.blanks();
  const std::uint32_t at = s_.offset();
  const bool negative = s_.take('-');
  if (!negative) s_.take('+');
  const bool variable = s_.peek() == '#';
  if (const auto wrong =
          code_.lacks(variable ? StatementKind::Variables : StatementKind::Brackets, at))
    return out_.refuse(wrong->cause, at, wrong->detail);
  auto value = variable ? variable_value() : bracket();
  if (!value) return std::nullopt;
  if (!out_.is_number(*value))
    return out_.refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  if (negative)
    out_.emit(Ins::Negate, at);  // of a vacant variable it stays vacant: X-#1 is no word then
  return out_.finish(first, at, s_.offset() - at);
}

std::optional<std::uint32_t> ExpressionReader::condition() {
  const auto first = out_.first();
  s_.blanks();
  const std::uint32_t at = s_.offset();
  const bool bare = code_.control->macros.conditions.value.has(Condition::Bare);
  if (!bare && s_.peek() != '[')
    return out_.refuse(Cause::ExpressionFormat, at, "a condition stands in brackets");
  auto value = bare ? expression() : bracket();
  if (!value) return std::nullopt;
  const int most = code_.control->macros.max_condition_length.value;
  if (most > 0 && s_.offset() - at > static_cast<std::uint32_t>(most))
    return out_.refuse(Cause::ExpressionFormat, at,
                       "a condition has at most " + std::to_string(most) + " characters");
  const bool any = bare || code_.control->macros.conditions.value.has(Condition::Values);
  if (any && value->type == Value::Type::Number) {  // WHILE TRUE
    out_.arithmetic(*value, s_.offset());
    value->type = Value::Type::Condition;
  }
  if (value->type != Value::Type::Condition)
    return out_.refuse(Cause::ExpressionFormat, at, "a condition compares two values");
  return out_.finish(first, at, s_.offset() - at);
}

// ---- variables ----

std::optional<ExpressionReader::Variable> ExpressionReader::variable(std::uint32_t hash) {
  const auto first = out_.first();
  const bool inside = s_.peek() == '[';
  const std::uint32_t at = inside ? s_.offset() : hash;
  const auto number = variable_number(at);
  if (!number) return std::nullopt;
  if (*number != kComputed) return Variable{*number, 0};
  return Variable{kComputed, out_.finish(first, at, inside ? s_.offset() - at : 1)};
}

std::optional<Value> ExpressionReader::variable_value() {
  s_.blanks();
  const std::uint32_t at = s_.offset();
  s_.take('#');
  if (!out_.has_room(s_.offset())) return std::nullopt;
  if (auto plain = take(plain_variable(code_, s_, at))) return plain;
  if (!is_digit(s_.peek()) && starts_name(s_) && !takes(code_, VariableForm::Names))
    return out_.refuse(Cause::ExpressionFormat, at, kNoVariable);
  const auto number = variable_number(at);
  if (!number) return std::nullopt;
  if (*number != kComputed) return out_.load(*number, at);
  out_.emit(Ins::IndirectRaw, at);
  return out_.last();
}

/// The number of a variable, where it is written behind the #; else kComputed, and instructions
/// give it.
std::optional<std::int64_t> ExpressionReader::variable_number(std::uint32_t at) {
  const char first = s_.peek();
  if (first == '[') {
    auto inner = bracket();
    if (!inner || !out_.arithmetic(*inner, s_.offset())) return std::nullopt;
    return kComputed;
  }
  if (!is_digit(first) && starts_name(s_) && takes(code_, VariableForm::Names)) {
    out_.emit(Ins::Named, at, names_.text(s_.take_name()));
    return kComputed;
  }
  const auto number = written_number();
  const bool indirect =
      takes(code_, VariableForm::Indirect) && number && *number >= 9000 && *number <= 9999;
  if (!indirect) return number;
  Value inner = out_.load(*number - 9000, at);
  out_.arithmetic(inner, s_.offset());
  return kComputed;
}

std::optional<std::int64_t> ExpressionReader::written_number() {
  const char c = s_.peek();
  const std::uint32_t at = s_.offset();
  if (!is_digit(c)) return out_.refuse(Cause::ExpressionFormat, at, kNoVariable);
  const Number number = scan_number(s_);
  const bool behind = number.points == 1 && number.decimals == 0 && number.any;
  const bool whole = number.points == 0 || (behind && takes(code_, VariableForm::Point));
  if (!whole || number.digits > 9)
    return out_.refuse(Cause::IllegalVariable, at, "a variable number is a whole number");
  return to_whole<std::int64_t>(number.value);
}

/// What was read at once, if anything was and it has room.
std::optional<Value> ExpressionReader::take(const std::optional<PlainExpression>& plain) {
  if (!plain) return std::nullopt;
  const auto value = out_.take(*plain);
  if (value) s_.at = plain->end;
  return value;
}

// ---- operands ----

bool ExpressionReader::open() {
  s_.blanks();
  const std::uint32_t at = s_.offset();
  if (!s_.take('[')) {
    out_.refuse(Cause::BracketNotOpened, at, "an opening bracket is missing here");
    return false;
  }
  ++brackets_;
  const int most = std::min(code_.control->macros.max_brackets.value, kDeepestBrackets);
  if (brackets_ > most) {
    out_.refuse(Cause::BracketsTooDeep, at,
                "more than " + std::to_string(most) + " brackets inside each other");
    return false;
  }
  return true;
}

bool ExpressionReader::close() {
  const char c = s_.peek();
  if (c != ']') {
    if (c == '\0')
      out_.refuse(Cause::BracketNotClosed, s_.offset(), "a closing bracket is missing");
    else
      out_.refuse(Cause::ExpressionFormat, s_.offset(),
                  "an operator or a closing bracket is missing here");
    return false;
  }
  ++s_.at;
  --brackets_;
  return true;
}

std::optional<Value> ExpressionReader::bracket() {
  if (!open()) return std::nullopt;
  auto inner = take(plain_expression(code_, s_));
  if (!inner) inner = expression();
  if (!inner || !close()) return std::nullopt;
  return inner;
}

std::optional<Value> ExpressionReader::operand() {
  const char c = s_.peek();
  if (c == '#') return variable_value();
  if (c == '[') return bracket();
  if (c == '-' || c == '+') return sign();
  if (is_digit(c) || c == '.') return constant();
  if (is_letter(c)) return word();
  return no_operand();
}

std::optional<Value> ExpressionReader::sign() {
  const std::uint32_t at = s_.offset();
  const auto first = out_.first();
  const bool negative = *s_.at++ == '-';
  const char next = s_.peek();
  if (next == '-' || next == '+')
    return out_.refuse(Cause::ExpressionFormat, s_.offset(), "two signs in a row");
  auto value = operand();
  if (!value || !out_.arithmetic(*value, s_.offset())) return std::nullopt;
  if (negative) out_.negate(first, at);
  return value;
}

std::optional<Value> ExpressionReader::constant() {
  const std::uint32_t at = s_.offset();
  const Number number = scan_number(s_);
  if (number.points > 1)
    return out_.refuse(Cause::IllegalDecimalPoint, at, "two points in one number");
  if (!number.any) return out_.refuse(Cause::ExpressionFormat, at, "a point is no number");
  const int most = code_.control->macros.max_constant_digits.value;
  if (number.digits > static_cast<std::uint32_t>(most))
    return out_.refuse(Cause::TooManyDigits, at,
                       "a number has at most " + std::to_string(most) + " digits");
  if (!out_.has_room(s_.offset())) return std::nullopt;
  out_.emit(Ins::Constant, at, number.value);
  return Value{};
}

std::nullopt_t ExpressionReader::no_operand() {
  const bool inside = brackets_ > 0;
  const std::uint32_t at = s_.offset();
  switch (s_.peek()) {
    case ']':
      return out_.refuse(inside ? Cause::ExpressionFormat : Cause::BracketNotOpened, at,
                         "a value is missing before the bracket");
    case '\0':
      return out_.refuse(inside ? Cause::BracketNotClosed : Cause::ExpressionFormat, at,
                         "a value is missing at the end");
    default:
      return out_.refuse(Cause::ExpressionFormat, at, "a value is missing here");
  }
}

}  // namespace cncsub
