#include "cncsub/system/extended.hpp"

namespace cncsub::system {

namespace {

/// The sum of two doubles that do not overlap.
struct Pair {
  double high = 0, low = 0;
};

constexpr Pair kPi64 = {0x1.921fb54442d18p+1, 0x1.1a8p-53};  // pi to 64 bits
constexpr double kHalfPi[] = {0x1.921fb54442d18p+0, 0x1.1a62633145c07p-54, -0x1.f1976b7ed8fbcp-110};

Pair sum(double a, double b) {
  const double s = a + b, t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

Pair product(double a, double b) {
  constexpr double kSplit = 134217729.0;  // halves of 26 bits
  const double p = a * b;
  const double a1 = kSplit * a - (kSplit * a - a), a2 = a - a1;
  const double b1 = kSplit * b - (kSplit * b - b), b2 = b - b1;
  return {p, ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2};
}

Pair operator+(Pair a, Pair b) {
  const Pair high = sum(a.high, b.high), low = sum(a.low, b.low);
  const Pair first = sum(high.high, high.low + low.high);
  return sum(first.high, first.low + low.low);
}

Pair operator-(Pair a) { return {-a.high, -a.low}; }

Pair operator*(Pair a, Pair b) {
  const Pair p = product(a.high, b.high);
  return sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

Pair operator/(Pair a, Pair b) {
  const double first = a.high / b.high;
  Pair rest = a + -(b * Pair{first});
  const double second = rest.high / b.high;
  rest = rest + -(b * Pair{second});
  return sum(first, second) + Pair{rest.high / b.high};
}

/// Round a pair as a number of 64 bits.
Pair rounded(Pair p) {
  int exponent = 0;
  const double part = std::frexp(p.high, &exponent);
  if (std::fabs(part) == 0.5 && p.low * part < 0) --exponent;
  const double unit = std::ldexp(1.0, exponent - 64);
  return sum(p.high, unit > 0 ? std::nearbyint(p.low / unit) * unit : p.low);
}

/// The sine and cosine of an angle.
struct SineCosine {
  Pair sine, cosine;
};

SineCosine near_nought(Pair r) {
  constexpr int kTerms = 30;
  SineCosine of{r, {1.0, 0.0}};
  Pair term = r;  // r^n / n!
  const Pair squared = r * r;
  for (int n = 3; n < kTerms; n += 2) {
    term = -(term * squared) / Pair{static_cast<double>(n * (n - 1))};
    of.sine = of.sine + term;
  }
  term = {1.0, 0.0};
  for (int n = 2; n < kTerms; n += 2) {
    term = -(term * squared) / Pair{static_cast<double>(n * (n - 1))};
    of.cosine = of.cosine + term;
  }
  return of;
}

/// Compute any angle. The library computes one of very many turns: no digit of it is left.
SineCosine of_degrees(double degrees) {
  constexpr double kMost = 1e9;
  const Pair angle = rounded(rounded(kPi64 * Pair{degrees}) / Pair{180.0});
  if (!(std::fabs(degrees) < kMost)) return {{std::sin(angle.high)}, {std::cos(angle.high)}};
  const double quarters = std::nearbyint(angle.high / kHalfPi[0]);
  const Pair first = product(quarters, kHalfPi[0]);
  Pair r = sum(angle.high, -first.high);
  r = r + sum(angle.low, -first.low);
  r = r + -product(quarters, kHalfPi[1]);
  r = r + -product(quarters, kHalfPi[2]);
  const SineCosine of = near_nought(r);
  switch (static_cast<int>(std::fmod(quarters, 4.0) + 4.0) % 4) {
    case 1:
      return {of.cosine, -of.sine};
    case 2:
      return {-of.sine, -of.cosine};
    case 3:
      return {-of.cosine, of.sine};
    default:
      return of;
  }
}

}  // namespace

double sine_by_pairs(double degrees) { return of_degrees(degrees).sine.high; }
double cosine_by_pairs(double degrees) { return of_degrees(degrees).cosine.high; }
double tangent_by_pairs(double degrees) {
  const SineCosine of = of_degrees(degrees);
  return (of.sine / of.cosine).high;
}
double degrees_by_pairs(double radians) { return rounded(Pair{radians * 180.0} / kPi64).high; }

}  // namespace cncsub::system
