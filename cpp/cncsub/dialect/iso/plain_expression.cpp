#include "cncsub/dialect/iso/plain_expression.hpp"

#include <algorithm>
#include <array>

#include "cncsub/dialect/iso/operators.hpp"
#include "cncsub/system/compiler.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

/// The signs of arithmetic by their character.
constexpr auto kSigns = [] {
  std::array<const OperatorName*, 256> signs{};
  for (const OperatorName& of : kArithmetic) signs[static_cast<unsigned char>(of.text[0])] = &of;
  return signs;
}();

/// Operators of letters, by some bits of the first two.
constexpr std::size_t slot_of(char a, char b) {
  return (static_cast<std::size_t>(a) % 32) * 32 + static_cast<std::size_t>(b) % 32;
}
constexpr auto kByLetters = [] {
  std::array<const OperatorName*, std::size_t{32} * 32> by_letters{};
  for (const OperatorName& of : kOperators) by_letters[slot_of(of.text[0], of.text[1])] = &of;
  return by_letters;
}();
/// The operator whose name begins at `at`, where three characters stand; null where none does.
const OperatorName* named_operator(const char* at) {
  const OperatorName* const of = kByLetters[slot_of(at[0], at[1])];
  if (of == nullptr || of->text[0] != at[0] || of->text[1] != at[1]) return nullptr;
  return of->text.size() == 2 || of->text[2] == at[2] ? of : nullptr;
}

constexpr std::size_t kLevels = kTightest + 1;

}  // namespace

/// An operator and what stands on its left.
struct PlainExpression::Waiting {
  Value left;
  std::uint32_t at;
  const OperatorName* of;
  int level;
};

/// What waits as far as `last`, a value behind it, and the level at which the operator behind that
/// binds. No value where what stands behind the operator tells.
struct PlainExpression::Logic {
  Waiting* last;
  Value value;
  int level;
};

// ---- operands ----

CNCSUB_ALWAYS_INLINE inline PlainValue PlainExpression::constant(const char* at) {
  const char* end = at;
  const Mantissa m = scan_mantissa(end);
  const std::ptrdiff_t digits = m.whole + m.decimals;
  if (digits == 0 || digits > rules_.most_digits || *end == '.') return {};
  const Value value = Value::constant(written_.next());
  put(Ins::Constant, offset(at));
  const auto whole = static_cast<double>(static_cast<std::int64_t>(m.value));
  written_.put(ExpressionCell::of(whole / kPowersOfTen[m.decimals]));
  return {end, value};
}

CNCSUB_ALWAYS_INLINE inline PlainValue PlainExpression::written_variable(const char* at) {
  const char* const first = ++at;
  std::uint32_t number = 0;
  for (std::uint32_t digit = 0; (digit = static_cast<std::uint32_t>(*at - '0')) <= 9; ++at)
    number = number * 10 + digit;
  if (at == first || at - first > ExpressionRules::kMostVariableDigits || *at == '.') return {};
  const NearRange* const near = rules_.code.near.find(number);
  if (near == nullptr && rules_.indirect) return {};
  if (near == nullptr) return {at, out_.load(number, offset(first) - 1)};
  const Value value = Value::variable(written_.next());
  written_.put(ExpressionCell::of(near->raw, near->base + number - near->first, number));
  return {at, value};
}

/// A number or a variable that is written with digits.
CNCSUB_ALWAYS_INLINE inline PlainValue PlainExpression::plain_operand(const char* at) {
  if (*at == '#') return written_variable(at);
  return is_digit(*at) || *at == '.' ? constant(at) : PlainValue{};
}

/// What opens at `at`: brackets, those of an indirect variable, or a function of one argument.
CNCSUB_ALWAYS_INLINE inline PlainExpression::Opening PlainExpression::opening(
    const char* at) const {
  if (*at == '[') return {1, Ins::End};
  if (*at == '#') return at[1] == '[' ? Opening{2, Ins::IndirectRaw} : Opening{};
  if (!is_letter(*at)) return {};
  int width = 0;
  const FunctionName* const function = rules_.function_at(at, end_, width);
  if (function == nullptr) return {};
  const Ins op = function->one;
  if (op == Ins::End || op == Ins::Programmed) return {};
  return {width, op == Ins::Round && address_ != 0 ? Ins::RoundWord : op};
}

/// What stands in brackets, whose first is before `at`. Most often that is one value.
CNCSUB_ALWAYS_INLINE inline PlainValue PlainExpression::bracketed(const char* at, int brackets) {
  if (brackets > rules_.most_brackets) return {};
  PlainValue read = plain_operand(at);
  if (!read.value || *read.at != ']') {
    read = values(read.value ? read : PlainValue{at, Value::awaited()}, brackets);
    if (!read.value || *read.at != ']') return {};
  }
  ++read.at;
  return read;
}

/// What opens, with its brackets.
CNCSUB_ALWAYS_INLINE inline PlainValue PlainExpression::opened(const char* at, int brackets) {
  const Opening of = opening(at);
  if (of.width == 0) return {};
  PlainValue read = bracketed(at + of.width, brackets + 1);
  if (of.op == Ins::End || !read.value) return read;
  if (!out_.arithmetic(read.value, 0)) return {};
  if (of.op == Ins::Atan) return arc_tangent(read.at, offset(at), brackets);
  read.value = of.op == Ins::IndirectRaw ? Value::variable(written_.next()) : Value::number();
  put(of.op, offset(at));
  return read;
}

/// ATAN[a]/[b] and ATAN[a], behind the first bracket.
PlainValue PlainExpression::arc_tangent(const char* at, std::uint32_t of, int brackets) {
  const bool slash = !rules_.has(Function::Atan2);
  if (slash && begins_gap(*at)) return {};
  const bool two = slash && at[0] == '/' && at[1] == '[';
  PlainValue read{at, Value::number()};
  if (slash && at[0] == '/' && begins_gap(at[1])) return {};
  if (two) read = bracketed(at + 2, brackets + 1);
  if (!read.value || !out_.arithmetic(read.value, 0)) return {};
  put(two ? Ins::Atan2 : Ins::Atan, of);
  return {read.at, Value::number()};
}

/// What a sign at `at` makes of the value behind it.
Value PlainExpression::with_sign(bool negative, Value value, std::uint32_t at) {
  if (value.is_constant()) return negative ? out_.negated(value, at) : value;
  if (!out_.arithmetic(value, 0)) return {};
  if (negative) put(Ins::Negate, at);
  return Value::number();
}

CNCSUB_ALWAYS_INLINE inline PlainValue PlainExpression::operand(const char* at, int brackets) {
  const bool sign = *at == '-' || *at == '+';
  const char* const first = at;
  if (sign) ++at;
  PlainValue read = plain_operand(at);
  if (!read.value) read = opened(at, brackets);
  if (sign && read.value) read.value = with_sign(*first == '-', read.value, offset(first));
  return read;
}

/// Passes over blanks and comments.
CNCSUB_ALWAYS_INLINE inline void PlainExpression::pass_gap(const char*& at) {
  if (begins_gap(*at)) [[unlikely]]
    at = *at == ' ' && !begins_gap(at[1]) ? at + 1 : behind_gap(at);
}
const char* PlainExpression::behind_gap(const char* at) {
  comments_ = true;
  Scanner s{at, std::max(at, end_), file_};
  s.pass_gap();
  return s.at;
}

// ---- operators ----

/// The operator that stands here; null where none does that is that plain.
CNCSUB_ALWAYS_INLINE inline const OperatorName* PlainExpression::next_operator(const char*& at) {
  pass_gap(at);
  if (const OperatorName* const sign = kSigns[static_cast<unsigned char>(*at)]) return sign;
  if (*at == ']' || end_ - at <= 2) return nullptr;
  const OperatorName* const of = named_operator(at);
  return of != nullptr && of->op == Ins::Modulo && !rules_.modulo ? nullptr : of;
}

CNCSUB_ALWAYS_INLINE inline Value PlainExpression::apply(const OperatorName& of, std::uint32_t at,
                                                         Value left, Value right) {
  if (!of.is_arithmetic()) return cncsub::apply(out_, of, at, left, right, 0);
  const bool constant = right.is_constant() && of.other != Ins::End;
  const std::uint32_t last = constant ? right.place() : 0;
  if (!out_.arithmetic(left, 0) || !out_.arithmetic(right, 0)) return {};
  if (!constant || (of.op == Ins::Divide && written_.value(last) == 0)) {
    put(of.op, at);
  } else {
    written_.set_op(last, of.other);
    written_.set_at(last, at);
  }
  return Value::number();
}

/// Joins a value with what waits from `first` to `last` and binds as closely.
CNCSUB_ALWAYS_INLINE inline Value PlainExpression::join(const Waiting* first, Waiting*& last,
                                                        Value value, int level) {
  while (last != first && last[-1].level >= level && value) {
    --last;
    value = apply(*last->of, last->at, last->left, value);
  }
  return value;
}

/// Logic where that of numbers binds first. Of the right side of a comparison what stands behind
/// tells whether it is of numbers.
PlainExpression::Logic PlainExpression::logic_behind(const OperatorName& of, const Waiting* first,
                                                     Waiting* last, Value value) {
  value = join(first, last, value, of.alike + 1);
  if (!value.is_number()) return {last, value, of.last};
  const bool compared = std::any_of(first, static_cast<const Waiting*>(last),
                                    [](const Waiting& waiting) { return waiting.of->compares(); });
  return {last, compared ? Value() : value, of.alike + 1};
}

/// Operands and operators, and what stands in brackets between them; the first operand where it is
/// not read. Each operator that waits binds more closely than the one before.
PlainValue PlainExpression::values(PlainValue read, int brackets) {
  std::array<Waiting, kLevels> all;  // NOLINT(*-member-init): as far as `last`
  Waiting* last = all.data();
  for (;;) {
    if (read.value.is_awaited()) {
      pass_gap(read.at);
      read = operand(read.at, brackets);
      if (!read.value) return {};
    }
    if (written_.top() > written_.limit()) written_.make_room();
    const OperatorName* const next = next_operator(read.at);
    int level = next == nullptr ? 0 : level_of(rules_, *next);
    if (next != nullptr && rules_.numbers_first && next->is_logic()) {
      const Logic logic = logic_behind(*next, all.data(), last, read.value);
      last = logic.last;
      read.value = logic.value;
      level = logic.level;
    }
    read.value = join(all.data(), last, read.value, level);
    if (!read.value) return {};
    if (next == nullptr) return read;
    last->left = read.value;
    last->at = offset(read.at);
    last->of = next;
    last->level = level;
    ++last;
    read = {read.at + next->text.size(), Value::awaited()};
  }
}

// ---- what is read ----

PlainValue PlainExpression::read(const Scanner& s) {
  if (!rules_.plain) return {};
  begin(s);
  PlainValue of = *s.at == '[' ? bracketed(s.at + 1, 1) : plain_operand(s.at);
  if (of.value && of.at == s.end) return of;
  of = values(of.value ? of : PlainValue{s.at, Value::awaited()}, 0);
  return of.at == s.end ? of : PlainValue{};
}

PlainValue PlainExpression::bracket(const Scanner& s) {
  if (*s.at != '[' || !rules_.plain) return {};
  begin(s);
  const PlainValue of = bracketed(s.at + 1, 1);
  return of.at <= s.end ? of : PlainValue{};
}

PlainValue PlainExpression::variable(const Scanner& s) {
  if (*s.at != '#' || !rules_.plain) return {};
  begin(s);
  const bool inside = s.at[1] == '[';
  const PlainValue of = inside ? opened(s.at, 0) : written_variable(s.at);
  if (of.at > s.end) return {};
  if (inside || of.at == s.end || !of.value || !begins_gap(*of.at)) return of;
  const char* const behind = behind_gap(of.at);  // the number may go on there
  return behind != s.end && (is_digit(*behind) || *behind == '.') ? PlainValue{} : of;
}

}  // namespace cncsub
