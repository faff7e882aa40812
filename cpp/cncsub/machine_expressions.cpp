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
    const auto turns = static_cast<double>(to_whole<std::int64_t>(degrees * (1.0 / 360.0)));
    const double rest = degrees - 360.0 * turns;
    return rest < 0 ? rest + 360.0 : rest >= 360.0 ? rest - 360.0 : rest;
  }
  const double rest = std::fmod(degrees, 360.0);
  return rest < 0 ? rest + 360.0 : rest;
}

/// Sines of whole degrees, exact where they are 0, a half or 1, so that TAN[90] is told from a
/// large value.
const std::array<double, 360> kSines = [] {
  std::array<double, 360> sines{};
  for (std::size_t a = 0; a < sines.size(); ++a) {
    const double sine = std::sin(static_cast<double>(a) * kDegree);
    const double half = std::round(sine * 2) / 2;
    sines[a] = std::fabs(sine - half) < 1e-9 ? half : sine;
  }
  return sines;
}();

/// Whether the angle is a whole number of degrees, and which of one turn.
bool whole_degrees(double degrees, std::size_t& of_turn) {
  if (!(std::fabs(degrees) < 1e9)) return false;
  const auto whole = to_whole<std::int32_t>(degrees);
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

bool as_bits(double value, std::int64_t& bits) {
  const double whole = round_half_away(value);
  if (!(std::fabs(whole) <= 4294967295.0)) return false;
  bits = to_whole<std::int64_t>(whole);
  return true;
}

}  // namespace

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

/// False where the expression has no value; `trap` says why.
bool Machine::compute(const Instruction* at, const Places& places, double& result, Trap& trap) {
  // The reader allows no more than 200 values on the stack.
  std::array<double, 210> stack;  // NOLINT: written before it is read
  double* below = stack.data();   // where the value goes that lies below the last one
  double a = 0;                   // the last value: it lies in a register, not on the stack
  double b = 0;                   // the second one of two
  const double* locals = places.of[1];
  const double* commons = places.of[2];
  const Control& control = *code_->control;
  const auto fault = [&](Cause cause, const char* detail = "") {
    trap = {cause, at->at, detail};
    return false;
  };
  const auto missing = [&](const std::optional<Fault>& wrong, double variable) {
    fault(wrong->cause);
    trap.variable = to_whole<std::int64_t>(variable);
    return false;
  };
  const auto number = [](double value) { return is_vacant(value) ? 0.0 : value; };
  const bool degrees = control.angle_unit.value == AngleUnit::Degrees;
  for (;; ++at) {
    switch (at->op) {
      case Ins::Constant:
        *below++ = a;
        a = at->value;
        break;
      case Ins::Local:
        *below++ = a;
        a = number(locals[at->at]);
        break;
      case Ins::LocalRaw:
        *below++ = a;
        a = locals[at->at];
        break;
      case Ins::Common:
        *below++ = a;
        a = number(commons[at->at]);
        break;
      case Ins::CommonRaw:
        *below++ = a;
        a = commons[at->at];
        break;
      case Ins::Variable:
      case Ins::VariableRaw: {
        double value = 0;
        if (const auto wrong = read(to_whole<std::int64_t>(at->value), value))
          return missing(wrong, at->value);
        *below++ = a;
        a = at->op == Ins::Variable ? number(value) : value;
        break;
      }
      case Ins::Indirect:
      case Ins::IndirectRaw: {
        const double index = round_half_away(a);
        if (!(std::fabs(index) < 2e9))
          return fault(Cause::IllegalVariable, "the variable number is out of range");
        double value = 0;
        if (const auto wrong = read(to_whole<std::int64_t>(index), value))
          return missing(wrong, index);
        a = at->op == Ins::Indirect ? number(value) : value;
        break;
      }
      case Ins::Named: {
        const auto found = names_.find(code_->names[to_whole<std::size_t>(at->value)]);
        if (found == names_.end())
          return fault(Cause::VariableNameUnknown, "the name is not registered");
        *below++ = a;
        a = static_cast<double>(found->second);
        break;
      }
      case Ins::Add:
        b = a;
        a = *--below;
        a += b;
        if (!std::isfinite(a)) return fault(Cause::Overflow, "the result is too large");
        break;
      case Ins::Subtract:
        b = a;
        a = *--below;
        a -= b;
        if (!std::isfinite(a)) return fault(Cause::Overflow, "the result is too large");
        break;
      case Ins::Multiply:
        b = a;
        a = *--below;
        a *= b;
        if (!std::isfinite(a)) return fault(Cause::Overflow, "the result is too large");
        break;
      case Ins::Divide:
        b = a;
        a = *--below;
        if (b == 0) return fault(Cause::DivisionByZero, "the divisor is 0");
        a /= b;
        if (!std::isfinite(a)) return fault(Cause::Overflow, "the result is too large");
        break;
      case Ins::AddConstant:
        a += at->value;
        break;
      case Ins::SubtractConstant:
        a -= at->value;
        break;
      case Ins::MultiplyConstant:
        a *= at->value;
        if (!std::isfinite(a)) return fault(Cause::Overflow, "the result is too large");
        break;
      case Ins::DivideConstant:
        a /= at->value;
        if (!std::isfinite(a)) return fault(Cause::Overflow, "the result is too large");
        break;
      case Ins::Modulo:
        if (at->value == -1) break;  // marks PRM[n,b]
        b = a;
        a = *--below;
        if (b == 0) return fault(Cause::DivisionByZero, "the divisor is 0");
        a = std::fmod(a, b);
        break;
      case Ins::And:
      case Ins::Or:
      case Ins::Xor: {
        b = a;
        a = *--below;
        std::int64_t left = 0, right = 0;
        if (!as_bits(a, left) || !as_bits(b, right))
          return fault(Cause::Overflow, "AND, OR and XOR take 32 bits");
        if (!control.negative_logic.value && (left < 0 || right < 0))
          return fault(Cause::LogicOfNegative, "the value is negative");
        if (control.logic_of_bits.value && ((left | right) & ~std::int64_t{1}) != 0)
          return fault(Cause::LogicOfBits, "the values of AND, OR and XOR are 0 and 1");
        a = static_cast<double>(at->op == Ins::And  ? left & right
                                : at->op == Ins::Or ? left | right
                                                    : left ^ right);
        break;
      }
      case Ins::Negate:
        a = -a;
        break;
      case Ins::Equal:
        b = a;
        a = *--below;
        a = a == b || (is_vacant(a) && is_vacant(b)) ? 1 : 0;
        break;
      case Ins::NotEqual:
        b = a;
        a = *--below;
        a = a == b || (is_vacant(a) && is_vacant(b)) ? 0 : 1;
        break;
      case Ins::Greater:
        b = a;
        a = *--below;
        a = a > b ? 1 : 0;
        break;
      case Ins::Less:
        b = a;
        a = *--below;
        a = a < b ? 1 : 0;
        break;
      case Ins::GreaterEqual:
        b = a;
        a = *--below;
        a = a >= b ? 1 : 0;
        break;
      case Ins::LessEqual:
        b = a;
        a = *--below;
        a = a <= b ? 1 : 0;
        break;
      case Ins::BothTrue:
        b = a;
        a = *--below;
        a = a != 0 && b != 0 ? 1 : 0;
        break;
      case Ins::EitherTrue:
        b = a;
        a = *--below;
        a = a != 0 || b != 0 ? 1 : 0;
        break;
      case Ins::OneTrue:
        b = a;
        a = *--below;
        a = (a != 0) != (b != 0) ? 1 : 0;
        break;
      case Ins::Not:
        a = a == 0 ? 1 : 0;
        break;
      case Ins::Sin:
        a = degrees ? sine(a) : std::sin(a);
        break;
      case Ins::Cos:
        a = degrees ? cosine(a) : std::cos(a);
        break;
      case Ins::Tan: {
        const double c = degrees ? cosine(a) : std::cos(a);
        if (c == 0) return fault(Cause::TangentInfinite, "the tangent has no value there");
        a = (degrees ? sine(a) : std::sin(a)) / c;
        break;
      }
      case Ins::Asin:
      case Ins::Acos: {
        if (!(std::fabs(a) <= 1))
          return fault(Cause::ArcSineOutOfRange, "the value is outside -1 to 1");
        double angle = at->op == Ins::Asin ? std::asin(a) : std::acos(a);
        if (degrees) angle /= kDegree;
        const bool turn =
            at->op == Ins::Asin && degrees && control.asin_range.value == AngleRange::FullTurn;
        a = turn && angle < 0 ? angle + 360 : angle;
        break;
      }
      case Ins::Atan:
        a = degrees ? std::atan(a) / kDegree : std::atan(a);
        break;
      case Ins::Atan2: {
        b = a;
        a = *--below;
        double angle = std::atan2(a, b);
        if (degrees) {
          angle /= kDegree;
          if (control.atan_range.value == AngleRange::FullTurn && angle < 0) angle += 360;
        }
        a = angle;
        break;
      }
      case Ins::Sqrt:
        if (a < 0) return fault(Cause::SquareRootOfNegative, "the value is negative");
        a = std::sqrt(a);
        break;
      case Ins::Abs:
        a = std::fabs(a);
        break;
      case Ins::Round:
        a = round_half_away(a);
        break;
      case Ins::RoundWord: {
        const double step = motion_.increment(static_cast<char>(at->address));
        a = step > 0 ? round_half_away(a / step) * step : round_half_away(a);
        break;
      }
      case Ins::CutWord: {
        const double step = motion_.increment(static_cast<char>(at->address));
        constexpr double kHair = 1e-6;  // 1.235 is 1234.9999... thousandths
        if (step > 0) a = std::copysign(std::floor(std::fabs(a) / step + kHair) * step, a);
        break;
      }
      case Ins::Fix:
        a = std::trunc(a);
        break;
      case Ins::Fup:
        a = a < 0 ? std::floor(a) : std::ceil(a);
        break;
      case Ins::Ln:
        if (!(a > 0)) return fault(Cause::LogarithmOfNonPositive, "the value is not positive");
        a = std::log(a);
        break;
      case Ins::Exp:
        if (a > 110) return fault(Cause::Overflow, "the result is too large");
        a = std::exp(a);
        break;
      case Ins::Pow: {
        b = a;
        a = *--below;
        const double value = std::pow(a, b);
        if (std::isnan(value)) return fault(Cause::ArgumentOutOfRange, "the power has no value");
        if (std::isinf(value)) return fault(Cause::Overflow, "the result is too large");
        a = value;
        break;
      }
      case Ins::Bin:
        if (!read_digits(a, 16, 10, a))
          return fault(Cause::ArgumentOutOfRange, "the value is no BCD number");
        break;
      case Ins::Bcd:
        if (!read_digits(a, 10, 16, a))
          return fault(Cause::ArgumentOutOfRange, "the value has no BCD number");
        break;
      case Ins::Adp:
        break;
      case Ins::Parameter: {
        const bool bit_form = at[-1].op == Ins::Modulo && at[-1].value == -1;
        if (bit_form) {
          b = a;
          a = *--below;
        }
        const double which = round_half_away(a);
        if (!(std::fabs(which) < 1e9))
          return fault(Cause::ArgumentOutOfRange, "there is no such parameter");
        std::string name = std::to_string(to_whole<std::int64_t>(which));
        if (bit_form)
          name += "#" +
                  std::to_string(to_whole<std::int64_t>(std::clamp(round_half_away(b), 0.0, 31.0)));
        a = control.parameter(name);
        break;
      }
      case Ins::Sign:
        a = a > 0 ? 1 : a < 0 ? -1 : 0;
        break;
      case Ins::Random:  // above 0, not above the argument
        take_from_outside();
        a *= static_cast<double>(random_()) / 2147483646.0;
        break;
      case Ins::RandomBetween:
        take_from_outside();
        b = a;
        a = *--below;
        a += (b - a) * static_cast<double>(random_()) / 2147483646.0;
        if (!std::isfinite(a)) return fault(Cause::Overflow, "the result is too large");
        break;
      case Ins::Programmed: {
        const auto place =
            static_cast<std::size_t>(level_ * code_->locals) + to_whole<std::size_t>(at->value);
        if (at->value >= code_->locals || programmed_.empty())
          return fault(Cause::IllegalVariable, "AR takes a local variable");
        *below++ = a;
        a = programmed_[place];
        break;
      }
      case Ins::End:
        result = a;
        if (std::isinf(result)) return fault(Cause::Overflow, "the result is too large");
        return true;
    }
  }
}

}  // namespace cncsub
