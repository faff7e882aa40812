// The computations of the instructions of ins.def, from their operand in the code and the values on
// the stack. `a` is the last value; where there is `b`, that is the last and `a` the one before it.
// Those that can fail return an optional value. Whoever evaluates expressions includes this file,
// once.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "cncsub/control/variable_table.hpp"
#include "cncsub/machine/values/degrees.hpp"
#include "cncsub/machine/values/expressions.hpp"
#include "cncsub/machine/values/variables.hpp"
#include "cncsub/system/extended.hpp"

namespace cncsub::instruction {

/// An instruction as it is kept, which is known to hold what is asked of it.
struct InstructionView {
  const ExpressionCell* cell;

  std::uint32_t at() const { return cell->high; }
  std::uint32_t index() const { return cell->index(); }
  double value() const { return cell[1].value(); }
  std::uint8_t address() const { return static_cast<std::uint8_t>(cell->low >> 8); }
};

/// The reason why an expression has no value.
struct Trap {
  Cause cause{};
  std::uint32_t at = 0;
  const char* detail = "";
  std::int64_t variable = kNoVariable;  // the variable that cannot be read
  static constexpr std::int64_t kNoVariable = std::numeric_limits<std::int64_t>::min();
  std::string_view name = {};      // or its name
  std::string_view function = {};  // the function whose value cannot be
};

/// The expression that is being evaluated.
struct Evaluation {
  Run& run;
  const Places& places;
  const Control& control;
  bool degrees;   // angles are degrees, not radians
  Address block;  // the block that the expression stands in
  Trap& trap;
};

using Fallible = std::optional<double>;
using E = const Evaluation&;
using I = InstructionView;

inline std::nullopt_t fails(E e, I at, Cause cause, const char* detail = "") {
  e.trap.cause = cause;
  e.trap.at = at.at();
  e.trap.detail = detail;
  return std::nullopt;
}
inline Fallible finite(E e, I at, double value) {
  if (std::isfinite(value)) [[likely]]
    return value;
  return fails(e, at, Cause::Overflow, "the result is too large");
}
inline Fallible finite_or_vacant(E e, I at, double value) {
  if (!std::isinf(value)) [[likely]]
    return value;
  return fails(e, at, Cause::Overflow, "the result is too large");
}
inline double number(double value) { return is_vacant(value) ? 0.0 : value; }

inline Fallible read_or_fail(E e, I at, double number) {
  double value = 0;
  const auto wrong = read_variable(e.run, to_whole<std::int64_t>(number), value);
  if (!wrong) return value;
  e.trap.variable = to_whole<std::int64_t>(number);
  return fails(e, at, wrong->cause);
}

inline double constant(E, I at) { return at.value(); }
inline double local(E e, I at) { return number(e.places.local(at.index())); }
inline double local_raw(E e, I at) { return e.places.local(at.index()); }
inline double common(E e, I at) { return number(e.places.common(at.index())); }
inline double common_raw(E e, I at) { return e.places.common(at.index()); }
inline Fallible variable_raw(E e, I at) { return read_or_fail(e, at, at.value()); }
inline Fallible variable(E e, I at) {
  const Fallible value = variable_raw(e, at);
  return value ? number(*value) : value;
}
inline Fallible indirect_raw(E e, I at, double a) {
  const double index = cncsub::rounded(a);
  if (!(std::fabs(index) < 2e9))
    return fails(e, at, Cause::IllegalVariable, "the variable number is out of range");
  const double* const near = e.places.near(*e.run.code, to_whole<std::int64_t>(index), false);
  return near != nullptr ? *near : read_or_fail(e, at, index);
}
inline Fallible indirect(E e, I at, double a) {
  const Fallible value = indirect_raw(e, at, a);
  return value ? number(*value) : value;
}
inline Fallible named(E e, I at) {
  const auto& names = e.run.state.names;
  const auto found = names.find(e.run.code->names[to_whole<std::size_t>(at.value())]);
  if (found == names.end())
    return fails(e, at, Cause::VariableNameUnknown, "the name is not registered");
  return static_cast<double>(found->second);
}
inline Fallible programmed(E e, I at) {
  const State& state = e.run.state;
  const auto place = static_cast<std::size_t>(state.level * e.run.code->locals) +
                     to_whole<std::size_t>(at.value());
  if (at.value() >= e.run.code->locals || state.programmed.empty())
    return fails(e, at, Cause::IllegalVariable, "AR must have a local variable");
  return state.programmed[place];
}

inline Fallible add(E e, I at, double a, double b) { return finite(e, at, a + b); }
inline Fallible subtract(E e, I at, double a, double b) { return finite(e, at, a - b); }
inline Fallible multiply(E e, I at, double a, double b) { return finite(e, at, a * b); }
inline Fallible divide(E e, I at, double a, double b) {
  if (b == 0) return fails(e, at, Cause::DivisionByZero, "the divisor is 0");
  return finite(e, at, a / b);
}
inline double add_constant(E, I at, double a) { return a + at.value(); }
inline double subtract_constant(E, I at, double a) { return a - at.value(); }
inline Fallible multiply_constant(E e, I at, double a) { return finite(e, at, a * at.value()); }
inline Fallible divide_constant(E e, I at, double a) { return finite(e, at, a / at.value()); }
inline Fallible modulo(E e, I at, double a, double b) {
  if (b == 0) return fails(e, at, Cause::DivisionByZero, "the divisor is 0");
  return std::fmod(a, b);
}
inline double negate(E, I, double a) { return -a; }

inline bool as_bits(double value, std::int64_t& bits) {
  const double whole = std::round(value);
  if (!(std::fabs(whole) <= 4294967295.0)) return false;
  bits = to_whole<std::int64_t>(whole);
  return true;
}
/// Convert both values to the bits that AND, OR and XOR take.
inline bool both_bits(E e, I at, double a, double b, std::int64_t& left, std::int64_t& right) {
  if (!as_bits(a, left) || !as_bits(b, right))
    fails(e, at, Cause::Overflow, "a value of AND, OR and XOR must fit in 32 bits");
  else if (e.run.refuses(Cause::LogicOfNegative) && (left < 0 || right < 0))
    fails(e, at, Cause::LogicOfNegative, "the value is negative");
  else if (e.run.refuses(Cause::LogicOfBits) && ((left | right) & ~std::int64_t{1}) != 0)
    fails(e, at, Cause::LogicOfBits, "a value of AND, OR and XOR must be 0 or 1");
  else
    return true;
  return false;
}
inline Fallible bits_and(E e, I at, double a, double b) {
  std::int64_t left = 0, right = 0;
  if (!both_bits(e, at, a, b, left, right)) return std::nullopt;
  return static_cast<double>(left & right);
}
inline Fallible bits_or(E e, I at, double a, double b) {
  std::int64_t left = 0, right = 0;
  if (!both_bits(e, at, a, b, left, right)) return std::nullopt;
  return static_cast<double>(left | right);
}
inline Fallible bits_xor(E e, I at, double a, double b) {
  std::int64_t left = 0, right = 0;
  if (!both_bits(e, at, a, b, left, right)) return std::nullopt;
  return static_cast<double>(left ^ right);
}

inline double equal(E, I, double a, double b) {
  return a == b || (is_vacant(a) && is_vacant(b)) ? 1 : 0;
}
inline double not_equal(E e, I at, double a, double b) { return 1 - equal(e, at, a, b); }
inline double greater(E, I, double a, double b) { return a > b ? 1 : 0; }
inline double less(E, I, double a, double b) { return a < b ? 1 : 0; }
inline double greater_equal(E, I, double a, double b) { return a >= b ? 1 : 0; }
inline double less_equal(E, I, double a, double b) { return a <= b ? 1 : 0; }
inline double both_true(E, I, double a, double b) { return a != 0 && b != 0 ? 1 : 0; }
inline double either_true(E, I, double a, double b) { return a != 0 || b != 0 ? 1 : 0; }
inline double one_true(E, I, double a, double b) { return (a != 0) != (b != 0) ? 1 : 0; }
inline double is_false(E, I, double a) { return a == 0 ? 1 : 0; }

inline double sine_of(E e, I, double a) { return e.degrees ? sine(a) : std::sin(a); }
inline double cosine_of(E e, I, double a) { return e.degrees ? cosine(a) : std::cos(a); }
inline Fallible tangent_of(E e, I at, double a) {
  const double c = cosine_of(e, at, a);
  if (c == 0) return fails(e, at, Cause::TangentInfinite, "the tangent has no value there");
  return sine_of(e, at, a) / c;
}
inline double angle(E e, double radians) { return e.degrees ? radians / kDegree : radians; }
inline Fallible arc_sine(E e, I at, double a) {
  if (!(std::fabs(a) <= 1))
    return fails(e, at, Cause::ArcSineOutOfRange, "the value is outside -1 to 1");
  const double found = angle(e, std::asin(a));
  const bool turn = e.degrees && e.control.macros.asin_range.value == AngleRange::FullTurn;
  return turn && found < 0 ? found + 360 : found;
}
inline Fallible arc_cosine(E e, I at, double a) {
  if (!(std::fabs(a) <= 1))
    return fails(e, at, Cause::ArcSineOutOfRange, "the value is outside -1 to 1");
  return angle(e, std::acos(a));
}
inline double arc_tangent(E e, I, double a) { return angle(e, std::atan(a)); }
inline double arc_tangent_of_two(E e, I, double a, double b) {
  const double found = angle(e, std::atan2(a, b));
  const bool turn = e.degrees && e.control.macros.atan_range.value == AngleRange::FullTurn;
  return turn && found < 0 ? found + 360 : found;
}

inline Fallible square_root(E e, I at, double a) {
  if (a < 0) return fails(e, at, Cause::SquareRootOfNegative, "the value is negative");
  return std::sqrt(a);
}
inline double absolute(E, I, double a) { return std::fabs(a); }
inline double sign(E, I, double a) { return a > 0 ? 1 : a < 0 ? -1 : 0; }
inline double rounded(E, I, double a) { return std::round(a); }
inline double rounded_word(E e, I at, double a) {
  const double step =
      increment(e.run.motion.view(), static_cast<char>(at.address()), e.run.codes_decoded);
  return step > 0 ? std::round(a / step) * step : std::round(a);
}
inline double cut_word(E e, I at, double a) {
  constexpr double kHair = 1e-6;  // 1.235 is 1234.9999... thousandths
  const double step =
      increment(e.run.motion.view(), static_cast<char>(at.address()), e.run.codes_decoded);
  return step > 0 ? std::copysign(std::floor(std::fabs(a) / step + kHair) * step, a) : a;
}
inline double cut(E, I, double a) { return std::trunc(a); }
inline double raised(E, I, double a) { return a < 0 ? std::floor(a) : std::ceil(a); }
inline double with_point(E, I, double a) { return a; }
inline Fallible logarithm(E e, I at, double a) {
  if (!(a > 0)) return fails(e, at, Cause::LogarithmOfNonPositive, "the value is not positive");
  return std::log(a);
}
inline Fallible exponential(E e, I at, double a) {
  if (a > 110) return fails(e, at, Cause::Overflow, "the result is too large");
  return std::exp(a);
}
inline Fallible power(E e, I at, double a, double b) {
  const double value = std::pow(a, b);
  if (std::isnan(value)) return fails(e, at, Cause::ArgumentOutOfRange, "the power has no value");
  if (std::isinf(value)) return fails(e, at, Cause::Overflow, "the result is too large");
  return value;
}
inline Fallible from_bcd(E e, I at, double a) {
  double value = 0;
  if (read_digits(a, 16, 10, value)) return value;
  return fails(e, at, Cause::ArgumentOutOfRange, "the value is not a BCD number");
}
inline Fallible to_bcd(E e, I at, double a) {
  double value = 0;
  if (read_digits(a, 10, 16, value)) return value;
  return fails(e, at, Cause::ArgumentOutOfRange, "the value cannot be written as a BCD number");
}

/// Return the value of PRM[1320], PRM[1320,5]: a parameter, or the bit of one.
inline Fallible parameter_of(E e, I at, double a, const std::string& bit) {
  const double which = std::round(a);
  if (!(std::fabs(which) < 1e9))
    return fails(e, at, Cause::ArgumentOutOfRange, "there is no such parameter");
  return e.control.parameter(std::to_string(to_whole<std::int64_t>(which)) + bit);
}
inline Fallible parameter(E e, I at, double a) { return parameter_of(e, at, a, ""); }
inline Fallible parameter_bit(E e, I at, double a, double b) {
  const auto bit = to_whole<std::int64_t>(std::clamp(std::round(b), 0.0, 31.0));
  return parameter_of(e, at, a, "#" + std::to_string(bit));
}

constexpr double kLastRandom = 2147483646.0;  // the first is 1
inline double random_number(Run& run) {
  log_read(run);
  return static_cast<double>(run.state.external_reads.random());
}
inline double random_up_to(E e, I, double a) { return a * (random_number(e.run) / kLastRandom); }
inline Fallible random_between(E e, I at, double a, double b) {
  return finite(e, at, a + (b - a) * random_number(e.run) / kLastRandom);
}

// ---- as LinuxCNC computes ----

template <Ins kOp>
double alike(E, I, double a, double b) {
  return compare_alike(kOp, a, b) ? 1 : 0;
}
constexpr auto alike_equal = alike<Ins::AlikeEqual>;
constexpr auto alike_not_equal = alike<Ins::AlikeNotEqual>;
constexpr auto alike_greater = alike<Ins::AlikeGreater>;
constexpr auto alike_less = alike<Ins::AlikeLess>;
constexpr auto alike_greater_equal = alike<Ins::AlikeGreaterEqual>;
constexpr auto alike_less_equal = alike<Ins::AlikeLessEqual>;

constexpr double kNearly = 1e-4;  // values that differ by less are equal

inline double nearly_equal(E, I, double a, double b) { return std::fabs(a - b) < kNearly ? 1 : 0; }
inline double nearly_not_equal(E, I, double a, double b) {
  return std::fabs(a - b) < kNearly ? 0 : 1;
}
inline Fallible positive_modulo(E e, I at, double a, double b) {
  const double rest = std::fmod(a, b);
  if (std::isnan(rest)) return fails(e, at, Cause::ArgumentOutOfRange, "the modulus is 0");
  return rest < 0 ? rest + std::fabs(b) : rest;
}
inline double floor_of(E, I, double a) { return std::floor(a); }
inline double ceiling_of(E, I, double a) { return std::ceil(a); }
inline Fallible raised_to(E e, I at, double a, double b) {
  if (a < 0 && std::floor(b) != b)
    return fails(e, at, Cause::PowerOfNegative, "the exponent is not whole");
  return finite(e, at, std::pow(a, b));
}
inline double plain_sine(E, I, double a) { return system::extended_sine(a); }
inline double plain_cosine(E, I, double a) { return system::extended_cosine(a); }
inline double plain_tangent(E, I, double a) { return system::extended_tangent(a); }
inline double plain_degrees(double radians) { return system::extended_degrees(radians); }
inline Fallible outside_one(E e, I at, std::string_view function) {
  e.trap.function = function;
  return fails(e, at, Cause::ArcSineOutOfRange, "the value is outside -1 to 1");
}
inline Fallible plain_arc_sine(E e, I at, double a) {
  return std::fabs(a) <= 1 ? plain_degrees(std::asin(a)) : outside_one(e, at, "asin");
}
inline Fallible plain_arc_cosine(E e, I at, double a) {
  return std::fabs(a) <= 1 ? plain_degrees(std::acos(a)) : outside_one(e, at, "acos");
}
inline double plain_arc_tangent(E, I, double a, double b) {
  return plain_degrees(std::atan2(a, b));
}

inline Fallible named_value(E e, I at, double value) {
  if (!is_vacant(value) || e.run.state.labels.defining) return number(value);
  e.trap.name = e.run.code->named_variables[to_whole<std::size_t>(at.value())].name;
  return fails(e, at, Cause::VariableNameUnknown);
}
inline Fallible named_local(E e, I at) { return named_value(e, at, e.places.local(at.at())); }
inline Fallible named_common(E e, I at) { return named_value(e, at, e.places.common(at.at())); }
inline double is_set(E, I, double a) { return is_vacant(a) ? 0 : 1; }
inline double is_within(E, I at, double a, double b) { return a >= b && a <= at.value() ? 1 : 0; }
inline Fallible whole_number(E e, I at, double a) {
  const Fallible whole = nearly_whole(a);
  return whole ? whole : fails(e, at, Cause::WholeNumberExpected, "the value is not whole");
}
inline Fallible variable_number(E e, I at, double a) {
  const Fallible whole = whole_number(e, at, a);
  if (!whole) return whole;
  const auto number = to_whole<std::int64_t>(*whole);
  if (e.run.code->can_name(number, to_whole<std::int64_t>(at.value()))) return whole;
  return fails(e, at, Cause::IllegalVariable, "there is no variable of this number");
}

// ---- variables and arrays of programs ----

inline Fallible checked_index(E e, I at, double a) {
  const double index = cncsub::rounded(number(a));
  if (index >= 0 && index < at.value()) return index;
  return fails(e, at, Cause::ArrayElement, "the index is outside the array");
}
inline double element(E e, I at, double a) {
  return e.run.state.elements[e.run.element_at(to_whole<std::size_t>(at.value() + a))];
}
inline double common_element(E e, I at, double a) {
  return number(e.run.state.commons[to_whole<std::size_t>(at.value() + a)]);
}
inline Fallible variable_at(E e, I at, double a) {
  const double number = at.value() + cncsub::rounded(a) - 1;
  const Code& code = *e.run.code;
  const auto range_of = [&](double of) { return code.place(to_whole<std::int64_t>(of)).range; };
  if (!(std::fabs(a) < 1e6) || range_of(number) != range_of(at.value()))
    return fails(e, at, Cause::ArrayElement, "the index is outside the variable");
  const Fallible value = read_or_fail(e, at, number);
  return value ? instruction::number(*value) : value;
}
inline Fallible integer(E e, I at, double a) {
  constexpr double kLeast = -2147483648.0, kMost = 2147483647.0;
  const double whole = std::round(a);
  if (whole >= kLeast && whole <= kMost) return whole;
  return fails(e, at, Cause::ValueOutOfRange, "an INT has 32 bits");
}
inline Fallible character(E e, I at, double a) {
  const double whole = std::round(a);
  if (whole >= 0 && whole <= 255) return whole;
  return fails(e, at, Cause::ValueOutOfRange, "a CHAR is 0 to 255");
}
inline Fallible bits_not(E e, I at, double a) {
  std::int64_t bits = 0;
  if (!as_bits(a, bits)) return fails(e, at, Cause::Overflow, "the value must fit in 32 bits");
  return static_cast<double>(~bits);
}
inline Fallible only_of_axis(E e, I at, double a, double b) {
  if (a >= 1) return a == at.value() ? b : kVacant;
  return fails(e, at, Cause::CodeNotComputed, "cncsub does not compute AX of NO_AXIS");
}
inline double first_set(E, I, double a, double b) { return is_vacant(a) ? b : a; }
inline double smaller_of(E, I, double a, double b) { return a < b ? a : b; }
inline double larger_of(E, I, double a, double b) { return a > b ? a : b; }

inline double level(E e, I) { return e.run.state.open_calls(); }
inline double line_number(E e, I) { return e.run.code->blocks[e.block].line; }

}  // namespace cncsub::instruction
