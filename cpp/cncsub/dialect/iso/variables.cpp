// Variables of expressions: #1, #[#2+1], #NAME.
#include "cncsub/dialect/iso/open_expression.hpp"

namespace cncsub {

namespace {

constexpr const char* kNoVariable = "behind # stands a number, or an expression in brackets";

bool starts_name(Scanner& s) { return is_letter(s.peek()) || s.peek() == '_'; }

std::optional<std::int64_t> written_number(OpenExpression& e) {
  const char c = e.s->peek();
  const std::uint32_t at = e.s->offset();
  if (!is_digit(c)) return e.out.refuse(Cause::ExpressionFormat, at, kNoVariable);
  const Number number = scan_number(*e.s);
  const bool behind = number.points == 1 && number.decimals == 0 && number.any;
  const bool whole = number.points == 0 || (behind && e.rules.points);
  if (!whole || number.digits > ExpressionRules::kMostVariableDigits)
    return e.out.refuse(Cause::IllegalVariable, at, "a variable number is a whole number");
  return to_whole<std::int64_t>(number.value);
}

}  // namespace

Value variable(OpenExpression& e) {
  const std::uint32_t at = e.s->offset();
  ++e.s->at;
  std::uint32_t plain = 0;
  if (const char* const end = e.plain_number(e.s->at, plain)) {
    e.s->at = end;
    return e.out.load(plain, at);
  }
  const char first = e.s->peek();
  if (first == '[') return e.open(Waiting::Kind::Indirect, at);
  if (!is_digit(first) && starts_name(*e.s) && !e.rules.names)
    return e.out.refuse(Cause::ExpressionFormat, at, kNoVariable);
  const auto number = variable_number(e, at);
  if (!number) return {};
  if (*number != kComputed) return e.out.load(*number, at);
  return Value::variable(e.out.emit(Ins::IndirectRaw, at));
}

std::optional<std::int64_t> variable_number(OpenExpression& e, std::uint32_t at) {
  if (!is_digit(e.s->peek()) && starts_name(*e.s) && e.rules.names) {
    e.out.emit(Ins::Named, at, static_cast<double>(e.names.text(e.s->take_name())));
    return kComputed;
  }
  const auto number = written_number(e);
  if (!number || !e.rules.indirect || *number < 9000 || *number > 9999) return number;
  Value inner = e.out.load(*number - 9000, at);
  e.out.arithmetic(inner, e.s->offset());
  return kComputed;
}

}  // namespace cncsub
