// The loop that reads expressions: operands and operators, and what waits for them.
#include <array>
#include <span>

#include "cncsub/dialect/iso/expression.hpp"

namespace cncsub {

// ---- operands ----

/// A number that is digits and a point; else nothing.
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

/// A variable whose number is digits and nothing else, and which lies near; else nothing.
inline Value ExpressionReader::near_variable(const char*& at) {
  const char* end = at + 1;
  const auto number = plain_number(end);
  const ExpressionRules::Near* const near = number ? rules_.near(*number) : nullptr;
  if (near == nullptr || !out_.has_room(offset(at + 1))) return {};
  at = end;
  return out_.load(*near, *number);
}

/// A bracket, or a function of three letters with its bracket, opens here: what it holds comes next.
inline bool ExpressionReader::opens_here(const char*& at) {
  const bool bracket = *at == '[';
  const bool word = s_->end - at > 3 && at[3] == '[' && is_letter(*at);
  if ((!bracket && !word) || brackets_ >= rules_.most_brackets || at == s_->end) return false;
  const FunctionName* const function =
      bracket ? nullptr : rules_.short_function(at[0], at[1], at[2]);
  if (!bracket && function == nullptr) return false;
  wait(bracket ? Waiting::Kind::Bracket : Waiting::Kind::Function, offset(at), function);
  ++brackets_;
  at += bracket ? 1 : 4;
  return true;
}

/// An operand; what is opened before it, and signs, wait.
inline Value ExpressionReader::operand(const char*& at) {
  for (;;) {
    const char c = *at;
    Value value;
    if (c == '#')
      value = near_variable(at);
    else if (is_digit(c) || c == '.')
      value = constant(at);
    else if (opens_here(at))
      continue;
    if (value) return value;
    s_->at = at;
    value = other_operand();
    at = s_->at;
    if (!value.is_awaited()) return value;
  }
}

// ---- what was opened ----

/// What a function makes of its arguments.
inline Value ExpressionReader::function(const Waiting& of) {
  Ins op = of.second ? of.function->two : of.function->one;
  if (op == Ins::Round && out_.in_word()) op = Ins::RoundWord;
  out_.emit(op, of.at);
  return Value::number();
}

/// What ends here gives its value to what was opened last: the value of that, or another argument
/// is awaited.
inline Value ExpressionReader::closed(Value value, const char*& at) {
  Waiting& of = last_[-1];
  const bool argument =
      of.kind == Waiting::Kind::Function || of.kind == Waiting::Kind::ArcTangent;
  if (argument && !out_.arithmetic(value, offset(at))) return {};
  const bool one_more = argument && of.function->one == Ins::End && !of.second;
  if (at == s_->end || *at != ']' || one_more) {
    s_->at = at;
    value = not_closed(of, argument);
    at = s_->at;
    return value;
  }
  ++at;
  --brackets_;
  --last_;
  if (of.kind == Waiting::Kind::Bracket) return value;
  if (of.kind == Waiting::Kind::Function) return function(of);
  s_->at = at;
  value = other_closed(of, value);
  at = s_->at;
  return value;
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
  while (last_[-1].level >= level) {
    value = apply(out_, *--last_, value, offset(at));
    if (!value) break;
  }
  return value;
}

/// An operator stands behind the value: both wait for what comes.
inline Value ExpressionReader::operates(const OperatorName& of, Value value, const char*& at) {
  int level = level_of(rules_, of);
  if (rules_.numbers_first && of.is_logic()) {
    value = join(value, of.alike + 1, at);
    if (!value) return value;
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
      if (!value) return value;
    }
    if (alone && last_ == base) return value;
    if (const OperatorName* const next = next_operator(rules_, *s_, at))
      return operates(*next, value, at);
    value = join(value, 0, at);
    if (!value || last_ == base) return value;
    value = closed(value, at);
    if (!value) return value;
  }
}

/// Reads until what waits above `base` has its value; `alone`: no operator behind that is read.
Value ExpressionReader::values(const Waiting* base, bool alone) {
  const char* at = s_->at;
  for (;;) {
    Value value = operand(at);
    if (value) value = behind(value, base, alone, at);
    if (value.is_awaited()) continue;
    s_->at = at;
    return value;
  }
}

/// What stands in brackets.
Value ExpressionReader::bracket() {
  const Waiting* const base = last_;
  const Value inner = open(Waiting::Kind::Bracket, s_->offset());
  return inner.is_awaited() ? values(base, true) : inner;
}

}  // namespace cncsub
