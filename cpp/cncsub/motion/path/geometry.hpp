// Lines and arcs in a plane: offsets, intersections, corners.
#pragma once

#include <array>
#include <optional>

#include "cncsub/motion/state/facts.hpp"

namespace cncsub {

struct Point {
  double a = 0, b = 0;
};
inline Point operator+(Point p, Point q) { return {p.a + q.a, p.b + q.b}; }
inline Point operator-(Point p, Point q) { return {p.a - q.a, p.b - q.b}; }
inline Point operator*(double f, Point p) { return {f * p.a, f * p.b}; }
inline double dot(Point p, Point q) { return p.a * q.a + p.b * q.b; }
inline double cross(Point p, Point q) { return p.a * q.b - p.b * q.a; }
/// Return the length. No length of a machine is so large or so small that its square is no number.
inline double size(Point p) { return std::sqrt(p.a * p.a + p.b * p.b); }
/// Return the vector to the left of a direction.
inline Point left(Point p) { return {-p.b, p.a}; }

/// The two axes of a plane, in true lengths: a diameter axis counts half.
struct PlaneView {
  PlaneView(PlaneAxes of, double x_share)
      : axes(of), a_share(of.a == 0 ? x_share : 1), b_share(of.b == 0 ? x_share : 1) {}

  PlaneAxes axes;
  double a_share, b_share;

  template <class Values>
  Point point(const Values& values) const {
    return {values[static_cast<std::size_t>(axes.a)] * a_share,
            values[static_cast<std::size_t>(axes.b)] * b_share};
  }
  template <class Values>
  void set(Values& values, Point p) const {
    values[static_cast<std::size_t>(axes.a)] = p.a / a_share;
    values[static_cast<std::size_t>(axes.b)] = p.b / b_share;
  }
};

/// A line or an arc with its directions at both ends.
struct Curve {
  Curve(Point first, Point last, Point middle, double angle);
  /// Make a curve whose directions are known.
  Curve(Point first, Point last, Point middle, double angle, Point begins, Point ends)
      : from{first.a, first.b},
        to{last.a, last.b},
        centre{middle.a, middle.b},
        turn(angle),
        u{begins.a, begins.b},
        v{ends.a, ends.b} {}

  Point from, to, centre;
  double turn = 0;  // 0: a straight line
  Point u, v;       // the directions at both ends, cached

  bool straight() const { return turn == 0; }
  double radius() const { return size(from - centre); }
  Point start_direction() const { return u; }
  Point end_direction() const { return v; }
  double length() const { return straight() ? size(to - from) : std::fabs(turn) * radius(); }
};
/// Return the curve in the other direction.
inline Curve reversed(const Curve& c) { return {c.to, c.from, c.centre, -c.turn}; }
Curve curve_of(const PlaneView& view, const Axes& from, const Piece& piece);

/// Return the angle from one direction to another, counter-clockwise in (0, 2 pi], or clockwise in
/// [-2 pi, 0).
inline double turn_between(double from, double to, bool clockwise) {
  double turn = std::remainder(to - from, 2 * kPi);
  if (std::fabs(turn) < 1e-12) turn = 0;
  if (clockwise) return turn >= 0 ? turn - 2 * kPi : turn;
  return turn <= 0 ? turn + 2 * kPi : turn;
}

/// Return the vector from the start of an arc to its centre: `way` leads to its end, which `radius`
/// reaches. The radius is negative where the arc is more than half a circle. What rounding leaves
/// of the height of a half circle is none: its root would move the centre by a millionth of the
/// radius.
inline Point centre_by_radius(Point way, double radius, bool clockwise) {
  constexpr double kRounding = 1e-12;
  const double chord = size(way), square = radius * radius;
  const double rest = square - chord * chord / 4;
  const double height = rest > kRounding * square ? std::sqrt(rest) : 0;
  const double side = clockwise == (radius > 0) ? -height / chord : height / chord;
  return 0.5 * way + side * left(way);
}

/// Return the radius, at one of its ends, of an arc moved to its left. An arc to the left has its
/// centre there. A rounded centre does not lie equally far from both ends.
double moved_radius(const Curve& arc, Point end, double offset);

/// Return where the end of `a` and the start of `b`, which follows it, meet next to the corner when
/// both are moved sideways by `offset` (plus = left). The lines and circles are not bounded. Curves
/// that pass by each other within `tolerance` meet there.
std::optional<Point> meeting(const Curve& a, const Curve& b, double offset, double tolerance);

struct CornerPieces {
  Piece first, between, second;
  bool has_between = false;
  bool second_short = false;     // where no corner is cut: the first could be
  Axes at_first{}, at_second{};  // where the corner begins and ends
};
/// Cut a chamfer or a round between two pieces; return false when one of them is too short.
bool cut_corner(const PlaneView& view, const Axes& from, const Piece& first, const Piece& second,
                bool chamfer_line, CornerPieces& corner);

}  // namespace cncsub
