// Expressions, evaluated.
#include <algorithm>
#include <array>
#include <cmath>

#include "cncsub/machine.hpp"

namespace cncsub {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kDegree = kPi / 180.0;

/// The angle within one turn, 0 to 360 degrees.
double turn(double degrees) {
  if (!std::isfinite(degrees)) return 0;
  constexpr double kExact = 1e12;  // below, whole turns are subtracted without rounding
  if (std::fabs(degrees) < kExact) {
    const auto turns = static_cast<double>(static_cast<std::int64_t>(degrees * (1.0 / 360.0)));
    const double rest = degrees - 360.0 * turns;
    return rest < 0 ? rest + 360.0 : rest >= 360.0 ? rest - 360.0 : rest;
  }
  const double rest = std::fmod(degrees, 360.0);
  return rest < 0 ? rest + 360.0 : rest;
}

/// Sines of whole degrees, exact at multiples of 30, so that TAN[90] is told from a large value.
const std::array<double, 361> kSines = [] {
  constexpr double kThirds[] = {0,    0.5, 2,  1, 2,    0.5, 0,
                                -0.5, 2,   -1, 2, -0.5, 0};  // 2: no rational number
  std::array<double, 361> sines{};
  for (int a = 0; a <= 360; ++a) {
    const bool exact = a % 30 == 0 && kThirds[a / 30] != 2;
    sines[static_cast<std::size_t>(a)] = exact ? kThirds[a / 30] : std::sin(a * kDegree);
  }
  return sines;
}();

/// Whether the angle is a whole number of degrees, and which of one turn.
bool whole_degrees(double degrees, std::size_t& of_turn) {
  if (!(std::fabs(degrees) < 1e9)) return false;
  const auto whole = static_cast<std::int32_t>(degrees);
  if (static_cast<double>(whole) != degrees) return false;
  const std::int32_t rest = whole % 360;
  of_turn = static_cast<std::size_t>(rest < 0 ? rest + 360 : rest);
  return true;
}

double sine(double degrees) {
  if (std::size_t whole = 0; whole_degrees(degrees, whole)) return kSines[whole];
  const double a = turn(degrees);
  return std::sin(a * kDegree);
}
double cosine(double degrees) {
  if (std::size_t whole = 0; whole_degrees(degrees, whole))
    return kSines[whole < 270 ? whole + 90 : whole - 270];
  const double a = turn(degrees);
  return std::cos(a * kDegree);
}

double round_half_away(double value) { return std::round(value); }

/// The value a binary number has when its digits are read as decimal (BCD), and the other way;
/// false where it has none.
bool to_bcd(double value, double& result) {
  const double whole = round_half_away(value);
  if (whole != value || whole < 0 || whole > 99999999) return false;
  auto left = static_cast<std::uint64_t>(whole);
  std::uint64_t bits = 0;
  for (int shift = 0; left != 0; shift += 4, left /= 10) bits |= (left % 10) << shift;
  result = static_cast<double>(bits);
  return true;
}
bool from_bcd(double value, double& result) {
  const double whole = round_half_away(value);
  if (whole != value) return false;
  if (whole < 0 || whole > 4294967295.0) return false;
  auto bits = static_cast<std::uint64_t>(whole);
  double sum = 0, power = 1;
  for (; bits != 0; bits >>= 4, power *= 10) {
    if ((bits & 15u) > 9) return false;
    sum += static_cast<double>(bits & 15u) * power;
  }
  result = sum;
  return true;
}

bool as_bits(double value, std::int64_t& bits) {
  const double whole = round_half_away(value);
  if (!(std::fabs(whole) <= 4294967295.0)) return false;
  bits = static_cast<std::int64_t>(whole);
  return true;
}

}  // namespace

/// False where the expression has no value; `trap` says why.
bool Machine::compute(const Instruction* at, double& result, Trap& trap) {
  // The reader allows no more than 200 values on the stack.
  std::array<double, 210> stack;  // NOLINT: written before it is read
  double* top = stack.data();     // one behind the last value
  const double* locals = locals_.data() + static_cast<std::ptrdiff_t>(level_) * code_->locals;
  const double* commons = commons_.data();
  const Control& control = *code_->control;
  const auto fault = [&](Cause cause, const char* detail = "") {
    trap = {cause, at->at, detail};
    return false;
  };
  const auto missing = [&](const std::optional<Fault>& wrong) {
    return fault(wrong->cause, wrong->cause == Cause::IllegalVariable
                                   ? "there is no such variable"
                                   : "the variable cannot be read");
  };
  const auto number = [](double value) { return is_vacant(value) ? 0.0 : value; };
  const bool degrees = control.angle_unit.value == AngleUnit::Degrees;
  for (;; ++at) {
    switch (at->op) {
      case Ins::Constant:
        *top++ = at->value;
        break;
      case Ins::Local:
        *top++ = number(locals[at->at]);
        break;
      case Ins::LocalRaw:
        *top++ = locals[at->at];
        break;
      case Ins::Common:
        *top++ = number(commons[at->at]);
        break;
      case Ins::CommonRaw:
        *top++ = commons[at->at];
        break;
      case Ins::Variable:
      case Ins::VariableRaw: {
        double value = 0;
        if (const auto wrong = read(static_cast<std::int64_t>(at->value), value))
          return missing(wrong);
        *top++ = at->op == Ins::Variable ? number(value) : value;
        break;
      }
      case Ins::Indirect:
      case Ins::IndirectRaw: {
        const double index = round_half_away(top[-1]);
        if (!(std::fabs(index) < 2e9))
          return fault(Cause::IllegalVariable, "the variable number is out of range");
        double value = 0;
        if (const auto wrong = read(static_cast<std::int64_t>(index), value)) return missing(wrong);
        top[-1] = at->op == Ins::Indirect ? number(value) : value;
        break;
      }
      case Ins::Named: {
        const auto found = names_.find(code_->names[static_cast<std::size_t>(at->value)]);
        if (found == names_.end())
          return fault(Cause::VariableNameUnknown, "the name is not registered");
        *top++ = static_cast<double>(found->second);
        break;
      }
      case Ins::Add:
        --top;
        top[-1] += *top;
        if (!std::isfinite(top[-1])) return fault(Cause::Overflow, "the result is too large");
        break;
      case Ins::Subtract:
        --top;
        top[-1] -= *top;
        if (!std::isfinite(top[-1])) return fault(Cause::Overflow, "the result is too large");
        break;
      case Ins::Multiply:
        --top;
        top[-1] *= *top;
        if (!std::isfinite(top[-1])) return fault(Cause::Overflow, "the result is too large");
        break;
      case Ins::Divide:
        --top;
        if (*top == 0) return fault(Cause::DivisionByZero, "the divisor is 0");
        top[-1] /= *top;
        if (!std::isfinite(top[-1])) return fault(Cause::Overflow, "the result is too large");
        break;
      case Ins::AddConstant:
        top[-1] += at->value;
        break;
      case Ins::SubtractConstant:
        top[-1] -= at->value;
        break;
      case Ins::MultiplyConstant:
        top[-1] *= at->value;
        if (!std::isfinite(top[-1])) return fault(Cause::Overflow, "the result is too large");
        break;
      case Ins::DivideConstant:
        top[-1] /= at->value;
        if (!std::isfinite(top[-1])) return fault(Cause::Overflow, "the result is too large");
        break;
      case Ins::Modulo:
        if (at->value == -1) break;  // marks PRM[n,b]
        --top;
        if (*top == 0) return fault(Cause::DivisionByZero, "the divisor is 0");
        top[-1] = std::fmod(top[-1], *top);
        break;
      case Ins::And:
      case Ins::Or:
      case Ins::Xor: {
        --top;
        std::int64_t a = 0, b = 0;
        if (!as_bits(top[-1], a) || !as_bits(*top, b))
          return fault(Cause::Overflow, "AND, OR and XOR take 32 bits");
        if (!control.negative_logic.value && (a < 0 || b < 0))
          return fault(Cause::LogicOfNegative, "the value is negative");
        top[-1] = static_cast<double>(at->op == Ins::And  ? a & b
                                      : at->op == Ins::Or ? a | b
                                                          : a ^ b);
        break;
      }
      case Ins::Negate:
        top[-1] = -top[-1];
        break;
      case Ins::Equal:
        --top;
        top[-1] = top[-1] == *top || (is_vacant(top[-1]) && is_vacant(*top)) ? 1 : 0;
        break;
      case Ins::NotEqual:
        --top;
        top[-1] = top[-1] == *top || (is_vacant(top[-1]) && is_vacant(*top)) ? 0 : 1;
        break;
      case Ins::Greater:
        --top;
        top[-1] = top[-1] > *top ? 1 : 0;
        break;
      case Ins::Less:
        --top;
        top[-1] = top[-1] < *top ? 1 : 0;
        break;
      case Ins::GreaterEqual:
        --top;
        top[-1] = top[-1] >= *top ? 1 : 0;
        break;
      case Ins::LessEqual:
        --top;
        top[-1] = top[-1] <= *top ? 1 : 0;
        break;
      case Ins::BothTrue:
        --top;
        top[-1] = top[-1] != 0 && *top != 0 ? 1 : 0;
        break;
      case Ins::EitherTrue:
        --top;
        top[-1] = top[-1] != 0 || *top != 0 ? 1 : 0;
        break;
      case Ins::OneTrue:
        --top;
        top[-1] = (top[-1] != 0) != (*top != 0) ? 1 : 0;
        break;
      case Ins::Not:
        top[-1] = top[-1] == 0 ? 1 : 0;
        break;
      case Ins::Sin:
        top[-1] = degrees ? sine(top[-1]) : std::sin(top[-1]);
        break;
      case Ins::Cos:
        top[-1] = degrees ? cosine(top[-1]) : std::cos(top[-1]);
        break;
      case Ins::Tan: {
        const double c = degrees ? cosine(top[-1]) : std::cos(top[-1]);
        if (c == 0) return fault(Cause::TangentInfinite, "the tangent has no value there");
        top[-1] = (degrees ? sine(top[-1]) : std::sin(top[-1])) / c;
        break;
      }
      case Ins::Asin:
      case Ins::Acos: {
        if (!(std::fabs(top[-1]) <= 1))
          return fault(Cause::ArcSineOutOfRange, "the value is outside -1 to 1");
        double angle = at->op == Ins::Asin ? std::asin(top[-1]) : std::acos(top[-1]);
        if (degrees) angle /= kDegree;
        const bool turn =
            at->op == Ins::Asin && degrees && control.asin_range.value == AngleRange::FullTurn;
        top[-1] = turn && angle < 0 ? angle + 360 : angle;
        break;
      }
      case Ins::Atan:
        top[-1] = degrees ? std::atan(top[-1]) / kDegree : std::atan(top[-1]);
        break;
      case Ins::Atan2: {
        --top;
        double angle = std::atan2(top[-1], *top);
        if (degrees) {
          angle /= kDegree;
          if (control.atan_range.value == AngleRange::FullTurn && angle < 0) angle += 360;
        }
        top[-1] = angle;
        break;
      }
      case Ins::Sqrt:
        if (top[-1] < 0) return fault(Cause::SquareRootOfNegative, "the value is negative");
        top[-1] = std::sqrt(top[-1]);
        break;
      case Ins::Abs:
        top[-1] = std::fabs(top[-1]);
        break;
      case Ins::Round:
        top[-1] = round_half_away(top[-1]);
        break;
      case Ins::RoundWord: {
        const double step = motion_.increment(static_cast<char>(at->address));
        top[-1] = step > 0 ? round_half_away(top[-1] / step) * step : round_half_away(top[-1]);
        break;
      }
      case Ins::CutWord: {
        const double step = motion_.increment(static_cast<char>(at->address));
        constexpr double kHair = 1e-6;  // 1.235 is 1234.9999... thousandths
        if (step > 0)
          top[-1] = std::copysign(std::floor(std::fabs(top[-1]) / step + kHair) * step, top[-1]);
        break;
      }
      case Ins::Fix:
        top[-1] = std::trunc(top[-1]);
        break;
      case Ins::Fup:
        top[-1] = top[-1] < 0 ? std::floor(top[-1]) : std::ceil(top[-1]);
        break;
      case Ins::Ln:
        if (!(top[-1] > 0))
          return fault(Cause::LogarithmOfNonPositive, "the value is not positive");
        top[-1] = std::log(top[-1]);
        break;
      case Ins::Exp:
        if (top[-1] > 110) return fault(Cause::Overflow, "the result is too large");
        top[-1] = std::exp(top[-1]);
        break;
      case Ins::Pow: {
        --top;
        const double value = std::pow(top[-1], *top);
        if (std::isnan(value)) return fault(Cause::ArgumentOutOfRange, "the power has no value");
        if (std::isinf(value)) return fault(Cause::Overflow, "the result is too large");
        top[-1] = value;
        break;
      }
      case Ins::Bin:
        if (!from_bcd(top[-1], top[-1]))
          return fault(Cause::ArgumentOutOfRange, "the value is no BCD number");
        break;
      case Ins::Bcd:
        if (!to_bcd(top[-1], top[-1]))
          return fault(Cause::ArgumentOutOfRange, "the value has no BCD number");
        break;
      case Ins::Adp:
        break;
      case Ins::Parameter: {
        const bool bit_form = at[-1].op == Ins::Modulo && at[-1].value == -1;
        if (bit_form) --top;
        const double which = round_half_away(top[-1]);
        if (!(std::fabs(which) < 1e9))
          return fault(Cause::ArgumentOutOfRange, "there is no such parameter");
        std::string name = std::to_string(static_cast<std::int64_t>(which));
        if (bit_form)
          name += "#" + std::to_string(static_cast<std::int64_t>(
                            std::clamp(round_half_away(*top), 0.0, 31.0)));
        top[-1] = control.parameter(name);
        break;
      }
      case Ins::Sign:
        top[-1] = top[-1] > 0 ? 1 : top[-1] < 0 ? -1 : 0;
        break;
      case Ins::Random:  // above 0, not above the argument
        top[-1] *= static_cast<double>(random_()) / 2147483646.0;
        break;
      case Ins::RandomBetween:
        --top;
        top[-1] += (*top - top[-1]) * static_cast<double>(random_()) / 2147483646.0;
        break;
      case Ins::Programmed: {
        const auto place =
            static_cast<std::size_t>(level_ * code_->locals) + static_cast<std::size_t>(at->value);
        if (at->value >= code_->locals || programmed_.empty())
          return fault(Cause::IllegalVariable, "AR takes a local variable");
        *top++ = programmed_[place];
        break;
      }
      case Ins::End:
        result = top[-1];
        if (std::isinf(result)) return fault(Cause::Overflow, "the result is too large");
        return true;
    }
  }
}

}  // namespace cncsub
