// Where a stylus touches a workpiece: a ball that moves on a straight line, and the bodies it
// meets.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "cncsub/motion/state/signals.hpp"

namespace cncsub {

using Point3 = std::array<double, 3>;

/// A convex body, or a hole of that shape in the bodies. Lengths in mm.
struct Solid {
  enum class Shape : std::uint8_t { Plane, Box, Cylinder, Sphere } shape = Shape::Plane;
  static constexpr double kOpen = std::numeric_limits<double>::infinity();

  bool hole = false;
  int signal = 0;             // what it touches gives this signal, 0 = any
  Point3 at{};                // on the plane, on the axis; the centre
  Point3 direction{0, 0, 1};  // out of the material; of the axis
  Point3 low{-kOpen, -kOpen, -kOpen}, high{kOpen, kOpen, kOpen};  // of a box
  double radius = 0;
  double first = -kOpen, last = kOpen;  // the ends of a cylinder, along its axis from `at`
};

/// The solids that stand in the machine, and the stylus that feels for them.
struct Workpiece {
  std::vector<Solid> solids;
  double stylus = 0;             // the radius of its ball
  bool by_end = false;           // the tool's point is the end of the ball, not its centre
  std::optional<double> length;  // of the stylus; without it the length offset in force is right
  std::string system = "G54";    // the zero point of the coordinates, "machine" for none
};

/// Take the lid off holes whose faces end in the open: a bore from 0 down in a part whose top is at
/// 0 is entered from above.
void open_holes(std::vector<Solid>& solids);

/// Return where on the path `from`-`to` of its centre, 0 to 1, the ball first presses on a body
/// that gives one of these signals, or on the wall of a hole in one. Holes alone are holes in
/// something without end. A ball that begins inside a body touches at 0; one that only grazes,
/// slides along a face or leaves it does not touch.
std::optional<double> first_contact(const Workpiece& workpiece, SignalMask signals,
                                    const Point3& from, const Point3& to);

}  // namespace cncsub
