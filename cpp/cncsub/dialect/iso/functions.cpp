// The functions of expressions: SIN[30], ATAN[1]/[2], PRM[6001, 5], and words that are values.
#include "cncsub/dialect/iso/expression.hpp"

namespace cncsub {

namespace {

constexpr int kMostNots = 64;  // that wait at once

struct ConstantName {
  Function word;
  double value;
};
constexpr ConstantName kConstants[] = {
    {Function::Pi, 3.14159265358979323846}, {Function::True, 1}, {Function::False, 0}};

}  // namespace

Value ExpressionReader::word() {
  const std::uint32_t at = s_->offset();
  std::string word;
  while (is_letter(s_->peek()) || (word == "ATAN" && s_->peek() == '2')) {
    word += s_->peek();
    ++s_->at;
    if (word.size() > 8) break;
  }
  for (const ConstantName& of : kConstants) {
    if (word != name_of(of.word) || !rules_.has(of.word)) continue;
    if (!out_.has_room(s_->offset())) return {};
    out_.emit(Ins::Constant, at, of.value);
    return Value::number();
  }
  if (word == "NOT" && rules_.bare) return negation(at);
  const FunctionName* found = rules_.function(word);
  if (found == nullptr)
    return out_.refuse(Cause::ExpressionFormat, at, word + " is no function of this control");
  if (found->one == Ins::Programmed) return programmed(at);
  const bool slash = found->one == Ins::Atan && !rules_.has(Function::Atan2);
  return open(slash ? Waiting::Kind::ArcTangent : Waiting::Kind::Function, at, found);
}

/// What stands behind an argument or a value in brackets and does not close them: a comma, or the
/// expression is refused.
Value ExpressionReader::not_closed(Waiting& of, bool argument) {
  const bool takes = argument && !of.second &&
                     (of.kind == Waiting::Kind::ArcTangent || of.function->two != Ins::End);
  if (takes && s_->take(',')) {
    of.second = true;
    return Value::awaited();
  }
  if (takes && of.function->one == Ins::End)
    return out_.refuse(Cause::MissingComma, s_->offset(), "the function takes two arguments");
  closes();
  return {};
}

/// What is made of the value in brackets that are neither a function's nor stand alone.
Value ExpressionReader::other_closed(const Waiting& of, Value value) {
  if (of.kind == Waiting::Kind::ArcTangent) return arc_tangent(of);
  if (!out_.arithmetic(value, s_->offset())) return {};
  const bool indirect = of.kind == Waiting::Kind::Indirect;
  out_.emit(indirect ? Ins::IndirectRaw : Ins::Atan2, of.at);
  return indirect ? out_.last() : Value::number();
}

/// ATAN[a]/[b], ATAN[a,b] and ATAN[a].
Value ExpressionReader::arc_tangent(const Waiting& of) {
  Scanner ahead = *s_;
  if (!of.second && ahead.take('/') && ahead.peek() == '[') {
    s_->at = ahead.at;
    return open(Waiting::Kind::SecondArgument, of.at);
  }
  out_.emit(of.second ? Ins::Atan2 : Ins::Atan, of.at);
  return Value::number();
}

/// AR[#23]: how the word was programmed, so the variable itself counts.
Value ExpressionReader::programmed(std::uint32_t at) {
  if (!opens() || s_->peek() != '#')
    return out_.refuse(Cause::ExpressionFormat, at, "AR takes a variable");
  const std::uint32_t hash = s_->offset();
  s_->take('#');
  const auto target = variable_here(hash);
  if (!target || target->number < 0)
    return out_.refuse(Cause::ExpressionFormat, at, "AR takes a variable");
  if (!closes() || !out_.has_room(s_->offset())) return {};
  out_.emit(Ins::Programmed, at, static_cast<double>(target->number));
  return Value::number();
}

/// NOT before a condition.
Value ExpressionReader::negation(std::uint32_t at) {
  if (++nots_ > kMostNots) return out_.refuse(Cause::ExpressionFormat, at, "too many NOT in a row");
  return wait(Waiting::Kind::Not, at);
}

Value ExpressionReader::negated(const Waiting& of, Value value) {
  --nots_;
  if (!value.is_condition())
    return out_.refuse(Cause::ExpressionFormat, of.at, "NOT takes a condition");
  out_.emit(Ins::Not, of.at);
  return value;
}

}  // namespace cncsub
