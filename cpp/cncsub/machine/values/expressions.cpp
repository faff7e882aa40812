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
#include "cncsub/machine/values/frame_instructions.hpp"
#include "cncsub/machine/values/instructions.hpp"
#include "cncsub/machine/values/text_instructions.hpp"

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

constexpr bool compares(Ins op) {
  return (op >= Ins::Equal && op <= Ins::AlikeLessEqual) || op == Ins::NearlyEqual ||
         op == Ins::NearlyNotEqual;
}

/// Keeps nothing of what comparisons compare.
struct KeepsNothing {
  static constexpr bool kKeeps = false;
};

/// Keeps what comparisons compare as rows of the running step.
class KeepsCompared {
 public:
  static constexpr bool kKeeps = true;

  explicit KeepsCompared(Run& run) : run_(run), before_(run.trace.compared.size()) {}

  /// Note whether the value that comes next is a vacant variable, which may count as 0.
  void push(Ins op, const ExpressionCell& cell, const Places& places) {
    left_ = right_;
    right_ = (op == Ins::Local && is_vacant(places.local(cell.index()))) ||
             (op == Ins::Common && is_vacant(places.common(cell.index())));
  }
  void change() { right_ = false; }
  void join() { left_ = right_ = false; }

  void keep(Ins op, double left, double right, double result) {
    run_.trace.compared.push({run_.state.executed, left_ ? kVacant : left, right_ ? kVacant : right,
                              run_.state.pc, exact(op), result != 0});
  }
  /// Keep a condition that compared nothing.
  void keep_value(double value) {
    if (run_.trace.compared.size() == before_)
      run_.trace.compared.push(
          {run_.state.executed, value, kVacant, run_.state.pc, Ins::End, value != 0});
  }

 private:
  Run& run_;
  std::size_t before_;
  bool left_ = false, right_ = false;  // of the last two values: a vacant variable alone
};

/// Compute an expression; return false where it has no value, for which the trap says why. The last
/// value lies in `a`, a register; those before it on the stack, `below` the place of the next.
template <class Keeps>
bool compute(const ExpressionCell* at, const Evaluation& e, double* below, double& result,
             Keeps& kept) {
  double a = 0;
  for (;;) {
    double made = 0;
    switch (at->op()) {
#define INS_Push(name, function)                                                  \
  case Ins::name:                                                                 \
    if (!take(instruction::function(e, InstructionView{at}), made)) return false; \
    if constexpr (Keeps::kKeeps) kept.push(Ins::name, *at, e.places);             \
    *below++ = a;                                                                 \
    a = made;                                                                     \
    at += cells_of(Ins::name);                                                    \
    break;
#define INS_Change(name, function)                                                \
  case Ins::name:                                                                 \
    if (!take(instruction::function(e, InstructionView{at}, a), a)) return false; \
    if constexpr (Keeps::kKeeps) kept.change();                                   \
    at += cells_of(Ins::name);                                                    \
    break;
#define INS_Join(name, function)                                                              \
  case Ins::name: {                                                                           \
    const double left = *--below, right = a;                                                  \
    if (!take(instruction::function(e, InstructionView{at}, left, right), a)) return false;   \
    if constexpr (Keeps::kKeeps && compares(Ins::name)) kept.keep(Ins::name, left, right, a); \
    if constexpr (Keeps::kKeeps) kept.join();                                                 \
    at += cells_of(Ins::name);                                                                \
    break;                                                                                    \
  }
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
template <class Keeps>
bool compute(Expression of, const Evaluation& e, double& result, Keeps& kept) {
  constexpr std::size_t kOrdinary = 250, kSpare = 10;
  std::array<double, kOrdinary + kSpare> stack;  // NOLINT: written before it is read
  if (of.form() != Expression::Form::Long)
    return compute(Ended(of).cells(), e, stack.data(), result, kept);
  if (of.width() <= kOrdinary) [[likely]]
    return compute(of.cells(), e, stack.data(), result, kept);
  std::vector<double> large(of.width() + kSpare);
  return compute(of.cells(), e, large.data(), result, kept);
}

template <class Keeps>
bool evaluate_keeping(Run& run, Expression e, const Places& places, double& value, Address of,
                      Keeps& kept) {
  if (e.width() > kLongText) look_soon(run);
  Trap trap;
  const Control& control = run.control();
  const Evaluation evaluation{run,
                              places,
                              control,
                              control.macros.angle_unit.value == AngleUnit::Degrees,
                              of != kNowhere ? of : run.state.pc,
                              trap};
  if (compute(e, evaluation, value, kept)) [[likely]]
    return true;
  const std::uint32_t first = e.at();
  const bool inside = trap.at >= first && trap.at <= first + e.width();
  std::string detail = trap.detail;
  if (trap.variable != Trap::kNoVariable) {
    const Spelling& spelling = *run.code->spelling;
    detail = trap.cause == Cause::IllegalVariable
                 ? no_variable(control, spelling.variable, trap.variable)
                 : spelling.name_of_variable(control, trap.variable) + " cannot be read";
  }
  Fault fault{trap.cause, inside ? trap.at : first, inside ? 0 : e.width(), std::move(detail)};
  fault.block = of;
  fault.name = trap.function;
  if (!trap.name.empty()) {
    fault.name = trap.name;
    const bool numbered = run.code->spelling->numbered;
    fault.detail = (numbered ? "#<" + fault.name + ">" : fault.name) + " has no value";
  }
  return alarm(run, fault);
}

}  // namespace

bool evaluate_long(Run& run, Expression e, const Places& places, double& value, Address of) {
  KeepsNothing kept;
  return evaluate_keeping(run, e, places, value, of, kept);
}

bool evaluate_and_keep(Run& run, Expression e, const Places& places, double& value) {
  KeepsCompared kept(run);
  const bool known = e.form() == Expression::Form::Constant
                         ? evaluate(run, e, places, value)
                         : evaluate_keeping(run, e, places, value, kNowhere, kept);
  if (known) kept.keep_value(value);
  return known;
}

bool evaluate_operand(Run& run, const Operand& operand, double& value) {
  if (!evaluate(run, operand.expression, value)) return false;
  if (std::fabs(value) > kLargest)  // a vacant value compares false
    return alarm(run, {Cause::Overflow, operand.at, operand.width, "the result is too large"});
  return true;
}

}  // namespace cncsub
