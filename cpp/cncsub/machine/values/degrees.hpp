// Sines and cosines of degrees.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "cncsub/text/number.hpp"

namespace cncsub {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

/// Return the angle within one turn, 0 to 360 degrees.
inline double within_turn(double degrees) {
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

/// The sines of whole degrees, exact where they are 0, a half or 1, so that TAN[90] is told from a
/// large value.
inline const std::array<double, 360> kSines = [] {
  std::array<double, 360> sines{};
  for (std::size_t a = 0; a < sines.size(); ++a) {
    const double sine = std::sin(static_cast<double>(a) * kDegree);
    const double half = std::round(sine * 2) / 2;
    sines[a] = std::fabs(sine - half) < 1e-9 ? half : sine;
  }
  return sines;
}();

/// Return whether the angle is a whole number of degrees, and which of one turn.
inline bool whole_degrees(double degrees, std::size_t& of_turn) {
  if (!(std::fabs(degrees) < 1e9)) return false;
  const auto whole = to_whole<std::int32_t>(degrees);
  if (static_cast<double>(whole) != degrees) return false;
  const std::int32_t rest = whole % 360;
  of_turn = static_cast<std::size_t>(rest < 0 ? rest + 360 : rest);
  return true;
}

inline double sine(double degrees) {
  if (std::size_t whole = 0; whole_degrees(degrees, whole)) return kSines[whole];
  return std::sin(within_turn(degrees) * kDegree);
}

inline double cosine(double degrees) {
  if (std::size_t whole = 0; whole_degrees(degrees, whole))
    return kSines[whole < 270 ? whole + 90 : whole - 270];
  return std::cos(within_turn(degrees) * kDegree);
}

}  // namespace cncsub
