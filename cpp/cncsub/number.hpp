// From a value to a whole number: the one place where a double becomes an integer of any width.
#pragma once

#include <limits>
#include <type_traits>

namespace cncsub {

/// The whole part of a value. What the type does not hold becomes the nearest number that it holds,
/// and a vacant value 0: no value is outside, whatever a program says.
template <class Whole>
constexpr Whole to_whole(double value) {
  static_assert(std::is_integral_v<Whole>);
  constexpr Whole kLow = std::numeric_limits<Whole>::min();
  constexpr Whole kHigh = std::numeric_limits<Whole>::max();
  if (value != value) return 0;
  if (value <= static_cast<double>(kLow)) return kLow;
  if (value >= static_cast<double>(kHigh)) return kHigh;  // of 64 bits it is one more than kHigh
  return static_cast<Whole>(value);
}

/// The same within limits.
template <class Whole>
constexpr Whole to_whole(double value, Whole low, Whole high) {
  const Whole whole = to_whole<Whole>(value);
  return whole < low ? low : whole > high ? high : whole;
}

}  // namespace cncsub
