// The loop that reads every expression: operands and operators, and what waits for them.
#include <span>

#include "cncsub/dialect/iso/expression.hpp"

namespace cncsub {

namespace {

class ValueLoop {
 public:
  explicit ValueLoop(OpenExpression& e) : e_(e) {}

  /// Reads until what waits above `base` has its value; `alone`: no operator behind that is read.
  Value values(const Waiting* base, bool alone) {
    for (;;) {
      Value value = operand(e_);
      if (value) value = behind(value, base, alone);
      if (!value.is_awaited()) return value;
    }
  }

 private:
  /// What ends here gives its value to what was opened last: the value of that, or another argument
  /// is awaited.
  Value closed(Value value) {
    Waiting& of = e_.last[-1];
    const bool argument =
        of.kind == Waiting::Kind::Function || of.kind == Waiting::Kind::ArcTangent;
    if (argument && !e_.out.arithmetic(value, e_.s->offset())) return {};
    const bool one_more = argument && of.function->one == Ins::End && !of.second;
    if (e_.s->peek() != ']' || one_more) return not_closed(e_, of, argument);
    ++e_.s->at;
    --e_.brackets;
    --e_.last;
    return of.kind == Waiting::Kind::Bracket ? value : cncsub::closed(e_, of, value);
  }

  /// Joins a value with what waits on its left and binds as closely.
  Value join(Value value, int level) {
    while (value && e_.last[-1].level >= level) {
      const Waiting& left = *--e_.last;
      value = apply(e_.out, *left.of, left.at, left.left, value, e_.s->offset());
    }
    return value;
  }

  /// An operator stands behind the value: both wait for what comes.
  Value operates(const OperatorName& of, Value value) {
    int level = level_of(e_.rules, of);
    if (e_.rules.numbers_first && of.is_logic()) {
      value = join(value, of.alike + 1);
      if (!value) return value;
      if (is_of_numbers(of, value)) level = of.alike + 1;
    }
    value = join(value, level);
    if (!value) return value;
    Waiting& waiting = *e_.last++;
    waiting.left = value;
    waiting.of = &of;
    waiting.at = e_.s->offset();
    waiting.level = level;
    waiting.kind = Waiting::Kind::Operator;
    e_.s->take_word(of.text);
    return Value::awaited();
  }

  bool is_of_numbers(const OperatorName& of, const Value& value) const {
    const Waiting* first = e_.last;
    while (first[-1].level > Waiting::kOpening) --first;
    return cncsub::is_of_numbers(*e_.s, of, value, {first, e_.last});
  }

  /// What stands behind an operand: the whole value, or an operand is awaited.
  Value behind(Value value, const Waiting* base, bool alone) {
    while (value) {
      if (e_.last[-1].level == Waiting::kPrefix) value = prefixed(e_, value);
      if (!value || (alone && e_.last == base)) return value;
      e_.s->blanks();
      if (const OperatorName* const next = find_operator(e_.rules, *e_.s))
        return operates(*next, value);
      value = join(value, 0);
      if (!value || e_.last == base) return value;
      value = closed(value);
    }
    return value;
  }

  OpenExpression& e_;
};

}  // namespace

Value ExpressionReader::values(const Waiting* base, bool alone) {
  return ValueLoop(e_).values(base, alone);
}

/// What stands in brackets.
Value ExpressionReader::bracket() {
  if (!e_.opens()) return {};
  const Value value = expression();
  return value && e_.closes() ? value : Value{};
}

/// The variable of an assignment, where more than digits stand behind its #.
std::optional<ExpressionReader::Variable> ExpressionReader::other_target(Scanner& s,
                                                                         std::uint32_t hash) {
  e_.out.begin(0);
  const bool inside = s.peek() == '[';
  const std::uint32_t at = inside ? s.offset() : hash;
  if (inside) {
    Value inner = taken(s, plain_.bracket(s));
    if (!inner) {
      e_.begin(s);
      inner = bracket();
    }
    if (!inner || !e_.out.arithmetic(inner, s.offset())) return std::nullopt;
    return Variable{kComputed, e_.out.finish(at, s.offset() - at)};
  }
  e_.begin(s);
  const auto number = variable_number(e_, at);
  if (!number) return std::nullopt;
  if (*number != kComputed) return Variable{*number, 0};
  return Variable{kComputed, e_.out.finish(at, 1)};
}

}  // namespace cncsub
