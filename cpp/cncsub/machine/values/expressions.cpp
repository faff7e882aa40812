#include "cncsub/machine/values/expressions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cncsub/control/variable_table.hpp"
#include "cncsub/machine/state/limits.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/values/instructions.hpp"

namespace cncsub {

bool read_digits(double value, int from, int to, double& result) {
  const bool known = value >= 0 && value <= 4294967295.0 && value == std::floor(value);
  if (!known) return false;  // nor has a vacant value any digits
  double sum = 0, power = 1;
  int digits = 0;
  for (auto left = to_whole<std::int64_t>(value); left != 0; left /= from, power *= to) {
    if (left % from > 9 || ++digits > 8) return false;
    sum += static_cast<double>(left % from) * power;
  }
  result = sum;
  return true;
}

namespace {

using instruction::Evaluation;
using instruction::Fallible;
using instruction::InstructionView;
using instruction::Trap;

inline bool take(double from, double& value) {
  value = from;
  return true;
}
inline bool take(const Fallible& from, double& value) {
  if (!from) [[unlikely]]
    return false;
  value = *from;
  return true;
}

/// Compute an expression; return false where it has no value, for which the trap says why. The last
/// value lies in `a`, a register; those before it on the stack, `below` the place of the next.
bool compute(const ExpressionCell* at, const Evaluation& e, double* below, double& result) {
  double a = 0;
  for (;;) {
    double made = 0;
    switch (at->op()) {
#define INS_Push(name, function)                                                  \
  case Ins::name:                                                                 \
    if (!take(instruction::function(e, InstructionView{at}), made)) return false; \
    *below++ = a;                                                                 \
    a = made;                                                                     \
    at += cells_of(Ins::name);                                                    \
    break;
#define INS_Change(name, function)                                                \
  case Ins::name:                                                                 \
    if (!take(instruction::function(e, InstructionView{at}, a), a)) return false; \
    at += cells_of(Ins::name);                                                    \
    break;
#define INS_Join(name, function)                                                            \
  case Ins::name:                                                                           \
    if (!take(instruction::function(e, InstructionView{at}, *--below, a), a)) return false; \
    at += cells_of(Ins::name);                                                              \
    break;
#define INS_Take(name, function) \
  case Ins::name:                \
    return take(instruction::finite_or_vacant(e, InstructionView{at}, a), result);
#define INS(name, effect, holds, function) INS_##effect(name, function)
#include "cncsub/code/ins.def"
#undef INS
#undef INS_Push
#undef INS_Change
#undef INS_Join
#undef INS_Take
    }
  }
}

/// One operation on two values, with the End that is left out where it is kept.
class Ended {
 public:
  explicit Ended(Expression e) {
    *std::copy_n(e.cells(), e.size(), cells_.begin()) = ExpressionCell::of(Ins::End, 0, e.at());
  }
  const ExpressionCell* cells() const { return cells_.data(); }

 private:
  std::array<ExpressionCell, 5> cells_;
};

/// Compute an expression with a stack that is large enough: each value that waits is written
/// somewhere, one character at least.
bool compute(Expression of, const Evaluation& e, double& result) {
  constexpr std::size_t kOrdinary = 250, kSpare = 10;
  std::array<double, kOrdinary + kSpare> stack;  // NOLINT: written before it is read
  if (of.form() != Expression::Form::Long)
    return compute(Ended(of).cells(), e, stack.data(), result);
  if (of.width() <= kOrdinary) [[likely]]
    return compute(of.cells(), e, stack.data(), result);
  std::vector<double> large(of.width() + kSpare);
  return compute(of.cells(), e, large.data(), result);
}

}  // namespace

bool evaluate_long(Run& run, Expression e, const Places& places, double& value, Address of) {
  if (e.width() > kLongText) look_soon(run);
  Trap trap;
  const Control& control = run.control();
  const Evaluation evaluation{run,
                              places,
                              control,
                              control.macros.angle_unit.value == AngleUnit::Degrees,
                              of != kNowhere ? of : run.state.pc,
                              trap};
  if (compute(e, evaluation, value)) [[likely]]
    return true;
  const std::uint32_t first = e.at();
  const bool inside = trap.at >= first && trap.at <= first + e.width();
  std::string detail = trap.detail;
  if (trap.variable != Trap::kNoVariable) {
    const std::string name = "#" + std::to_string(trap.variable);
    detail = trap.cause == Cause::IllegalVariable ? no_variable(control, trap.variable)
                                                  : name + " cannot be read";
  }
  Fault fault{trap.cause, inside ? trap.at : first, 0, std::move(detail)};
  fault.block = of;
  fault.name = trap.function;
  if (!trap.name.empty()) {
    fault.name = trap.name;
    fault.detail = "#<" + fault.name + "> has no value";
  }
  return alarm(run, fault);
}

bool evaluate_operand(Run& run, const Operand& operand, double& value) {
  if (!evaluate(run, operand.expression, value)) return false;
  if (std::fabs(value) > kLargest)  // a vacant value compares false
    return alarm(run, {Cause::Overflow, operand.at, operand.width, "the result is too large"});
  return true;
}

}  // namespace cncsub
