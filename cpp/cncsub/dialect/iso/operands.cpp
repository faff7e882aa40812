// Operands, and what opens before one.
#include <string>

#include "cncsub/dialect/iso/open_expression.hpp"

namespace cncsub {

namespace {

Value constant(OpenExpression& e) {
  const std::uint32_t at = e.s->offset();
  const Number number = scan_number(*e.s);
  if (number.points > 1)
    return e.out.refuse(Cause::IllegalDecimalPoint, at, "two points in one number");
  if (!number.any) return e.out.refuse(Cause::ExpressionFormat, at, "a point is no number");
  const int most = e.rules.control.macros.max_constant_digits.value;
  if (number.digits > static_cast<std::uint32_t>(most))
    return e.out.refuse(Cause::TooManyDigits, at,
                        "a number has at most " + std::to_string(most) + " digits");
  return e.out.constant(number.value, at);
}

Value sign(OpenExpression& e) {
  const std::uint32_t at = e.s->offset();
  const bool negative = *e.s->at++ == '-';
  const char next = e.s->peek();
  if (next == '-' || next == '+')
    return e.out.refuse(Cause::ExpressionFormat, e.s->offset(), "two signs in a row");
  return e.wait(negative ? Waiting::Kind::Minus : Waiting::Kind::Plus, at);
}

Refused no_operand(OpenExpression& e) {
  const bool inside = e.brackets > 0;
  const std::uint32_t at = e.s->offset();
  switch (e.s->peek()) {
    case ']':
      return e.out.refuse(inside ? Cause::ExpressionFormat : Cause::BracketNotOpened, at,
                          "a value is missing before the bracket");
    case '\0':
      return e.out.refuse(inside ? Cause::BracketNotClosed : Cause::ExpressionFormat, at,
                          "a value is missing at the end");
    default:
      return e.out.refuse(Cause::ExpressionFormat, at, "a value is missing here");
  }
}

}  // namespace

Value operand(OpenExpression& e) {
  if (e.s->at != e.s->end && begins_gap(*e.s->at)) {
    e.s->pass_gap();
    return e.s->at == e.s->end ? no_operand(e) : Value::awaited();
  }
  const char c = e.s->peek();
  if (c == '#') return variable(e);
  if (c == '[') return e.open(Waiting::Kind::Bracket, e.s->offset());
  if (c == '-' || c == '+') return sign(e);
  if (is_digit(c) || c == '.') return constant(e);
  if (is_letter(c)) return word(e);
  return no_operand(e);
}

}  // namespace cncsub
