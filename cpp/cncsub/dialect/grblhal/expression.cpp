#include "cncsub/dialect/grblhal/expression.hpp"

#include <array>
#include <cmath>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub::grblhal {

namespace {

constexpr int kDeepest = 100;  // nested values, more than a line has room for

}  // namespace

double single_of(std::string_view digits) {
  constexpr int kMostDigits = 9;
  std::uint32_t whole = 0;
  int counted = 0, exponent = 0;
  bool point = false;
  for (const char c : digits) {
    if (c == '.') {
      point = true;
      continue;
    }
    if (c != '0' || whole != 0) ++counted;
    if (counted <= kMostDigits) {
      whole = whole * 10 + static_cast<std::uint32_t>(c - '0');
      exponent -= point ? 1 : 0;
    } else if (!point) {
      ++exponent;
    }
  }
  auto value = static_cast<float>(whole);
  if (whole == 0) return 0;
  for (; exponent <= -2; exponent += 2) value *= 0.01F;
  if (exponent < 0) value *= 0.1F;
  for (; exponent > 0; --exponent) value *= 10.0F;
  return value;
}

bool ExpressionReader::wrong(Cause cause, std::string detail, std::size_t place, Kind kind) {
  const std::uint32_t at = line_.offset(place);
  fault = Fault{.cause = cause,
                .at = at,
                .width = line_.width_from(at),
                .detail = std::move(detail),
                .kind = kind};
  return false;
}

void ExpressionReader::emit(Ins op, double value, std::uint32_t index) {
  ngc_push(to_, line_, op, value, index);
}

bool ExpressionReader::finish(Value& value, std::uint32_t at) {
  value = to_.expressions().end_value(constant_, at, line_.width_from(at));
  return true;
}

bool ExpressionReader::value(Value& value) {
  const std::uint32_t at = line_.offset();
  to_.expressions().begin();
  return read_value(0) && finish(value, at);
}

bool ExpressionReader::eight_bits(Value& value) {
  const std::uint32_t at = line_.offset();
  to_.expressions().begin();
  if (!read_value(0)) return false;
  if (!constant_) {
    emit(Ins::WholeNumber);
    emit(Ins::Constant, 256);
    emit(Ins::PositiveModulo);
  }
  return finish(value, at);
}

bool ExpressionReader::bracketed(Value& value) {
  const std::size_t place = line_.place();
  const std::uint32_t at = line_.offset();
  if (line_.peek() != '[')
    return wrong(Cause::StatementFormat, "a value in brackets must stand here", place);
  to_.expressions().begin();
  return read_bracket(0) && finish(value, at);
}

bool ExpressionReader::read_value(int depth) {
  const std::size_t place = line_.place();
  if (depth > kDeepest) return wrong(Cause::BracketsTooDeep, "too many brackets", place);
  const char c = line_.peek(), next = line_.peek(1);
  if (c == '\0' || c == '(' || c == ';')
    return wrong(Cause::AddressWithoutValue, "no value stands here", place);
  if (c == '[') return read_bracket(depth + 1);
  if (c == '#') {
    line_.take();
    return read_variable(depth + 1);
  }
  if ((c == '+' || c == '-') && next != '\0' && !is_digit(next) && next != '.')
    return read_signed(depth, line_.take());
  if (c >= 'a' && c <= 'z') return read_function(depth + 1);
  return read_number();
}

bool ExpressionReader::read_signed(int depth, char sign) {
  if (!read_value(depth + 1)) return false;
  if (sign == '+') return true;
  if (constant_) constant_ = -*constant_;
  emit(Ins::Negate);
  return true;
}

bool ExpressionReader::read_number() {
  const std::size_t place = line_.place();
  const char sign = line_.peek();
  if (sign == '+' || sign == '-') line_.take();
  std::string digits(line_.take_digits());
  if (line_.take('.')) digits += '.' + std::string(line_.take_digits());
  if (digits.empty() || digits == ".")
    return wrong(Cause::AddressWithoutValue, "no number stands here", place, kBadNumber);
  const double number = single_of(digits);
  constant_ = sign == '-' ? -number : number;
  emit(Ins::Constant, *constant_);
  return true;
}

bool ExpressionReader::read_bracket(int depth) {
  line_.take('[');
  NgcOperators values(*this, depth);
  if (!read_operators(values)) return false;
  const std::size_t place = line_.place();
  if (line_.take(']')) return true;
  line_.take();
  return wrong(Cause::ExpressionFormat, "no operator that the control knows", place);
}

bool ExpressionReader::read_function(int depth) {
  const std::size_t place = line_.place();
  const std::uint32_t at = line_.offset();
  if (line_.take("atan")) return read_arctangent(depth);
  if (line_.take("exists")) return read_exists();
  if (line_.take("prm")) return read_setting(depth);
  for (const NgcFunction& function : ngc_functions) {
    if (!line_.take(function.name)) continue;
    if (line_.peek() != '[')
      return wrong(Cause::BracketNotClosed, "the bracket after the function is missing", place);
    if (function.op == Ins::Raise) emit(Ins::Constant, kEuler);
    if (!read_bracket(depth)) return false;
    constant_.reset();
    to_.expressions().emit({function.op, 0, at, 0});
    return true;
  }
  line_.take();
  return wrong(Cause::ExpressionFormat, "no function that the control knows", place);
}

bool ExpressionReader::read_arctangent(int depth) {
  const std::size_t place = line_.place();
  const std::uint32_t at = line_.offset();
  if (line_.peek() != '[')
    return wrong(Cause::BracketNotClosed, "the bracket after ATAN is missing", place);
  if (!read_bracket(depth)) return false;
  if (!line_.take('/') || line_.peek() != '[')
    return wrong(Cause::BracketNotClosed, "ATAN has a second value: ATAN[1]/[2]", place);
  if (!read_bracket(depth)) return false;
  constant_.reset();
  to_.expressions().emit({Ins::ArcTangentOf, 0, at, 0});
  return true;
}

/// Read PRM[28]: a setting of the control.
bool ExpressionReader::read_setting(int depth) {
  const std::size_t place = line_.place();
  if (line_.peek() != '[')
    return wrong(Cause::BracketNotClosed, "the bracket after PRM is missing", place);
  if (!read_bracket(depth)) return false;
  const bool known = constant_ && std::floor(*constant_) == *constant_ && *constant_ >= 0 &&
                     *constant_ < 1000 && !to_.control().parameters.empty();
  const auto number = known ? std::to_string(static_cast<int>(*constant_)) : std::string();
  for (const Parameter& of : to_.control().parameters)
    if (known && of.name == number) {
      constant_.reset();
      emit(Ins::Parameter);
      return true;
    }
  return wrong(Cause::CodeNotComputed, "the setting is one of the machine, which is not known here",
               place);
}

}  // namespace cncsub::grblhal

namespace cncsub {

std::optional<Fault> grblhal_expression(Builder& to, const ExpressionText& text,
                                        std::uint32_t& expression, ValueType& /*type*/) {
  return ngc_expression<grblhal::ExpressionReader>(to, text, expression);
}

}  // namespace cncsub
