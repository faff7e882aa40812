// Expressions and operands, evaluated. Each function is false where the run stopped: the alarm has
// been raised then.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "cncsub/machine/context.hpp"
#include "cncsub/system/compiler.hpp"

namespace cncsub {

/// Where constants, the locals of the present level and the commons lie, as a Load and the target
/// of a statement tell. It holds until a level is opened.
struct Places {
  std::array<double*, 3> of;
  double load(const Expression::Load& from) const {
    const double value = from.from == Expression::Load::From::Constant
                             ? from.value
                             : of[static_cast<std::size_t>(from.from)][from.index];
    return from.raw || !is_vacant(value) ? value : 0.0;
  }
};

inline Places places(Run& run) {
  State& state = run.state;
  return {{nullptr, state.locals.data() + run.local_at(state.level, 0), state.commons.data()}};
}

/// `of`: the block that the expression stands in, where it is not the one that is being executed.
bool evaluate_long(Run& run, const Expression& expression, const Places& places, double& value,
                   Address of = kNowhere);

/// One value, or one operation on two, at once; what is longer or has no finite result goes the
/// long way.
CNCSUB_ALWAYS_INLINE inline bool evaluate(Run& run, const Expression& e, const Places& places,
                                          double& value, Address of = kNowhere) {
  if (e.form == Expression::Form::Long) return evaluate_long(run, e, places, value, of);
  const double a = places.load(e.loads[0]);
  if (e.form == Expression::Form::One) {
    value = a;
    return true;
  }
  const double b = places.load(e.loads[1]);
  const auto same = [&] { return a == b || (is_vacant(a) && is_vacant(b)); };
  switch (e.op) {
    case Ins::Add:
      value = a + b;
      return std::isfinite(value) || evaluate_long(run, e, places, value, of);
    case Ins::Subtract:
      value = a - b;
      return std::isfinite(value) || evaluate_long(run, e, places, value, of);
    case Ins::Multiply:
      value = a * b;
      return std::isfinite(value) || evaluate_long(run, e, places, value, of);
    case Ins::Equal:
      value = same() ? 1 : 0;
      return true;
    case Ins::NotEqual:
      value = same() ? 0 : 1;
      return true;
    case Ins::Greater:
      value = a > b ? 1 : 0;
      return true;
    case Ins::Less:
      value = a < b ? 1 : 0;
      return true;
    case Ins::GreaterEqual:
      value = a >= b ? 1 : 0;
      return true;
    default:
      value = a <= b ? 1 : 0;
      return true;
  }
}

inline bool evaluate(Run& run, std::uint32_t expression, double& value, Address of = kNowhere) {
  return evaluate(run, run.code->expressions[expression], places(run), value, of);
}

bool evaluate_operand(Run& run, const Operand& operand, double& value);
/// The value of a word of a call, a return or a jump; vacant where it is absent.
inline bool value_of(Run& run, const Operand& operand, double& value) {
  if (operand.kind == Operand::Kind::Expression) return evaluate_operand(run, operand, value);
  value = operand.kind == Operand::Kind::Absent ? kVacant : operand.value;
  return true;
}

/// The number whose digits to the base `to` are those of a whole value to the base `from`: BIN,
/// BCD, H24, H25. False where these are not one to eight decimal digits.
bool read_digits(double value, int from, int to, double& result);

}  // namespace cncsub
