// Evaluates expressions and operands. Each function returns false where the run stopped: the alarm
// has been raised then.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "cncsub/machine/state/context.hpp"
#include "cncsub/system/compiler.hpp"

namespace cncsub {

/// The places of the locals of the present level and of the commons. They hold until a level is
/// opened.
struct Places {
  std::array<double*, 2> of;
  double& local(std::uint32_t index) const { return of[0][index]; }
  double& common(std::uint32_t index) const { return of[1][index]; }
  /// Return the place of a direct variable, perhaps to be written; null where it is another one.
  double* near(const Code& code, std::int64_t number, bool written) const {
    if (number < 0 || number > std::numeric_limits<std::int32_t>::max()) return nullptr;
    const auto of_number = static_cast<std::uint32_t>(number);
    const DirectVariables* const found = code.direct_variables.find(of_number);
    if (found == nullptr || (written && !found->writable)) return nullptr;
    return of[found->raw == Ins::CommonRaw ? 1 : 0] + found->base + (of_number - found->first);
  }
  /// Return what an instruction for a local or a common pushes.
  double load(const ExpressionCell& cell) const {
    const auto op = static_cast<std::uint32_t>(cell.op()) - static_cast<std::uint32_t>(Ins::Local);
    const double value = of[op >> 1][cell.index()];
    return (op & 1U) != 0 || !is_vacant(value) ? value : 0.0;
  }
};
static_assert(static_cast<int>(Ins::LocalRaw) == static_cast<int>(Ins::Local) + 1 &&
              static_cast<int>(Ins::Common) == static_cast<int>(Ins::Local) + 2 &&
              static_cast<int>(Ins::CommonRaw) == static_cast<int>(Ins::Local) + 3);

inline Places places(Run& run) {
  State& state = run.state;
  return {{state.locals.data() + run.local_at(state.level, 0), state.commons.data()}};
}

/// Evaluate an expression of any form. `of`: its block, where that is not the one being executed.
bool evaluate_long(Run& run, Expression expression, const Places& places, double& value,
                   Address of = kNowhere);

/// Compare two values by an instruction for which nearly equal ones are equal.
inline bool compare_alike(Ins op, double a, double b) {
  const bool alike = is_alike(a, b);
  switch (op) {
    case Ins::AlikeEqual:
      return alike;
    case Ins::AlikeNotEqual:
      return !alike;
    case Ins::AlikeGreater:
      return a > b && !alike;
    case Ins::AlikeLess:
      return a < b && !alike;
    case Ins::AlikeGreaterEqual:
      return a > b || alike;
    default:
      return a < b || alike;
  }
}

/// Compute one operation on two values; one without a finite result takes the long path.
CNCSUB_ALWAYS_INLINE inline bool join(Run& run, Expression e, const Places& places, double a,
                                      double b, double& value, Address of) {
  const auto same = [&] { return a == b || (is_vacant(a) && is_vacant(b)); };
  switch (e.op()) {
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
    case Ins::LessEqual:
      value = a <= b ? 1 : 0;
      return true;
    default:
      value = compare_alike(e.op(), a, b) ? 1 : 0;
      return true;
  }
}

/// Evaluate one value, or one operation on two, at once; what is longer or has no finite result
/// takes the long path.
CNCSUB_ALWAYS_INLINE inline bool evaluate(Run& run, Expression e, const Places& places,
                                          double& value, Address of = kNowhere) {
  const ExpressionCell* const cells = e.cells();
  double a = 0, b = 0;
  switch (e.form()) {
    case Expression::Form::Long:
      return evaluate_long(run, e, places, value, of);
    case Expression::Form::Constant:
      value = cells[0].value();
      return true;
    case Expression::Form::Variable:
      value = places.load(cells[0]);
      return true;
    case Expression::Form::TwoVariables:
      a = places.load(cells[0]);
      b = places.load(cells[1]);
      break;
    case Expression::Form::VariableAndConstant:
    case Expression::Form::VariableToConstant:
      a = places.load(cells[0]);
      b = cells[2].value();
      break;
    case Expression::Form::ConstantAndVariable:
      a = cells[1].value();
      b = places.load(cells[2]);
      break;
  }
  return join(run, e, places, a, b, value, of);
}

inline bool evaluate(Run& run, std::uint32_t expression, double& value, Address of = kNowhere) {
  return evaluate(run, run.code->expression(expression), places(run), value, of);
}

/// Evaluate a condition, and keep what it compares.
bool evaluate_and_keep(Run& run, Expression e, const Places& places, double& value);
/// Evaluate a condition, and keep what it compares where the run is asked to.
CNCSUB_ALWAYS_INLINE inline bool evaluate_condition(Run& run, Expression e, const Places& places,
                                                    double& value) {
  if (run.options.conditions) [[unlikely]]
    return evaluate_and_keep(run, e, places, value);
  return evaluate(run, e, places, value);
}
inline bool evaluate_condition(Run& run, std::uint32_t condition, double& value) {
  return evaluate_condition(run, run.code->expression(condition), places(run), value);
}

bool evaluate_operand(Run& run, const Operand& operand, double& value);
/// Read the value of a word of a call, a return or a jump; vacant where it is absent.
inline bool value_of(Run& run, const Operand& operand, double& value) {
  if (operand.kind == Operand::Kind::Expression) return evaluate_operand(run, operand, value);
  value = operand.kind == Operand::Kind::Absent ? kVacant : operand.value;
  return true;
}

/// Convert a whole value: take its digits to the base `from` as digits to the base `to`: BIN, BCD,
/// H24, H25. Return false where these are not one to eight decimal digits.
bool read_digits(double value, int from, int to, double& result);

}  // namespace cncsub
