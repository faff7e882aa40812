// Expressions of the ISO family: what a word, a statement and a bracket hold, variables and
// numbers.
//
// They are read in one loop: what is opened, a sign or an operator waits on a stack for its value.
#include "cncsub/dialect/iso/expression.hpp"

#include <array>

namespace cncsub {

namespace {

// Brackets, functions, signs and operators that wait at once: as many as ExpressionRules lets be
// open, each with an operator of every level, a sign before it, and NOT.
constexpr std::size_t kMostWaiting = 600;

enum class Begins : std::uint8_t { Nothing, Number, Variable, Bracket, Sign, Word };

/// What a character begins where an operand stands.
constexpr auto kBegins = [] {
  std::array<Begins, 256> begins{};
  const auto mark = [&](std::string_view characters, Begins what) {
    for (const char c : characters) begins[static_cast<unsigned char>(c)] = what;
  };
  for (unsigned char c = 'A'; c <= 'Z'; ++c) begins[c] = begins[c - 'A' + 'a'] = Begins::Word;
  mark("0123456789.", Begins::Number);
  mark("#", Begins::Variable);
  mark("[", Begins::Bracket);
  mark("+-", Begins::Sign);
  return begins;
}();

}  // namespace

ExpressionReader::ExpressionReader(Builder& to, const ExpressionRules& rules)
    : rules_(rules),
      names_(to.names()),
      out_(to, rules),
      waiting_(std::make_unique_for_overwrite<Waiting[]>(kMostWaiting)) {
  waiting_[0].level = Waiting::kOpening;  // nothing binds as loosely
}

std::optional<std::uint32_t> ExpressionReader::number(Scanner& s) {
  begin(s);
  const auto first = out_.first();
  s.blanks();
  const std::uint32_t at = s.offset();
  Value value = expression();
  if (!value) return std::nullopt;
  if (!out_.is_number(value))
    return out_.refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  return out_.finish(first, at, s.offset() - at);
}

std::optional<std::uint32_t> ExpressionReader::word_value(Scanner& s, char address) {
  begin(s, address);
  const auto first = out_.first();
  s.blanks();
  const std::uint32_t at = s.offset();
  const bool negative = s.take('-');
  if (!negative) s.take('+');
  const bool variable = s.peek() == '#';
  const StatementKind kind = variable ? StatementKind::Variables : StatementKind::Brackets;
  if (rules_.code.lacking.test(static_cast<std::size_t>(kind))) {
    Fault wrong = rules_.code.lacking_fault(kind, at);
    return out_.refuse(wrong.cause, at, std::move(wrong.detail));
  }
  Value value = variable ? operand_alone() : bracket();
  if (!value) return std::nullopt;
  if (!out_.is_number(value))
    return out_.refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  if (negative)
    out_.emit(Ins::Negate, at);  // of a vacant variable it stays vacant: X-#1 is no word then
  return out_.finish(first, at, s.offset() - at);
}

std::optional<std::uint32_t> ExpressionReader::condition(Scanner& s) {
  begin(s);
  const auto first = out_.first();
  s.blanks();
  const std::uint32_t at = s.offset();
  if (!rules_.bare && s.peek() != '[')
    return out_.refuse(Cause::ExpressionFormat, at, "a condition stands in brackets");
  Value value = rules_.bare ? expression() : bracket();
  if (!value) return std::nullopt;
  const int most = rules_.control.macros.max_condition_length.value;
  if (most > 0 && s.offset() - at > static_cast<std::uint32_t>(most))
    return out_.refuse(Cause::ExpressionFormat, at,
                       "a condition has at most " + std::to_string(most) + " characters");
  const bool any = rules_.bare || rules_.values;
  if (any && value.is_number()) {  // WHILE TRUE
    out_.arithmetic(value, s.offset());
    value = Value::condition();
  }
  if (!value.is_condition())
    return out_.refuse(Cause::ExpressionFormat, at, "a condition compares two values");
  return out_.finish(first, at, s.offset() - at);
}

// ---- operands ----

/// A number with a gap in it, or one that is wrong.
Value ExpressionReader::other_constant() {
  const std::uint32_t at = s_->offset();
  const Number number = scan_number(*s_);
  if (number.points > 1)
    return out_.refuse(Cause::IllegalDecimalPoint, at, "two points in one number");
  if (!number.any) return out_.refuse(Cause::ExpressionFormat, at, "a point is no number");
  const int most = rules_.control.macros.max_constant_digits.value;
  if (number.digits > static_cast<std::uint32_t>(most))
    return out_.refuse(Cause::TooManyDigits, at,
                       "a number has at most " + std::to_string(most) + " digits");
  if (!out_.has_room(s_->offset())) return {};
  out_.emit(Ins::Constant, at, number.value);
  return Value::number();
}

Value ExpressionReader::sign() {
  const std::uint32_t at = s_->offset();
  const bool negative = *s_->at++ == '-';
  const char next = s_->peek();
  if (next == '-' || next == '+')
    return out_.refuse(Cause::ExpressionFormat, s_->offset(), "two signs in a row");
  return wait(negative ? Waiting::Kind::Minus : Waiting::Kind::Plus, at);
}

Refused ExpressionReader::no_operand() {
  const bool inside = brackets_ > 0;
  const std::uint32_t at = s_->offset();
  switch (s_->peek()) {
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

/// What stands where an operand does, and is neither a plain number nor a variable that lies near.
Value ExpressionReader::other_operand() {
  if (s_->at != s_->end && begins_gap(*s_->at)) {
    s_->pass_gap();
    return s_->at == s_->end ? no_operand() : Value::awaited();
  }
  const std::uint32_t at = s_->offset();
  switch (s_->at == s_->end ? Begins::Nothing : kBegins[static_cast<unsigned char>(*s_->at)]) {
    case Begins::Number:
      return other_constant();
    case Begins::Variable:
      return other_variable();
    case Begins::Bracket:
      return open(Waiting::Kind::Bracket, at);
    case Begins::Sign:
      return sign();
    case Begins::Word:
      return word();
    default:
      return no_operand();
  }
}

// ---- what waits ----

/// The bracket that stands here opens what is at `at`.
Value ExpressionReader::open(Waiting::Kind kind, std::uint32_t at, const FunctionName* function) {
  return opens() ? wait(kind, at, function) : Value{};
}

bool ExpressionReader::opens() {
  s_->blanks();
  const std::uint32_t at = s_->offset();
  if (!s_->take('[')) {
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

bool ExpressionReader::closes() {
  const char c = s_->peek();
  if (c != ']') {
    if (c == '\0')
      out_.refuse(Cause::BracketNotClosed, s_->offset(), "a closing bracket is missing");
    else
      out_.refuse(Cause::ExpressionFormat, s_->offset(),
                  "an operator or a closing bracket is missing here");
    return false;
  }
  ++s_->at;
  --brackets_;
  return true;
}

/// Gives an operand to the signs before it, and to NOT.
Value ExpressionReader::prefixed(Value value) {
  while (value && last_[-1].level == Waiting::kPrefix) {
    const Waiting& prefix = *--last_;
    if (prefix.kind == Waiting::Kind::Not) {
      value = negated(prefix, value);
    } else {
      if (!out_.arithmetic(value, s_->offset())) return {};
      if (prefix.kind == Waiting::Kind::Minus) out_.negate(prefix.first, prefix.at);
    }
  }
  return value;
}

}  // namespace cncsub
