// What a word, a statement and a bracket hold, and the operators between its values.
#include "cncsub/dialect/iso/expression.hpp"

#include <array>
#include <string>

namespace cncsub {

namespace {

/// How many characters a text has that begins where `s` stands, without the gap at its end.
std::ptrdiff_t length_of(Scanner s) {
  const char* const first = s.at;
  const char* last = first;
  while (s.peek() != '\0') last = ++s.at;
  return last - first;
}

/// Whether an operator of arithmetic or of logic stands here, and no slash before a word.
bool computes(const ExpressionRules& rules, const Scanner& s) {
  const IsoOperator* const of = find_operator(rules, s);
  if (of == nullptr || of->op != Ins::Divide) return of != nullptr && !of->compares();
  Scanner behind = s;
  behind.take('/');
  const char c = behind.peek();
  return c == '#' || c == '[' || begins_number(c);
}

/// The signs of arithmetic by their character.
constexpr auto kSigns = [] {
  std::array<const IsoOperator*, 256> signs{};
  for (const IsoOperator& of : kArithmetic) signs[static_cast<unsigned char>(of.spelling[0])] = &of;
  return signs;
}();

/// Operators of letters, by some bits of the first two.
constexpr std::size_t slot_of(char a, char b) {
  return (static_cast<std::size_t>(a) % 32) * 32 + static_cast<std::size_t>(b) % 32;
}
constexpr auto kByLetters = [] {
  std::array<const IsoOperator*, std::size_t{32} * 32> by_letters{};
  for (const IsoOperator& of : kNamedOperators)
    by_letters[slot_of(of.spelling[0], of.spelling[1])] = &of;
  return by_letters;
}();
/// The operator whose capitals begin at `at`, where three characters stand; null where none does.
const IsoOperator* named_operator(const char* at) {
  const IsoOperator* const of = kByLetters[slot_of(at[0], at[1])];
  if (of == nullptr || of->spelling[0] != at[0] || of->spelling[1] != at[1]) return nullptr;
  return of->spelling.size() == 2 || of->spelling[2] == at[2] ? of : nullptr;
}

}  // namespace

void ExpressionReader::pass_gap() {
  if (s_.at == s_.end) return;
  if (*s_.at == ' ' && !begins_gap(s_.at[1])) {
    ++s_.at;
    return;
  }
  comments_ = true;
  s_.pass_gap();
}

// ---- brackets ----

bool ExpressionReader::opens_behind_gap() {
  const bool here = peek() == '[';
  const std::uint32_t at = offset();
  if (!here) {
    out_.refuse(Cause::BracketNotOpened, at, "an opening bracket is missing here");
    return false;
  }
  ++s_.at;
  ++brackets_;
  if (brackets_ <= rules_.most_brackets) return true;
  out_.refuse(Cause::BracketsTooDeep, at,
              "more than " + std::to_string(rules_.most_brackets) + " brackets inside each other");
  return false;
}

/// What stands where brackets should close, behind a gap; the bracket is taken.
bool ExpressionReader::not_closed() {
  const char c = peek();
  if (c == ']') return closes();
  if (c == '\0')
    out_.refuse(Cause::BracketNotClosed, offset(), "a closing bracket is missing");
  else
    out_.refuse(Cause::ExpressionFormat, offset(),
                "an operator or a closing bracket is missing here");
  return false;
}

/// What stands in brackets.
Value ExpressionReader::bracket() {
  if (!opens()) return {};
  const Value value = values();
  return value && closes() ? value : Value{};
}

// ---- functions ----

/// A function whose name of capitals stands before its bracket; others are left to other_word.
CNCSUB_ALWAYS_INLINE inline Value ExpressionReader::word() {
  const std::uint32_t at = offset();
  int width = 0;
  const FunctionName* const of = rules_.function_at(s_.at, s_.end, width);
  if (of == nullptr || of->one == Ins::Programmed || s_.at + width > s_.end) [[unlikely]]
    return other_word();
  s_.at += width - 1;
  return arguments(*of, at);
}

/// The arguments of the function at `at` in their brackets, and what it makes of them.
Value ExpressionReader::arguments(const FunctionName& of, std::uint32_t at) {
  const bool slash = of.one == Ins::Atan && !rules_.has(Function::Atan2);
  bool second = false;
  if (!opens()) return {};
  for (;;) {
    Value value = values();
    if (!value || !out_.arithmetic(value, offset())) return {};
    const bool needs_second = of.one == Ins::End && !second;
    if (peek() == ']' && !needs_second) break;
    const bool takes_second = !second && (slash || of.two != Ins::End);
    if (takes_second && take(',')) {
      second = true;
      continue;
    }
    if (needs_second)
      return out_.refuse(Cause::MissingComma, offset(), "the function takes two arguments");
    closes();
    return {};
  }
  closes();
  if (slash) return arc_tangent(at, second);
  const Ins op = second ? of.two : of.one;
  put(op == Ins::Round && out_.in_word() ? Ins::RoundWord : op, at);
  return Value::number();
}

// ---- operands ----

/// A number as nearly all are.
CNCSUB_ALWAYS_INLINE inline Value ExpressionReader::constant() {
  const char* at = s_.at;
  const Mantissa m = scan_mantissa(at);
  const std::ptrdiff_t digits = m.whole + m.decimals;
  if (digits == 0 || digits > rules_.most_digits || number_goes_on(at)) [[unlikely]]
    return other_constant();
  const Value value = Value::constant(written_.next());
  put(Ins::Constant, offset());
  const auto whole = static_cast<double>(static_cast<std::int64_t>(m.value));
  written_.put(ExpressionCell::of(whole / kPowersOfTen[m.decimals]));
  s_.at = at;
  return value;
}

/// #1; others are left to other_variable.
CNCSUB_ALWAYS_INLINE inline Value ExpressionReader::written_variable() {
  const std::uint32_t at = offset();
  ++s_.at;
  std::uint32_t number = 0;
  if (!digits_of_variable(number) || is_indirect(number)) [[unlikely]]
    return other_variable(at);
  const NearRange* const near = rules_.code.near.find(number);
  if (near == nullptr) return out_.load(number, at);
  const Value value = Value::variable(written_.next());
  written_.put(ExpressionCell::of(near->raw, near->base + number - near->first, number));
  return value;
}

CNCSUB_ALWAYS_INLINE inline Value ExpressionReader::operand() {
  gap();
  const char c = s_.at < s_.end ? *s_.at : '\0';
  Value value;
  if (c == '#')
    value = written_variable();
  else if (is_digit(c) || c == '.')
    value = constant();
  else if (c == '[')
    value = bracket();
  else if (c == '-' || c == '+')
    value = with_sign();
  else if (is_letter(c))
    value = word();
  else
    return no_operand();
  if (written_.top() > written_.limit()) [[unlikely]]
    written_.make_room();
  return value;
}

Value ExpressionReader::one_operand() { return operand(); }
Value ExpressionReader::variable() { return written_variable(); }

// ---- operators ----

CNCSUB_ALWAYS_INLINE inline const IsoOperator* ExpressionReader::next_operator() {
  gap();
  const char* const at = s_.at;
  if (at >= s_.end || *at == ']') return nullptr;
  if (const IsoOperator* const sign = kSigns[static_cast<unsigned char>(*at)]) {
    behind_operator_ = at + 1;
    return sign;
  }
  return operator_of_name();
}

const IsoOperator* ExpressionReader::operator_of_name() {
  const char* const at = s_.at;
  const IsoOperator* of = s_.end - at > 2 ? named_operator(at) : nullptr;
  if (of != nullptr) {
    behind_operator_ = at + of->spelling.size();
    return of->op == Ins::Modulo && !rules_.modulo ? nullptr : of;
  }
  of = find_operator(rules_, s_);
  if (of == nullptr) return nullptr;
  Scanner behind = s_;
  behind.take_word(of->spelling);
  behind_operator_ = behind.at;
  comments_ = true;  // between its letters
  return of;
}

/// Where logic of numbers binds first, what stands behind tells whether it is of numbers on the
/// right side of a comparison: `#1EQ3AND#2EQ4` joins two, `3EQ#1AND3` is one.
template <class Left>
CNCSUB_ALWAYS_INLINE inline int ExpressionReader::level_of(const IsoOperator& of, Value& value,
                                                           Left& left) {
  if (rules_.alike) return of.alike;
  if (!rules_.numbers_first || !of.is_logic()) return of.level;
  value = left.join(value, of.alike + 1);
  if (!value.is_number()) return of.level;
  const bool compared = left.any([](const IsoOperator& waiting) { return waiting.compares(); });
  return compared && is_before_condition(s_, of) ? of.level : of.alike + 1;
}

Value ExpressionReader::values() { return read_operators(*this); }

// ---- what is read ----

std::optional<std::uint32_t> ExpressionReader::finished(Value value, std::uint32_t at,
                                                        bool negative) {
  if (!value) return std::nullopt;
  if (!out_.is_number(value))
    return out_.refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  if (negative)
    out_.emit(Ins::Negate, at);  // of a vacant variable it stays vacant: X-#1 is no word then
  return out_.finish(at, offset() - at);
}

std::optional<std::uint32_t> ExpressionReader::number(Scanner& s) {
  begin(s);
  gap();
  const std::uint32_t at = offset();
  const auto read = finished(values(), at);
  s.at = s_.at;
  return read;
}

bool ExpressionReader::goes_on(const Scanner& s) const {
  return rules_.word_arithmetic && computes(rules_, s);
}

std::optional<std::uint32_t> ExpressionReader::arithmetic_of_word(Scanner& s, char address) {
  begin(s, address);
  gap();
  const std::uint32_t at = offset();
  const auto read = finished(values(), at);
  s.at = s_.at;
  return read;
}

std::optional<std::uint32_t> ExpressionReader::word_value(Scanner& s, char address) {
  begin(s, address);
  gap();
  const Scanner first = s_;
  const bool negative = take('-');
  if (!negative) take('+');
  const Value value = value_of_word(first.offset());
  s.at = s_.at;
  if (!value || !goes_on(s)) return finished(value, first.offset(), negative);
  s.at = first.at;
  return arithmetic_of_word(s, address);
}

/// A variable, or what stands in brackets, without the sign before it.
Value ExpressionReader::value_of_word(std::uint32_t at) {
  const bool is_variable = peek() == '#';
  const StatementKind kind = is_variable ? StatementKind::Variables : StatementKind::Brackets;
  if (!rules_.code.lacking.test(static_cast<std::size_t>(kind)))
    return is_variable ? variable() : bracket();
  Fault wrong = rules_.code.lacking_fault(kind, at);
  return out_.refuse(wrong.cause, at, std::move(wrong.detail));
}

std::optional<std::uint32_t> ExpressionReader::condition(Scanner& s) {
  begin(s);
  const auto read = read_condition();
  s.at = s_.at;
  return read;
}

std::optional<std::uint32_t> ExpressionReader::read_condition() {
  const bool opened = peek() == '[';
  const std::uint32_t at = offset();
  if (!rules_.bare && !opened)
    return out_.refuse(Cause::ExpressionFormat, at, "a condition stands in brackets");
  Value value = rules_.bare ? values() : bracket();
  if (!value) return std::nullopt;
  const int most = rules_.control.macros.max_condition_length.value;
  if (most > 0 && length_of({s_.file + at, s_.at, s_.file}) > most)
    return out_.refuse(Cause::ExpressionFormat, at,
                       "a condition has at most " + std::to_string(most) + " characters");
  const bool any = rules_.bare || rules_.values;
  if (any && value.is_number()) {  // WHILE TRUE
    out_.arithmetic(value, offset());
    value = Value::condition();
  }
  if (!value.is_condition())
    return out_.refuse(Cause::ExpressionFormat, at, "a condition compares two values");
  return out_.finish(at, offset() - at);
}

/// The variable of an assignment, where more than digits stand behind its #.
std::optional<ExpressionReader::Variable> ExpressionReader::read_target(const Scanner& s,
                                                                        std::uint32_t hash) {
  begin(s);
  const bool inside = peek() == '[';
  const std::uint32_t at = inside ? offset() : hash;
  if (inside) {
    Value inner = bracket();
    if (!inner || !out_.arithmetic(inner, offset())) return std::nullopt;
    return Variable{kComputed, out_.finish(at, offset() - at)};
  }
  const auto number = variable_number(at);
  if (!number) return std::nullopt;
  if (*number != kComputed) return Variable{*number, 0};
  return Variable{kComputed, out_.finish(at, 1)};
}

}  // namespace cncsub
