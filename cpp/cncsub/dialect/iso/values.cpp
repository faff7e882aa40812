// The operators of expressions, and the values between them in their usual forms.
#include "cncsub/dialect/iso/values.hpp"

#include <array>

#include "cncsub/system/compiler.hpp"

namespace cncsub {

namespace {

/// The arithmetic operators by their character.
constexpr auto kSigns = [] {
  std::array<const IsoOperator*, 256> signs{};
  for (const IsoOperator& of : kArithmetic) signs[static_cast<unsigned char>(of.spelling[0])] = &of;
  return signs;
}();

/// Return the slot of an operator of letters: some bits of its first two letters.
constexpr std::size_t slot_of(char a, char b) {
  return (static_cast<std::size_t>(a) % 32) * 32 + static_cast<std::size_t>(b) % 32;
}
constexpr auto kByLetters = [] {
  std::array<const IsoOperator*, std::size_t{32} * 32> by_letters{};
  for (const IsoOperator& of : kNamedOperators)
    by_letters[slot_of(of.spelling[0], of.spelling[1])] = &of;
  return by_letters;
}();
/// Return the operator whose capitals begin at `at`, where three characters stand; null if none
/// does.
const IsoOperator* named_operator(const char* at) {
  const IsoOperator* const of = kByLetters[slot_of(at[0], at[1])];
  if (of == nullptr || of->spelling[0] != at[0] || of->spelling[1] != at[1]) return nullptr;
  return of->spelling.size() == 2 || of->spelling[2] == at[2] ? of : nullptr;
}

}  // namespace

/// Read a value in brackets.
Value ValueReader::bracket() {
  if (!opens()) return {};
  const Value value = values();
  return value && closes() ? value : Value{};
}

// ---- functions ----

/// Read a function whose name of capitals stands before its bracket; other_word reads any other.
CNCSUB_ALWAYS_INLINE inline Value ValueReader::word() {
  const std::uint32_t at = offset();
  int width = 0;
  const FunctionName* const of = rules_.function_at(s_.at, s_.end, width);
  if (of == nullptr || of->one == Ins::Programmed || s_.at + width > s_.end) [[unlikely]]
    return other_word();
  s_.at += width - 1;
  return arguments(*of, at);
}

/// Read one argument of a function; false if it is none, which is reported.
bool ValueReader::argument() {
  Value value = values();
  return value && out_.arithmetic(value, offset());
}

/// Read the arguments of the function at `at` in their brackets, and write the function.
Value ValueReader::arguments(const FunctionName& of, std::uint32_t at) {
  const bool slash = of.one == Ins::Atan && !rules_.has(Function::Atan2);
  if (!opens() || !argument()) return {};
  const bool second = (slash || of.two != Ins::End) && take(',');
  if (second && !argument()) return {};
  if (of.one == Ins::End && !second)
    return out_.refuse(Cause::MissingComma, offset(), "the function must have two arguments");
  if (!closes()) return {};
  if (slash) return arc_tangent(at, second);
  const Ins op = second ? of.two : of.one;
  put(op == Ins::Round && out_.in_word() ? Ins::RoundWord : op, at);
  return Value::number();
}

// ---- operands ----

/// Read a number in its usual form; other_constant reads any other.
CNCSUB_ALWAYS_INLINE inline Value ValueReader::constant() {
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

/// Read a variable such as #1; other_variable reads any other.
CNCSUB_ALWAYS_INLINE inline Value ValueReader::variable() {
  const std::uint32_t at = offset();
  ++s_.at;
  std::uint32_t number = 0;
  if (!digits_of_variable(number) || rules_.needs_look(number)) [[unlikely]]
    return other_variable(at);
  const DirectVariables* const near = rules_.code.direct_variables.find(number);
  if (near == nullptr) return out_.load(number, at);
  const Value value = Value::variable(written_.next());
  written_.put(ExpressionCell::of(near->raw, near->base + number - near->first, number));
  return value;
}

CNCSUB_ALWAYS_INLINE inline Value ValueReader::operand() {
  gap();
  const char c = s_.at < s_.end ? *s_.at : '\0';
  Value value;
  if (rules_.structured) [[unlikely]]
    value = structured_operand(c);
  else if (c == '#')
    value = variable();
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

Value ValueReader::one_operand() { return operand(); }

// ---- operators ----

CNCSUB_ALWAYS_INLINE inline const IsoOperator* ValueReader::next_operator() {
  gap();
  const char* const at = s_.at;
  if (at >= s_.end || *at == ']') return nullptr;
  if (rules_.structured) [[unlikely]]
    return structured_operator();
  if (const IsoOperator* const sign = kSigns[static_cast<unsigned char>(*at)]) {
    behind_operator_ = at + 1;
    return sign;
  }
  return operator_of_name();
}

const IsoOperator* ValueReader::operator_of_name() {
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
  comments_ = true;  // may stand between its letters
  return of;
}

/// Return the precedence of an operator. Where logic of numbers binds first, the text after the
/// operator tells whether it joins numbers on the right of a comparison: `#1EQ3AND#2EQ4` joins two
/// conditions, `3EQ#1AND3` is one.
template <class Left>
CNCSUB_ALWAYS_INLINE inline int ValueReader::level_of(const IsoOperator& of, Value& value,
                                                      Left& left) {
  if (rules_.alike) return of.alike;
  if (!rules_.numbers_first || !of.is_logic()) return of.level;
  value = left.join(value, of.alike + 1);
  if (!value.is_number()) return of.level;
  const bool compared = left.any([](const IsoOperator& waiting) { return waiting.compares(); });
  return compared && is_before_condition(s_, of) ? of.level : of.alike + 1;
}

Value ValueReader::values() { return read_operators(*this); }

}  // namespace cncsub
