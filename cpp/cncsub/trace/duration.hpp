// A move: its kind, what held for it, the length of its path, and how long it takes.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "cncsub/text/axis_names.hpp"

namespace cncsub {

enum class MoveKind : std::uint8_t { Rapid, Feed, Cw, Ccw, Thread, Dwell };
std::string_view to_string(MoveKind kind);

/// The kind of a skip move: none of G31, or one whose signal came or did not.
enum class SkipMove : std::uint8_t { No, Touched, Missed };
std::string_view to_string(SkipMove skip);

constexpr int kAxes = 9;
using Axes = std::array<double, kAxes>;

/// Return whether so many bytes are the same, without a branch on each of them.
template <std::size_t Size>
bool same_bytes(const void* one, const void* other) {
  static_assert(Size % sizeof(std::uint64_t) == 0);
  std::uint64_t different = 0;
  for (std::size_t at = 0; at < Size; at += sizeof different) {
    std::uint64_t x = 0, y = 0;
    std::memcpy(&x, static_cast<const char*>(one) + at, sizeof x);
    std::memcpy(&y, static_cast<const char*>(other) + at, sizeof y);
    different |= x ^ y;
  }
  return different == 0;
}

/// Return whether two values are the same, bit by bit.
template <class T>
bool same_bits(const T& one, const T& other) {
  static_assert(std::is_trivially_copyable_v<T>);
  return same_bytes<sizeof(T)>(&one, &other);
}

/// Return whether all axes but X, Y and Z are bit by bit the same.
inline bool others_stand(const Axes& from, const Axes& to) {
  return same_bytes<(kAxes - 3) * sizeof(double)>(&from[3], &to[3]);
}

enum class FeedMode : std::uint8_t { PerMinute, PerRevolution, InverseTime };

/// A plane by the code that selects it, which is what the tables of moves hold.
enum class Plane : std::uint8_t { XY = 17, ZX = 18, YZ = 19 };

/// The values that hold for a row besides its end point.
struct MoveState {
  double feed = 0;           // mm/min, mm/rev or 1/min
  double spindle = 0;        // r/min, or m/min where `surface`
  double max_spindle = 0;    // 0 = no limit
  std::uint32_t offset = 0;  // into the table of offsets
  std::int32_t tool = 0;
  std::int32_t h = 0;
  std::int32_t d = 0;
  Plane plane = Plane::XY;
  FeedMode feed_mode = FeedMode::PerMinute;
  bool surface = false;
  bool cycle = false;  // a canned cycle makes it
  // Of an arc: the axes of its plane whose parts U, V and W make, bit 0 is X and U.
  std::uint8_t parallel = 0;
  std::uint32_t tip = 0;  // into the table of tips, 0 = none
  double turned =
      0;  // radians, counter-clockwise about Z: how work coordinates stand to the machine's
  double degree = 1;  // mm that a degree counts in a path: F is degrees a minute where it is inches

  bool operator==(const MoveState&) const = default;
};

/// Return a point rotated about Z, counter-clockwise.
template <class Point>
Point turned_by(double radians, Point point) {
  if (radians == 0) return point;
  const double c = std::cos(radians), s = std::sin(radians), x = point[0];
  point[0] = x * c - point[1] * s;
  point[1] = x * s + point[1] * c;
  return point;
}

/// The two axes of a plane, and the one across it. G18 is (Z, X).
struct PlaneAxes {
  int a, b, across;
};
inline PlaneAxes plane_axes(Plane plane) {
  switch (plane) {
    case Plane::ZX:
      return {2, 0, 1};
    case Plane::YZ:
      return {1, 2, 0};
    case Plane::XY:
      break;
  }
  return {0, 1, 2};
}

/// Return the axes of an arc, some of which may be U, V and W along X, Y and Z.
inline PlaneAxes arc_axes(Plane plane, std::uint8_t parallel) {
  constexpr int kAlong = 6;  // from X to U
  PlaneAxes axes = plane_axes(plane);
  if ((parallel >> axes.a & 1) != 0) axes.a += kAlong;
  if ((parallel >> axes.b & 1) != 0) axes.b += kAlong;
  return axes;
}
inline PlaneAxes arc_axes(const MoveState& state) { return arc_axes(state.plane, state.parallel); }
/// Return where the centre of an arc has the coordinate of an axis: that of U stands with X.
constexpr std::size_t centre_place(int axis) { return static_cast<std::size_t>(axis % 6); }

/// A move of the tool: from one machine position to another.
struct TimedMove {
  MoveKind kind = MoveKind::Rapid;
  const MoveState& state;
  const Axes &from, &to;
  double path = 0;   // mm; of an arc what lies in its plane
  double zero = 0;   // where X is 0, to which a diameter counts: a machine coordinate
  double dwell = 0;  // s
};
/// Return the speed that a feed per revolution counts on. A spindle that was never told to turn
/// counts as one that turns once a minute, so that the cut ends, late. [policy]
inline double turning(double spindle) { return spindle > 0 ? spindle : 1; }
/// Return how long a move takes, in seconds: reported with each move, and summed up by the run.
double seconds_of(const TimedMove& move, const Axes& rapid, std::uint32_t diameters);
/// Return the r/min at this diameter of a surface speed, m/min, up to a limit, 0 where there is
/// none.
double spindle_at(double surface_speed, double limit, double diameter);
/// Return the same by the values that hold for a row.
inline double spindle_at(const MoveState& state, double diameter) {
  return state.surface ? spindle_at(state.spindle, state.max_spindle, diameter) : state.spindle;
}
/// Return the diameter that counts for a move along X: between those at its ends.
inline double middle_diameter(double from, double to, double zero) {
  return (std::fabs(from - zero) + std::fabs(to - zero)) / 2;
}
constexpr double kNoLength = 1e-9;  // mm: what rounding leaves of a point that did not move
/// Return the millimetres between two points, a diameter axis counting half, rotary axes not
/// counting.
double length_of(const Axes& from, const Axes& to, std::uint32_t diameters);
/// Return the length of an arc by the length in its plane, with that of the other axes.
double arc_length(double in_plane, const PlaneAxes& plane, const Axes& from, const Axes& to,
                  std::uint32_t diameters);
double rapid_time(const Axes& from, const Axes& to, const Axes& rapid, std::uint32_t diameters);
/// Return the length of an arc whose radius grows evenly from the first to the last over an angle.
/// Such an arc misses its end inside the tolerance, and the tool reaches it on a spiral. [ALM
/// 020][M7 p.194]
inline double spiral_length(double first, double last, double turn) {
  const double growth = last - first, mean = (first + last) / 2 * turn;
  if (growth == 0) return std::fabs(mean);
  if (std::fabs(growth) <= 1e-5 * (first + last)) return std::sqrt(mean * mean + growth * growth);
  const double k = std::fabs(growth / turn);  // of the radius, for each radian
  const auto upto = [k](double radius) {
    return radius * std::sqrt(radius * radius + k * k) + k * k * std::asinh(radius / k);
  };
  return std::fabs(turn / (2 * growth) * (upto(last) - upto(first)));
}

}  // namespace cncsub
