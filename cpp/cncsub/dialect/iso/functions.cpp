// The functions of expressions: SIN[30], ATAN[1]/[2], PRM[6001, 5], and words that are values.
#include "cncsub/dialect/iso/open_expression.hpp"

namespace cncsub {

namespace {

constexpr int kMostNots = 64;  // that wait at once

struct ConstantName {
  Function word;
  double value;
};
constexpr ConstantName kConstants[] = {
    {Function::Pi, 3.14159265358979323846}, {Function::True, 1}, {Function::False, 0}};

/// AR[#23]: how the word was programmed, so the variable itself counts, by its number.
Value programmed(OpenExpression& e, std::uint32_t at) {
  if (!e.opens() || e.s->peek() != '#')
    return e.out.refuse(Cause::ExpressionFormat, at, "AR takes a variable");
  const std::uint32_t hash = e.s->offset();
  ++e.s->at;
  const bool inside = e.s->peek() == '[';
  const std::optional<std::int64_t> number = inside ? kComputed : variable_number(e, hash);
  if (!number || *number == kComputed)
    return e.out.refuse(Cause::ExpressionFormat, at, "AR takes a variable");
  if (!e.closes()) return {};
  e.out.emit(Ins::Programmed, at, static_cast<double>(*number));
  return Value::number();
}

/// NOT before a condition.
Value negation(OpenExpression& e, std::uint32_t at) {
  if (++e.nots > kMostNots)
    return e.out.refuse(Cause::ExpressionFormat, at, "too many NOT in a row");
  return e.wait(Waiting::Kind::Not, at);
}

}  // namespace

Value word(OpenExpression& e) {
  const std::uint32_t at = e.s->offset();
  std::string word;
  while (is_letter(e.s->peek()) || (word == "ATAN" && e.s->peek() == '2')) {
    word += e.s->peek();
    ++e.s->at;
    if (word.size() > 8) break;
  }
  for (const ConstantName& of : kConstants) {
    if (word != name_of(of.word) || !e.rules.has(of.word)) continue;
    return e.out.constant(of.value, at);
  }
  if (word == "NOT" && e.rules.bare) return negation(e, at);
  const FunctionName* found = e.rules.function(word);
  if (found == nullptr)
    return e.out.refuse(Cause::ExpressionFormat, at, word + " is no function of this control");
  if (found->one == Ins::Programmed) return programmed(e, at);
  const bool slash = found->one == Ins::Atan && !e.rules.has(Function::Atan2);
  return e.open(slash ? Waiting::Kind::ArcTangent : Waiting::Kind::Function, at, found);
}

}  // namespace cncsub
