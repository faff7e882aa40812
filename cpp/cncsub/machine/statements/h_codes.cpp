// The statements of the GSK controls: G65 H.
#include <algorithm>
#include <cmath>
#include <string>

#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/statements/output.hpp"
#include "cncsub/machine/statements/statements.hpp"
#include "cncsub/machine/values/expressions.hpp"
#include "cncsub/machine/values/variables.hpp"

namespace cncsub {

namespace {

bool wrong(Run& run, const Statement& h, Cause cause, const Operand& word, const char* detail) {
  return alarm(run, {cause, word.present() ? word.at : h.at, word.width, detail});
}

/// Return how many operands, Q and R, an H code that calculates takes; 0 where it is none.
int operands_of(int code) {
  switch (code) {
    case 1:
    case 21:
    case 22:
    case 24:
    case 25:
      return 1;
    case 2:
    case 3:
    case 4:
    case 5:
    case 11:
    case 12:
    case 13:
    case 23:
    case 26:
    case 27:
    case 31:
    case 32:
    case 33:
    case 34:
      return 2;
    default:
      return 0;
  }
}

/// Find the variable that P of a G65 H statement names: `P#100` is #100 itself.
bool variable_of(Run& run, const Operand& operand, std::int64_t& number) {
  if (operand.kind != Operand::Kind::Expression) return false;
  const Code& code = *run.code;
  const Expression of = code.expression(operand.expression);
  auto at = of.begin();
  const Instruction first = *at;
  switch (first.op) {
    case Ins::LocalRaw:
    case Ins::CommonRaw:
    case Ins::VariableRaw:
    case Ins::Local:
    case Ins::Common:
    case Ins::Variable:
      number = to_whole<std::int64_t>(first.value);
      break;
    case Ins::Constant:
      number = 0;
      break;
    default:
      return false;
  }
  ++at;
  if (at != Expression::end() && (*at).op == Ins::IndirectRaw) {  // #9100
    double index = 0;
    if (read_variable(run, number, index).has_value()) return false;
    number =
        to_whole<std::int64_t>(std::clamp(is_vacant(index) ? 0.0 : std::round(index), 0.0, 1e9));
  }
  return true;
}

std::optional<Cause> logic(const Run& run, int code, double q, double r, double& result) {
  const auto bits = [](double value) {
    return to_whole<std::int64_t>(std::clamp(std::round(value), -4294967295.0, 4294967295.0));
  };
  if (run.refuses(Cause::LogicOfNegative) && (q < 0 || r < 0)) return Cause::LogicOfNegative;
  const std::int64_t left = bits(q), right = bits(r);
  if (run.refuses(Cause::LogicOfBits) && ((left | right) & ~1) != 0) return Cause::LogicOfBits;
  result = static_cast<double>(code == 11   ? left | right
                               : code == 12 ? left & right
                                            : left ^ right);
  return std::nullopt;
}

double radians(double degrees) { return degrees * 3.14159265358979323846 / 180.0; }

std::optional<Cause> trigonometry(const Control& control, int code, double q, double r,
                                  double& result) {
  switch (code) {
    case 31:
      result = q * std::sin(radians(r));
      return std::nullopt;
    case 32:
      result = q * std::cos(radians(r));
      return std::nullopt;
    case 33:
      if (std::fabs(std::fmod(std::fabs(r), 180.0) - 90.0) < 1e-9) return Cause::TangentInfinite;
      result = q * std::tan(radians(r));
      return std::nullopt;
    default: {
      if (q == 0 && r == 0) return Cause::DivisionByZero;
      const double angle = std::atan2(q, r) / radians(1);
      const bool turn = control.macros.atan_range.value == AngleRange::FullTurn;
      result = turn && angle < 0 ? angle + 360 : angle;
      return std::nullopt;
    }
  }
}

std::optional<Cause> arithmetic(Run& run, int code, double q, double r, std::int64_t target,
                                double& result) {
  const bool divides = code == 5 || code == 23 || code == 26;
  if (divides && r == 0) return Cause::DivisionByZero;
  switch (code) {
    case 1:
      result = q;
      break;
    case 2:
      result = q + r;
      break;
    case 3:
      result = q - r;
      break;
    case 4:
      result = q * r;
      break;
    case 5:
      result = q / r;
      break;
    case 22:
      result = std::fabs(q);
      break;
    case 23:
      result = q - std::trunc(q / r) * r;
      break;
    case 26: {
      double old = 0;
      if (auto fault = read_variable(run, target, old)) return fault->cause;
      result = (is_vacant(old) ? 0 : old) * q / r;
      break;
    }
    default:  // 27
      result = std::hypot(q, r);
      break;
  }
  return std::nullopt;
}

std::optional<Cause> calculate(Run& run, int code, double q, double r, std::int64_t target,
                               double& result) {
  if (code >= 11 && code <= 13) return logic(run, code, q, r, result);
  if (code >= 31) return trigonometry(run.control(), code, q, r, result);
  switch (code) {
    case 21:
      if (q < 0) return Cause::SquareRootOfNegative;
      result = std::sqrt(q);
      return std::nullopt;
    case 24:
    case 25:
      if (read_digits(q, code == 24 ? 16 : 10, code == 24 ? 10 : 16, result)) return std::nullopt;
      return Cause::ArgumentOutOfRange;
    default:
      return arithmetic(run, code, q, r, target, result);
  }
}

/// What H81 to H86 compare Q and R by.
constexpr Ins kComparisons[] = {Ins::Equal, Ins::NotEqual,     Ins::Greater,
                                Ins::Less,  Ins::GreaterEqual, Ins::LessEqual};

/// Execute H80 to H86: jumps, always or where Q and R compare so.
bool jump(Run& run, const HCode& h, double q, double r, bool& holds) {
  const int code = h.number;
  if (!h.p.present()) return wrong(run, h, Cause::HCodeFormat, h.p, "the jump has no P");
  if (code > 80 && (!h.q.present() || !h.r.present()))
    return wrong(run, h, Cause::HCodeOperand, h.q, "the comparison must have Q and R");
  const bool compared[] = {true, q == r, q != r, q > r, q < r, q >= r, q <= r};
  holds = compared[code - 80];
  if (code > 80 && run.options.conditions)
    run.trace.compared.push(
        {run.state.executed, q, r, run.state.pc, kComparisons[code - 81], holds});
  if (!holds) return true;
  double value = 0;
  if (!value_of(run, h.p, value) || !may_jump(run, h)) return false;
  const std::int64_t n =
      is_vacant(value) ? -1 : to_whole<std::int64_t>(std::clamp(std::round(value), -1.0, 2e9));
  const Program& program = run.program();
  const Address to = n < 0 ? kNowhere : run.code->jump_target(program, n, run.state.pc);
  if (to != kNowhere) return jump_to(run, to);
  return alarm(run, {Cause::JumpTargetNotFound, h.p.at, h.p.width, run.code->no_block(n, program)});
}

/// Execute H99 P15 (TEXT).
bool raise_alarm(Run& run, const HCode& h) {
  double n = 0;
  if (!value_of(run, h.p, n)) return false;
  const double number = is_vacant(n) ? -1 : std::round(n);
  if (number < 0 || number > 99)
    return wrong(run, h, Cause::IllegalUserAlarm, h.p, "H99 raises alarms 0 to 99");
  std::string text = comment_of(run, h);
  if (!text.empty() && text[0] == '/') text.erase(0, 1);
  if (run.observer != nullptr) run.observer->raised = &h;
  if (run.observer != nullptr) run.observer->raised_number = number;
  const int first = run.control().macros.h99_offset.value;
  return alarm_of_program(run, h, text, std::to_string(first + to_whole<int>(number)));
}

}  // namespace

bool h_code(Run& run, const HCode& h, bool& holds) {
  const int code = h.number;
  double q = 0, r = 0;
  if (!value_of(run, h.q, q) || !value_of(run, h.r, r)) return false;
  if (h.q.present() && is_vacant(q) && code != 1) q = 0;
  if (h.r.present() && is_vacant(r)) r = 0;
  if (code == 99) return raise_alarm(run, h);
  if (code >= 80 && code <= 86) return jump(run, h, q, r, holds);
  const int operands = operands_of(code);
  if (operands == 0)
    return alarm(run,
                 {Cause::IllegalHCode, h.variable_at, h.variable_width, "there is no such H code"});
  std::int64_t target = 0;
  if (!h.p.present() || !variable_of(run, h.p, target))
    return wrong(run, h, Cause::HCodeFormat, h.p, "P must name the variable for the result");
  if (!h.q.present() || (operands == 2 && !h.r.present()))
    return wrong(run, h, Cause::HCodeOperand, h.q, "an operand is missing");
  double result = 0;
  if (auto cause = calculate(run, code, q, r, target, result))
    return wrong(run, h, *cause, h.q, "");
  if (!(std::fabs(result) <= kLargest))
    return wrong(run, h, Cause::Overflow, h.q, "the result is too large");
  Statement assignment = h;
  assignment.target = Statement::Target::Variable;
  assignment.variable_at = h.p.at;
  assignment.variable_width = h.p.width;
  return store_number(run, target, result, assignment);
}

}  // namespace cncsub
