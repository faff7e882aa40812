// Numbers: the largest one, and the one place where a double becomes an integer of any width.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

namespace cncsub {

/// The largest value that a variable or a word takes.
constexpr double kLargest = 1e47;

/// Return the whole part of a value. A value that the type does not hold becomes the nearest number
/// that it holds, and a vacant value 0: no value is outside, whatever a program says.
template <class Whole>
constexpr Whole to_whole(double value) {
  static_assert(std::is_integral_v<Whole>);
  constexpr Whole kLow = std::numeric_limits<Whole>::min();
  constexpr Whole kHigh = std::numeric_limits<Whole>::max();
  if (value != value) return 0;
  if (value <= static_cast<double>(kLow)) return kLow;
  if (value >= static_cast<double>(kHigh)) return kHigh;  // with 64 bits it is one more than kHigh
  return static_cast<Whole>(value);
}

/// Return the same within limits.
template <class Whole>
constexpr Whole to_whole(double value, Whole low, Whole high) {
  const Whole whole = to_whole<Whole>(value);
  return whole < low ? low : whole > high ? high : whole;
}

/// Return std::round of a value, at once if the value is whole.
inline double rounded(double value) {
  constexpr double kSmall = 1e9;
  if (std::fabs(value) < kSmall && static_cast<double>(static_cast<std::int32_t>(value)) == value)
    return value;
  return std::round(value);
}

/// Return the whole number that is within a ten-thousandth of a value; nothing if there is none.
inline std::optional<double> nearly_whole(double value) {
  constexpr double kApart = 1e-4;
  const double low = std::floor(value), rest = value - low;
  if (rest > kApart && rest <= 1 - kApart) return std::nullopt;
  return rest > 1 - kApart ? low + 1 : low;
}

}  // namespace cncsub
