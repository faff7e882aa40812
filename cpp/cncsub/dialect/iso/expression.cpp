// Expressions of the ISO family: what a word, a statement and a bracket hold, variables and
// numbers.
//
// They are read in one loop: what is opened, a sign or an operator waits on a stack for its value.
#include "cncsub/dialect/iso/expression.hpp"

#include <array>
#include <span>

#include "cncsub/system/compiler.hpp"

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
  if (any && value.type == Value::Type::Number) {  // WHILE TRUE
    out_.arithmetic(value, s.offset());
    value.type = Value::Type::Condition;
  }
  if (value.type != Value::Type::Condition)
    return out_.refuse(Cause::ExpressionFormat, at, "a condition compares two values");
  return out_.finish(first, at, s.offset() - at);
}

// ---- operands ----

inline Value ExpressionReader::constant(const char*& at) {
  const char* end = at;
  const Mantissa m = scan_mantissa(end);
  const std::ptrdiff_t digits = m.whole + m.decimals;
  if (digits == 0 || digits > rules_.most_digits || !ends_at(end)) return {};
  const std::uint32_t place = offset(at);
  if (!out_.has_room(offset(end))) return {};
  at = end;
  const auto whole = static_cast<double>(static_cast<std::int64_t>(m.value));
  out_.emit(Ins::Constant, place, whole / kPowersOfTen[m.decimals]);
  return Value::number();
}

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

/// A variable whose number is digits and nothing else, and which lies near; else nothing.
inline Value ExpressionReader::near_variable(const char*& at) {
  const char* end = at + 1;
  const auto number = plain_number(end);
  const ExpressionRules::Near* const near = number ? rules_.near(*number) : nullptr;
  if (near == nullptr || !out_.has_room(offset(at + 1))) return {};
  at = end;
  return out_.load(*near, *number);
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

/// An operand; what is opened before it, and signs, wait.
inline Value ExpressionReader::operand(const char*& at) {
  for (;;) {
    Value value{};
    const char c = *at;
    if (c == '#')
      value = near_variable(at);
    else if (is_digit(c) || c == '.')
      value = constant(at);
    if (value) return value;
    s_->at = at;
    value = other_operand();
    at = s_->at;
    if (value.type != Value::Type::Awaited) return value;
  }
}

// ---- what waits ----

/// What is read next is the value of what waits.
Value ExpressionReader::wait(Waiting::Kind kind, std::uint32_t at, const FunctionName* function) {
  Waiting& waiting = *last_++;
  const bool prefix = kind <= Waiting::Kind::Not;
  waiting.level = prefix ? Waiting::kPrefix : Waiting::kOpening;
  waiting.kind = kind;
  waiting.at = at;
  waiting.first = out_.first();
  waiting.function = function;
  waiting.second = false;
  return Value::awaited();
}

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

/// What ends here gives its value to what was opened: the value of that, or another argument comes.
Value ExpressionReader::closed(Value value) {
  Waiting& of = last_[-1];
  const bool argument = of.kind >= Waiting::Kind::Function;
  if (argument && of.kind != Waiting::Kind::SecondArgument) {
    if (!out_.arithmetic(value, s_->offset())) return {};
    if (another_argument(of)) return Value::awaited();
    if (of.function->one == Ins::End && !of.second)
      return out_.refuse(Cause::MissingComma, s_->offset(), "the function takes two arguments");
  }
  if (!closes()) return {};
  --last_;
  switch (of.kind) {
    case Waiting::Kind::Indirect:
      if (!out_.arithmetic(value, s_->offset())) return {};
      out_.emit(Ins::IndirectRaw, of.at);
      return out_.last();
    case Waiting::Kind::Function:
      return function(of);
    case Waiting::Kind::ArcTangent:
      return arc_tangent(of);
    case Waiting::Kind::SecondArgument:
      if (!out_.arithmetic(value, s_->offset())) return {};
      out_.emit(Ins::Atan2, of.at);
      return Value::number();
    default:
      return value;
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

/// The signs of arithmetic by their character.
constexpr auto kSigns = [] {
  std::array<const OperatorName*, 256> signs{};
  for (const OperatorName& of : kArithmetic) signs[static_cast<unsigned char>(of.text[0])] = &of;
  return signs;
}();

/// The operator that stands here, null where none does.
inline const OperatorName* next_operator(const ExpressionRules& rules, Scanner& s,
                                         const char*& at) {
  if (at == s.end) return nullptr;
  if (const OperatorName* const sign = kSigns[static_cast<unsigned char>(*at)]) return sign;
  if (*at == ']') return nullptr;
  s.at = at;
  s.blanks();
  at = s.at;
  if (at == s.end) return nullptr;
  const OperatorName* const sign = kSigns[static_cast<unsigned char>(*at)];
  return sign != nullptr ? sign : find_other_operator(rules, s);
}

}  // namespace

/// Joins a value with what waits on its left and binds as closely.
inline Value ExpressionReader::join(Value value, int level, const char* at) {
  while (value && last_[-1].level >= level)
    value = apply(out_, *--last_, value, offset(at));
  return value;
}

/// An operator stands behind the value: both wait for what comes.
inline Value ExpressionReader::operates(const OperatorName& of, Value value, const char*& at) {
  int level = level_of(rules_, of);
  if (rules_.numbers_first && of.is_logic()) {
    value = join(value, of.alike + 1, at);
    s_->at = at;
    if (is_of_numbers(of, value)) level = of.alike + 1;
  }
  value = join(value, level, at);
  if (!value) return value;
  Waiting& waiting = *last_++;
  waiting.left = value;
  waiting.of = &of;
  waiting.at = offset(at);
  waiting.level = level;
  waiting.kind = Waiting::Kind::Operator;
  if (of.text.size() == 1) {
    ++at;
  } else {
    s_->at = at;
    s_->take_word(of.text);
    at = s_->at;
  }
  return Value::awaited();
}

bool ExpressionReader::is_of_numbers(const OperatorName& of, const Value& value) const {
  const Waiting* first = last_;
  while (first[-1].level > Waiting::kOpening) --first;
  return cncsub::is_of_numbers(*s_, of, value, {first, last_});
}

/// What stands behind an operand: the whole value, or an operand is awaited.
inline Value ExpressionReader::behind(Value value, const Waiting* base, bool alone,
                                      const char*& at) {
  for (;;) {
    if (last_[-1].level == Waiting::kPrefix) {
      s_->at = at;
      value = prefixed(value);
    }
    if (!value || (alone && last_ == base)) return value;
    if (const OperatorName* const next = next_operator(rules_, *s_, at))
      return operates(*next, value, at);
    value = join(value, 0, at);
    if (!value || last_ == base) return value;
    if (last_[-1].kind == Waiting::Kind::Bracket && *at == ']' && at != s_->end) {
      ++at;
      --last_;
      --brackets_;
      continue;
    }
    s_->at = at;
    value = closed(value);
    at = s_->at;
    if (value.type == Value::Type::Awaited) return value;
  }
}

/// Reads until what waits above `base` has its value; `alone`: no operator behind that is read.
Value ExpressionReader::values(const Waiting* base, bool alone) {
  const char* at = s_->at;
  Value value{};
  do {
    value = operand(at);
    if (value) value = behind(value, base, alone, at);
  } while (value.type == Value::Type::Awaited);
  s_->at = at;
  return value;
}

/// What stands in brackets.
Value ExpressionReader::bracket() {
  const Waiting* const base = last_;
  const Value inner = open(Waiting::Kind::Bracket, s_->offset());
  return inner.type == Value::Type::Awaited ? values(base, true) : inner;
}

}  // namespace cncsub
