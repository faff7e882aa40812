// The loop that reads expressions: operands and operators, and what waits for them.
#include <array>
#include <span>

#include "cncsub/dialect/iso/expression.hpp"
#include "cncsub/system/compiler.hpp"

namespace cncsub {

// ---- operands ----

/// A number that is digits and a point; else nothing.
CNCSUB_ALWAYS_INLINE inline Value ExpressionReader::constant(const char*& at) {
  const char* end = at;
  const Mantissa m = scan_mantissa(end);
  const std::ptrdiff_t digits = m.whole + m.decimals;
  if (digits == 0 || digits > e_.rules.most_digits || !e_.ends_at(end)) return {};
  const std::uint32_t place = e_.offset(at);
  at = end;
  const auto whole = static_cast<double>(static_cast<std::int64_t>(m.value));
  e_.out.emit(Ins::Constant, place, whole / kPowersOfTen[m.decimals]);
  return Value::number();
}

/// A variable whose number is digits and nothing else, and which lies near; else nothing.
CNCSUB_ALWAYS_INLINE inline Value ExpressionReader::near_variable(const char*& at) {
  const char* end = at + 1;
  const auto number = e_.plain_number(end);
  if (!number) return {};
  const ExpressionRules::Near* const near = e_.rules.near(*number);
  if (near == nullptr) return {};
  at = end;
  return e_.out.load(*near, *number);
}

/// A variable or a number that is written in the plainest way; else nothing.
CNCSUB_ALWAYS_INLINE inline Value ExpressionReader::plain_operand(const char*& at) {
  if (*at == '#') return near_variable(at);
  return is_digit(*at) || *at == '.' ? constant(at) : Value{};
}

/// What opens in the plainest way: a bracket, or a function of three letters with its bracket.
inline bool ExpressionReader::opens_bracket(const char*& at) {
  if (*at != '[' || at == e_.s->end || e_.brackets >= e_.rules.most_brackets) return false;
  e_.wait(Waiting::Kind::Bracket, e_.offset(at));
  ++e_.brackets;
  ++at;
  return true;
}

inline bool ExpressionReader::opens_function(const char*& at) {
  if (e_.s->end - at <= 3 || at[3] != '[' || !is_letter(*at) ||
      e_.brackets >= e_.rules.most_brackets)
    return false;
  const FunctionName* const function = e_.rules.short_function(at[0], at[1], at[2]);
  if (function == nullptr) return false;
  e_.wait(Waiting::Kind::Function, e_.offset(at), function);
  ++e_.brackets;
  at += 4;
  return true;
}

/// An operand; what is opened before it, and signs, wait.
CNCSUB_ALWAYS_INLINE inline Value ExpressionReader::operand(const char*& at) {
  for (;;) {
    Value value = plain_operand(at);
    if (value) return value;
    if (opens_bracket(at) || opens_function(at)) continue;
    e_.s->at = at;
    value = other_operand(e_);
    at = e_.s->at;
    if (!value.is_awaited()) return value;
  }
}

// ---- what was opened ----

/// What a function makes of its arguments.
inline Value ExpressionReader::function(const Waiting& of) {
  Ins op = of.second ? of.function->two : of.function->one;
  if (op == Ins::Round && e_.out.in_word()) op = Ins::RoundWord;
  e_.out.emit(op, of.at);
  return Value::number();
}

/// What ends here gives its value to what was opened last: the value of that, or another argument
/// is awaited.
CNCSUB_ALWAYS_INLINE inline Value ExpressionReader::closed(Value value, const char*& at) {
  Waiting& of = e_.last[-1];
  const bool argument = of.kind == Waiting::Kind::Function || of.kind == Waiting::Kind::ArcTangent;
  if (argument && !e_.out.arithmetic(value, e_.offset(at))) return {};
  const bool one_more = argument && of.function->one == Ins::End && !of.second;
  if (at == e_.s->end || *at != ']' || one_more) {
    e_.s->at = at;
    value = not_closed(e_, of, argument);
    at = e_.s->at;
    return value;
  }
  ++at;
  --e_.brackets;
  --e_.last;
  if (of.kind == Waiting::Kind::Bracket) return value;
  if (of.kind == Waiting::Kind::Function) return function(of);
  e_.s->at = at;
  value = other_closed(e_, of, value);
  at = e_.s->at;
  return value;
}

// ---- operators ----

namespace {

/// The level at which an operator binds, but for logic of numbers where that binds first.
int level_of(const ExpressionRules& rules, const OperatorName& of) {
  return rules.alike ? of.alike : of.last;
}

/// Joins two values by the operator at `at`.
inline Value apply(ValueWriter& out, const OperatorName& of, std::uint32_t at, Value left,
                   Value right, std::uint32_t end) {
  if (!of.is_arithmetic()) return apply_other(out, of, at, left, right, end);
  if (!out.arithmetic(left, end) || !out.arithmetic(right, end)) return {};
  out.emit_operator(of.op, of.other, at);
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
CNCSUB_ALWAYS_INLINE inline Value ExpressionReader::join(Value value, int level, const char* at) {
  while (e_.last[-1].level >= level) {
    const Waiting& left = *--e_.last;
    value = apply(e_.out, *left.of, left.at, left.left, value, e_.offset(at));
    if (!value) break;
  }
  return value;
}

/// An operator stands behind the value: both wait for what comes, but where that is written in the
/// plainest way and nothing behind it can bind it.
CNCSUB_ALWAYS_INLINE inline Value ExpressionReader::operates(const OperatorName& of, Value value,
                                                             const char*& at) {
  int level = level_of(e_.rules, of);
  if (e_.rules.numbers_first && of.is_logic()) {
    value = join(value, of.alike + 1, at);
    if (!value) return value;
    e_.s->at = at;
    if (is_of_numbers(of, value)) level = of.alike + 1;
  }
  value = join(value, level, at);
  if (!value) return value;
  const std::uint32_t place = e_.offset(at);
  Value right = Value::awaited();
  if (of.text.size() == 1) {
    ++at;
    right = plain_operand(at);
    if (right && (at == e_.s->end || *at == ']'))
      return apply(e_.out, of, place, value, right, e_.offset(at));
    if (!right) right = Value::awaited();
  } else {
    e_.s->at = at;
    e_.s->take_word(of.text);
    at = e_.s->at;
  }
  Waiting& waiting = *e_.last++;
  waiting.left = value;
  waiting.of = &of;
  waiting.at = place;
  waiting.level = level;
  waiting.kind = Waiting::Kind::Operator;
  return right;
}

bool ExpressionReader::is_of_numbers(const OperatorName& of, const Value& value) const {
  const Waiting* first = e_.last;
  while (first[-1].level > Waiting::kOpening) --first;
  return cncsub::is_of_numbers(*e_.s, of, value, {first, e_.last});
}

/// What stands behind an operand: the whole value, or an operand is awaited.
CNCSUB_ALWAYS_INLINE inline Value ExpressionReader::behind(Value value, const Waiting* base,
                                                           bool alone, const char*& at) {
  for (;;) {
    if (e_.last[-1].level == Waiting::kPrefix) {
      e_.s->at = at;
      value = prefixed(e_, value);
      if (!value) return value;
    }
    if (alone && e_.last == base) return value;
    if (const OperatorName* const next = next_operator(e_.rules, *e_.s, at)) {
      value = operates(*next, value, at);
      if (!value) return value;
      continue;
    }
    value = join(value, 0, at);
    if (!value || e_.last == base) return value;
    value = closed(value, at);
    if (!value) return value;
  }
}

/// Reads until what waits above `base` has its value; `alone`: no operator behind that is read.
Value ExpressionReader::values(const Waiting* base, bool alone) {
  const char* at = e_.s->at;
  for (;;) {
    Value value = operand(at);
    if (value) value = behind(value, base, alone, at);
    if (value.is_awaited()) continue;
    e_.s->at = at;
    return value;
  }
}

/// What stands in brackets.
Value ExpressionReader::bracket() {
  const Waiting* const base = e_.last;
  const char* at = e_.s->at;
  if (opens_bracket(at))
    e_.s->at = at;
  else if (!e_.open(Waiting::Kind::Bracket, e_.s->offset()).is_awaited())
    return {};
  return values(base, true);
}

/// The variable of an assignment, where more than digits stand behind its #.
std::optional<ExpressionReader::Variable> ExpressionReader::other_target(std::uint32_t hash) {
  const bool inside = e_.s->peek() == '[';
  const std::uint32_t at = inside ? e_.s->offset() : hash;
  if (inside) {
    Value inner = bracket();
    if (!inner || !e_.out.arithmetic(inner, e_.s->offset())) return std::nullopt;
    return Variable{kComputed, e_.out.finish(at, e_.s->offset() - at)};
  }
  const auto number = variable_number(e_, at);
  if (!number) return std::nullopt;
  if (*number != kComputed) return Variable{*number, 0};
  return Variable{kComputed, e_.out.finish(at, 1)};
}

}  // namespace cncsub
