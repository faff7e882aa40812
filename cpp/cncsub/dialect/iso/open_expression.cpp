#include "cncsub/dialect/iso/open_expression.hpp"

#include <string>

namespace cncsub {

// Brackets, functions, signs and operators that wait at once: as many as ExpressionRules lets be
// open, each with an operator of every level, a sign before it, and NOT.
constexpr std::size_t kMostWaiting = 600;

OpenExpression::OpenExpression(Builder& to, const ExpressionRules& rules_of)
    : rules(rules_of),
      names(to.names()),
      out(to, rules_of),
      waiting(std::make_unique_for_overwrite<Waiting[]>(kMostWaiting)) {
  waiting[0].level = Waiting::kOpening;  // nothing binds as loosely
}

bool OpenExpression::opens() {
  s->blanks();
  const std::uint32_t at = s->offset();
  if (!s->take('[')) {
    out.refuse(Cause::BracketNotOpened, at, "an opening bracket is missing here");
    return false;
  }
  ++brackets;
  if (brackets > rules.most_brackets) {
    out.refuse(Cause::BracketsTooDeep, at,
               "more than " + std::to_string(rules.most_brackets) + " brackets inside each other");
    return false;
  }
  return true;
}

bool OpenExpression::closes() {
  const char c = s->peek();
  if (c != ']') {
    if (c == '\0')
      out.refuse(Cause::BracketNotClosed, s->offset(), "a closing bracket is missing");
    else
      out.refuse(Cause::ExpressionFormat, s->offset(),
                 "an operator or a closing bracket is missing here");
    return false;
  }
  ++s->at;
  --brackets;
  return true;
}

namespace {

Value negated(OpenExpression& e, const Waiting& of, Value value) {
  --e.nots;
  if (!value.is_condition())
    return e.out.refuse(Cause::ExpressionFormat, of.at, "NOT takes a condition");
  e.out.emit(Ins::Not, of.at);
  return value;
}

/// What a function makes of its arguments.
Value function(OpenExpression& e, const Waiting& of) {
  const Ins op = of.second ? of.function->two : of.function->one;
  e.out.emit(op == Ins::Round && e.out.in_word() ? Ins::RoundWord : op, of.at);
  return Value::number();
}

/// ATAN[a]/[b], ATAN[a,b] and ATAN[a].
Value arc_tangent(OpenExpression& e, const Waiting& of) {
  Scanner ahead = *e.s;
  if (!of.second && ahead.take('/') && ahead.peek() == '[') {
    e.s->at = ahead.at;
    return e.open(Waiting::Kind::SecondArgument, of.at);
  }
  e.out.emit(of.second ? Ins::Atan2 : Ins::Atan, of.at);
  return Value::number();
}

}  // namespace

Value prefixed(OpenExpression& e, Value value) {
  while (value && e.last[-1].level == Waiting::kPrefix) {
    const Waiting& prefix = *--e.last;
    if (prefix.kind == Waiting::Kind::Not) {
      value = negated(e, prefix, value);
    } else {
      const bool constant = value.is_constant();
      const Value number = value;
      if (!e.out.arithmetic(value, e.s->offset())) return {};
      if (constant) value = number;
      if (prefix.kind == Waiting::Kind::Minus) value = e.out.negated(value, prefix.at);
    }
  }
  return value;
}

Value not_closed(OpenExpression& e, Waiting& of, bool argument) {
  const bool takes = argument && !of.second &&
                     (of.kind == Waiting::Kind::ArcTangent || of.function->two != Ins::End);
  if (takes && e.s->take(',')) {
    of.second = true;
    return Value::awaited();
  }
  if (takes && of.function->one == Ins::End)
    return e.out.refuse(Cause::MissingComma, e.s->offset(), "the function takes two arguments");
  e.closes();
  return {};
}

Value closed(OpenExpression& e, const Waiting& of, Value value) {
  if (of.kind == Waiting::Kind::Function) return function(e, of);
  if (of.kind == Waiting::Kind::ArcTangent) return arc_tangent(e, of);
  if (!e.out.arithmetic(value, e.s->offset())) return {};
  const bool indirect = of.kind == Waiting::Kind::Indirect;
  const std::uint32_t place = e.out.emit(indirect ? Ins::IndirectRaw : Ins::Atan2, of.at);
  return indirect ? Value::variable(place) : Value::number();
}

}  // namespace cncsub
