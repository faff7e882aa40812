// Expressions of the ISO family: what a word, a statement and a bracket hold, variables and
// numbers.
#include "cncsub/dialect/iso/expression.hpp"

#include "cncsub/dialect/iso/operators.hpp"
#include "cncsub/system/compiler.hpp"

namespace cncsub {

namespace {

constexpr std::int64_t kComputed = -1;
constexpr std::ptrdiff_t kMostVariableDigits = 9;
constexpr const char* kNoVariable = "behind # stands a number, or an expression in brackets";

bool starts_name(Scanner& s) { return is_letter(s.peek()) || s.peek() == '_'; }

/// Whether a number that was read as far as `at` ends there for certain: it may go on behind a gap
/// and with another point.
bool number_ends(const Scanner& s, const char* at) {
  return at == s.end || (at < s.end && !begins_gap(*at) && *at != '.');
}

/// The number behind the #, where it is digits and nothing else.
inline std::optional<std::uint32_t> plain_number(const ExpressionRules& rules, Scanner& s) {
  const char* at = s.at;
  std::uint32_t number = 0;
  for (; is_digit(*at); ++at) number = number * 10 + static_cast<std::uint32_t>(*at - '0');
  const std::ptrdiff_t digits = at - s.at;
  if (digits == 0 || digits > kMostVariableDigits || rules.indirect || !number_ends(s, at))
    return std::nullopt;
  s.at = at;
  return number;
}

}  // namespace

std::optional<std::uint32_t> ExpressionReader::number() {
  const auto first = out_.first();
  s_.blanks();
  const std::uint32_t at = s_.offset();
  Value value = expression();
  if (!value) return std::nullopt;
  if (!out_.is_number(value))
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
  const StatementKind kind = variable ? StatementKind::Variables : StatementKind::Brackets;
  if (rules_.code.lacking.test(static_cast<std::size_t>(kind))) {
    Fault wrong = rules_.code.lacking_fault(kind, at);
    return out_.refuse(wrong.cause, at, std::move(wrong.detail));
  }
  Value value = variable ? variable_value() : bracket();
  if (!value) return std::nullopt;
  if (!out_.is_number(value))
    return out_.refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  if (negative)
    out_.emit(Ins::Negate, at);  // of a vacant variable it stays vacant: X-#1 is no word then
  return out_.finish(first, at, s_.offset() - at);
}

std::optional<std::uint32_t> ExpressionReader::condition() {
  const auto first = out_.first();
  s_.blanks();
  const std::uint32_t at = s_.offset();
  if (!rules_.bare && s_.peek() != '[')
    return out_.refuse(Cause::ExpressionFormat, at, "a condition stands in brackets");
  Value value = rules_.bare ? expression() : bracket();
  if (!value) return std::nullopt;
  const int most = rules_.control.macros.max_condition_length.value;
  if (most > 0 && s_.offset() - at > static_cast<std::uint32_t>(most))
    return out_.refuse(Cause::ExpressionFormat, at,
                       "a condition has at most " + std::to_string(most) + " characters");
  const bool any = rules_.bare || rules_.values;
  if (any && value.type == Value::Type::Number) {  // WHILE TRUE
    out_.arithmetic(value, s_.offset());
    value.type = Value::Type::Condition;
  }
  if (value.type != Value::Type::Condition)
    return out_.refuse(Cause::ExpressionFormat, at, "a condition compares two values");
  return out_.finish(first, at, s_.offset() - at);
}

// ---- variables ----

std::optional<ExpressionReader::Variable> ExpressionReader::variable(std::uint32_t hash) {
  if (const auto number = plain_number(rules_, s_)) return Variable{*number, 0};
  const auto first = out_.first();
  const bool inside = s_.peek() == '[';
  const std::uint32_t at = inside ? s_.offset() : hash;
  const auto number = variable_number(at);
  if (!number) return std::nullopt;
  if (*number != kComputed) return Variable{*number, 0};
  return Variable{kComputed, out_.finish(first, at, inside ? s_.offset() - at : 1)};
}

inline Value ExpressionReader::variable_value() {
  s_.blanks();
  const std::uint32_t at = s_.offset();
  s_.take('#');
  if (!out_.has_room(s_.offset())) return {};
  if (const auto number = plain_number(rules_, s_)) {
    const ExpressionRules::Near* const near = rules_.near(*number);
    return near != nullptr ? out_.load(*near, *number) : out_.load(*number, at);
  }
  if (!is_digit(s_.peek()) && starts_name(s_) && !rules_.names)
    return out_.refuse(Cause::ExpressionFormat, at, kNoVariable);
  const auto number = variable_number(at);
  if (!number) return {};
  if (*number != kComputed) return out_.load(*number, at);
  out_.emit(Ins::IndirectRaw, at);
  return out_.last();
}

/// The number of a variable, where it is written behind the #; else kComputed, and instructions
/// give it.
std::optional<std::int64_t> ExpressionReader::variable_number(std::uint32_t at) {
  const char first = s_.peek();
  if (first == '[') {
    Value inner = bracket();
    if (!inner || !out_.arithmetic(inner, s_.offset())) return std::nullopt;
    return kComputed;
  }
  if (!is_digit(first) && starts_name(s_) && rules_.names) {
    out_.emit(Ins::Named, at, static_cast<double>(names_.text(s_.take_name())));
    return kComputed;
  }
  const auto number = written_number();
  if (!number || !rules_.indirect || *number < 9000 || *number > 9999) return number;
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
  const bool whole = number.points == 0 || (behind && rules_.points);
  if (!whole || number.digits > kMostVariableDigits)
    return out_.refuse(Cause::IllegalVariable, at, "a variable number is a whole number");
  return to_whole<std::int64_t>(number.value);
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
  if (brackets_ > rules_.most_brackets) {
    out_.refuse(
        Cause::BracketsTooDeep, at,
        "more than " + std::to_string(rules_.most_brackets) + " brackets inside each other");
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

Value ExpressionReader::bracket() {
  if (!open()) return {};
  const Value inner = expression();
  if (!inner || !close()) return {};
  return inner;
}

CNCSUB_ALWAYS_INLINE inline Value ExpressionReader::operand_here() {
  const char c = s_.peek();
  if (c == '#') return variable_value();
  if (c == '[') return bracket();
  if (c == '-' || c == '+') return sign();
  if (is_digit(c) || c == '.') return constant();
  if (is_letter(c)) return word();
  return no_operand();
}

Value ExpressionReader::operand() { return operand_here(); }

Value ExpressionReader::sign() {
  const std::uint32_t at = s_.offset();
  const auto first = out_.first();
  const bool negative = *s_.at++ == '-';
  const char next = s_.peek();
  if (next == '-' || next == '+')
    return out_.refuse(Cause::ExpressionFormat, s_.offset(), "two signs in a row");
  Value value = operand();
  if (!value || !out_.arithmetic(value, s_.offset())) return {};
  if (negative) out_.negate(first, at);
  return value;
}

inline Value ExpressionReader::constant() {
  const char* end = s_.at;
  const Mantissa m = scan_mantissa(end);
  const std::ptrdiff_t digits = m.whole + m.decimals;
  if (digits == 0 || digits > rules_.most_digits || !number_ends(s_, end)) return other_constant();
  const std::uint32_t at = s_.offset();
  s_.at = end;
  if (!out_.has_room(s_.offset())) return {};
  const auto whole = static_cast<double>(static_cast<std::int64_t>(m.value));
  out_.emit(Ins::Constant, at, whole / kPowersOfTen[m.decimals]);
  return Value::number();
}

/// A number with a gap in it, or one that is wrong.
Value ExpressionReader::other_constant() {
  const std::uint32_t at = s_.offset();
  const Number number = scan_number(s_);
  if (number.points > 1)
    return out_.refuse(Cause::IllegalDecimalPoint, at, "two points in one number");
  if (!number.any) return out_.refuse(Cause::ExpressionFormat, at, "a point is no number");
  const int most = rules_.control.macros.max_constant_digits.value;
  if (number.digits > static_cast<std::uint32_t>(most))
    return out_.refuse(Cause::TooManyDigits, at,
                       "a number has at most " + std::to_string(most) + " digits");
  if (!out_.has_room(s_.offset())) return {};
  out_.emit(Ins::Constant, at, number.value);
  return Value::number();
}

Refused ExpressionReader::no_operand() {
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

// ---- operators ----

namespace {

/// The level at which an operator binds, but for logic of numbers where that binds first.
int level_of(const ExpressionRules& rules, const OperatorName& of) {
  return rules.alike ? of.alike : of.last;
}

/// Joins two values; the left one waited for the right one.
inline Value apply(ValueWriter& out, const Waiting& waiting, Value right, std::uint32_t end) {
  if (!waiting.of->is_arithmetic()) return apply_other(out, waiting, right, end);
  Value left = waiting.left;
  if (!out.arithmetic(left, end) || !out.arithmetic(right, end)) return {};
  out.emit_operator(waiting.of->op, waiting.of->other, waiting.at);
  return Value::number();
}

/// The operator that stands here, null where none does.
inline const OperatorName* next_operator(const ExpressionRules& rules, Scanner& s) {
  s.blanks();
  if (s.at == s.end) return nullptr;
  switch (*s.at) {
    case ']':
      return nullptr;
    case '+':
      return &kArithmetic[0];
    case '-':
      return &kArithmetic[1];
    case '*':
      return &kArithmetic[2];
    case '/':
      return &kArithmetic[3];
    default:
      return find_other_operator(rules, s);
  }
}

}  // namespace

/// Operands and operators: a value waits with its operator until what stands on the right does not
/// bind closer.
Value ExpressionReader::expression() {
  Waiting waiting[kTightest + 1];  // NOLINT: up to `last`, looser ones first
  Waiting* last = waiting;
  const auto join = [&](Value value, int level) {  // with what waits and binds as closely
    while (value && last != waiting && last[-1].level >= level)
      value = apply(out_, *--last, value, s_.offset());
    return value;
  };
  for (;;) {
    Value value = operand_here();
    if (!value) return {};
    const OperatorName* const next = next_operator(rules_, s_);
    int level = next == nullptr ? 0 : level_of(rules_, *next);
    if (next != nullptr && rules_.numbers_first && next->is_logic()) {
      value = join(value, next->alike + 1);
      if (is_of_numbers(s_, *next, value, {waiting, last})) level = next->alike + 1;
    }
    value = join(value, level);
    if (!value || next == nullptr) return value;
    *last++ = {value, next, s_.offset(), level};
    if (next->text.size() == 1)
      ++s_.at;
    else
      s_.take_word(next->text);
  }
}

}  // namespace cncsub
