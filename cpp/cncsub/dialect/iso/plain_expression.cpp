#include "cncsub/dialect/iso/plain_expression.hpp"

#include <algorithm>
#include <string_view>

namespace cncsub {

namespace {

struct Joining {
  char sign;
  Ins values, constant;  // two values, and one with a constant behind it
};
constexpr Joining kJoining[] = {{'+', Ins::Add, Ins::AddConstant},
                                {'-', Ins::Subtract, Ins::SubtractConstant},
                                {'*', Ins::Multiply, Ins::MultiplyConstant},
                                {'/', Ins::Divide, Ins::DivideConstant}};

/// A local, a common or a number, as it stands in the text.
struct PlainValue {
  std::uint32_t at = 0;
  bool variable = false, local = false, writable = false;
  std::uint32_t index = 0;
  double value = 0;  // of a variable: its number

  void load(bool raw, PlainExpression& to) const {
    const Ins of_local = raw ? Ins::LocalRaw : Ins::Local;
    const Ins of_common = raw ? Ins::CommonRaw : Ins::Common;
    to.add(!variable ? Ins::Constant : local ? of_local : of_common, variable ? index : at, value);
    to.writable = writable;
  }
};

bool read_value(const Code& code, const Scanner& s, const char*& at, PlainValue& value) {
  const MacroRules& rules = code.control->macros;
  value.at = static_cast<std::uint32_t>(at - s.file);
  value.variable = *at == '#';
  at += value.variable ? 1 : 0;
  const Mantissa number = scan_mantissa(at);
  const auto digits = number.whole + number.decimals;
  if (at > s.end || digits == 0) return false;
  value.value = static_cast<double>(static_cast<std::int64_t>(number.value));
  if (!value.variable) {
    if (digits > std::min(rules.max_constant_digits.value, kMostDigits)) return false;
    value.value /= kPowersOfTen[number.decimals];
    return true;
  }
  if (number.point || digits > 9 || rules.variable_forms.value.has(VariableForm::Indirect))
    return false;
  const VariablePlace place = code.place(static_cast<std::int64_t>(number.value));
  value.index = static_cast<std::uint32_t>(place.index);
  value.local = place.is_local();
  value.writable = value.local || (place.is_common() && place.range->access == Access::ReadWrite);
  return value.local || place.is_common();
}

/// The first value of an expression: a number may have a minus.
bool read_first(const Code& code, const Scanner& s, const char*& at, PlainValue& value) {
  const bool negative = *at == '-';
  if (negative && !is_digit(*++at)) return false;
  if (!read_value(code, s, at, value)) return false;
  if (negative) value.value = -value.value;
  return true;
}

}  // namespace

std::optional<PlainExpression> plain_expression(const Code& code, const Scanner& s) {
  const char* at = s.at;
  PlainValue first, second;
  if (at == s.end || !read_first(code, s, at, first)) return std::nullopt;
  const auto ends = [&] { return at == s.end || *at == ']'; };
  PlainExpression plain;
  plain.end = at;
  if (ends()) {
    first.load(true, plain);
    return plain;
  }
  const auto* const joining = std::find_if(std::begin(kJoining), std::end(kJoining),
                                           [at](const Joining& of) { return of.sign == *at; });
  if (joining == std::end(kJoining)) return std::nullopt;
  const auto sign_at = static_cast<std::uint32_t>(at++ - s.file);
  if (at == s.end || !read_value(code, s, at, second) || !ends()) return std::nullopt;
  if (joining->sign == '/' && !second.variable && second.value == 0) return std::nullopt;
  plain.end = at;
  first.load(false, plain);
  if (second.variable) {
    second.load(false, plain);
    plain.add(joining->values, sign_at);
  } else {
    plain.add(joining->constant, sign_at, second.value);
  }
  return plain;
}

std::optional<PlainExpression> plain_bracket(const Code& code, const Scanner& s) {
  if (s.at == s.end || *s.at != '[' || code.control->macros.max_brackets.value < 1)
    return std::nullopt;
  auto plain = plain_expression(code, {s.at + 1, s.end, s.file});
  if (!plain || plain->end == s.end || plain->end + 1 != s.end) return std::nullopt;
  plain->end = s.end;
  return plain;
}

std::optional<PlainExpression> plain_variable(const Code& code, const Scanner& s,
                                              std::uint32_t hash) {
  const char* at = s.file + hash;
  PlainValue value;
  if (!read_value(code, s, at, value) || !value.variable) return std::nullopt;
  if (at != s.end && (is_blank(*at) || *at == '(')) return std::nullopt;
  PlainExpression plain;
  plain.end = at;
  value.load(true, plain);
  return plain;
}

}  // namespace cncsub
