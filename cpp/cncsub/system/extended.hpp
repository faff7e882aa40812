// Computes sines and angles as LinuxCNC does on a PC: in numbers of 64 bits of mantissa.
// Microsoft's compiler and Apple's processors have none. Linux on ARM has numbers of 113 bits,
// which come out otherwise. MinGW leaves the turns of an angle to the processor, which knows pi to
// few digits.
#pragma once

#include <cmath>
#include <limits>

namespace cncsub::system {

#ifdef _WIN32
constexpr bool kHasExtended = false;
#else
constexpr bool kHasExtended = std::numeric_limits<long double>::digits == 64;
#endif

// Substitutes where a long double is none of these: pairs of doubles, rounded where an extended
// number would be. They are tested wherever they are not needed.
double sine_by_pairs(double degrees);
double cosine_by_pairs(double degrees);
double tangent_by_pairs(double degrees);
double degrees_by_pairs(double radians);

constexpr long double kLongPi = 3.141592653589793238462643383279502884L;

inline double extended_sine(double degrees) {
  if constexpr (kHasExtended) return static_cast<double>(std::sin(degrees * kLongPi / 180));
  return sine_by_pairs(degrees);
}
inline double extended_cosine(double degrees) {
  if constexpr (kHasExtended) return static_cast<double>(std::cos(degrees * kLongPi / 180));
  return cosine_by_pairs(degrees);
}
inline double extended_tangent(double degrees) {
  if constexpr (kHasExtended) return static_cast<double>(std::tan(degrees * kLongPi / 180));
  return tangent_by_pairs(degrees);
}
inline double extended_degrees(double radians) {
  if constexpr (kHasExtended) return static_cast<double>(radians * 180.0 / kLongPi);
  return degrees_by_pairs(radians);
}

}  // namespace cncsub::system
