#include "cncsub/motion/path/geometry.hpp"

#include <algorithm>

#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {

namespace {

/// Return a direction as a vector of length 1.
Point unit_of(Point d) {
  const double length = size(d);
  return length > 0 ? (1 / length) * d : Point{1, 0};
}

}  // namespace

Curve::Curve(Point first, Point last, Point middle, double angle)
    : from{first.a, first.b}, to{last.a, last.b}, centre{middle.a, middle.b}, turn(angle) {
  if (straight()) {
    u = v = unit_of(last - first);
    return;
  }
  const double way = angle < 0 ? -1 : 1;
  u = unit_of(way * left(first - middle));
  v = unit_of(way * left(last - middle));
}

Curve curve_of(const PlaneView& view, const Axes& from, const Piece& piece) {
  return {view.point(from), view.point(piece.end), view.point(piece.centre), piece.turn};
}

double moved_radius(const Curve& arc, Point end, double offset) {
  return size(end - arc.centre) - (arc.turn > 0 ? offset : -offset);
}

namespace {

/// The points where two curves meet: none, one or two.
struct Meetings {
  std::array<Point, 2> points{};
  int count = 0;

  Meetings() = default;
  Meetings(Point middle, Point half) : points{middle + half, middle - half}, count(2) {}
  explicit Meetings(Point only) : points{only}, count(1) {}
};

Meetings line_line(Point p, Point u, Point q, Point v) {
  const double denominator = cross(u, v);
  if (std::fabs(denominator) < 1e-12) return {};
  return Meetings(p + (cross(q - p, v) / denominator) * u);
}

/// Return half the chord that a line leaves of a circle, 0 where it misses the circle by a hair.
double half_chord(double radius, double distance) {
  const double square = (radius - distance) * (radius + distance);
  return square > 0 ? std::sqrt(square) : 0;
}

Meetings line_circle(Point p, Point u, Point c, double r, double tolerance) {
  const double distance = cross(u, c - p);
  if (std::fabs(distance) > r + tolerance) return {};
  return {p + dot(c - p, u) * u, half_chord(r, distance) * u};
}

Meetings circle_circle(Point c, double r, Point d, double s, double tolerance) {
  const double distance = size(d - c);
  if (distance < 1e-12) return {};
  if (distance > r + s + tolerance || distance < std::fabs(r - s) - tolerance) return {};
  const double along = ((r - s) * (r + s) / distance + distance) / 2;
  const Point u = (1 / distance) * (d - c);
  return {c + along * u, half_chord(r, along) * left(u)};
}

Meetings meetings(const Curve& a, const Curve& b, double offset, double tolerance) {
  const Point u = a.end_direction(), v = b.start_direction();
  const Point p = a.to + offset * left(u), q = b.from + offset * left(v);
  if (a.straight() && b.straight()) return line_line(p, u, q, v);
  const double r = a.straight() ? 0 : moved_radius(a, a.to, offset);
  const double s = b.straight() ? 0 : moved_radius(b, b.from, offset);
  if (a.straight()) return line_circle(p, u, b.centre, std::max(s, 0.0), tolerance);
  if (b.straight()) return line_circle(q, v, a.centre, std::max(r, 0.0), tolerance);
  return circle_circle(a.centre, std::max(r, 0.0), b.centre, std::max(s, 0.0), tolerance);
}

}  // namespace

std::optional<Point> meeting(const Curve& a, const Curve& b, double offset, double tolerance) {
  const Meetings found = meetings(a, b, offset, tolerance);
  if (found.count == 0) return std::nullopt;
  const Point first = found.points[0], second = found.points[1];
  return found.count == 1 || size(first - a.to) <= size(second - a.to) ? first : second;
}

namespace {

/// Find the point of a curve `distance` (straight) before its end or after its start.
bool at_distance(const Curve& curve, double distance, bool before_end, Point& found) {
  const Point corner = before_end ? curve.to : curve.from;
  if (curve.straight()) {
    if (distance > curve.length() + 1e-9) return false;
    const Point u = curve.start_direction();
    found = before_end ? corner - distance * u : corner + distance * u;
    return true;
  }
  const double sine = distance / (2 * curve.radius());
  if (sine > 1) return false;
  const double angle = 2 * std::asin(sine);
  if (angle > std::fabs(curve.turn) + 1e-9) return false;
  const double t = (curve.turn > 0) == before_end ? -angle : angle;
  const Point r = corner - curve.centre;
  found = curve.centre +
          Point{r.a * std::cos(t) - r.b * std::sin(t), r.a * std::sin(t) + r.b * std::cos(t)};
  return true;
}

/// Find the foot of a point on a curve; return whether it lies on the curve's own part.
bool foot_on(const Curve& curve, Point p, Point& foot) {
  if (curve.straight()) {
    const Point u = curve.start_direction();
    const double along = dot(p - curve.from, u);
    foot = curve.from + along * u;
    return along > -1e-9 && along < curve.length() + 1e-9;
  }
  const Point r = p - curve.centre;
  const double distance = size(r);
  if (distance < 1e-12) return false;
  foot = curve.centre + (curve.radius() / distance) * r;
  const Point start = curve.from - curve.centre;
  double t = std::atan2(cross(start, foot - curve.centre), dot(start, foot - curve.centre));
  if (curve.turn < 0) t = -t;
  if (t < -1e-9) t += 2 * kPi;
  return t < std::fabs(curve.turn) + 1e-9;
}

struct Cut {
  Point first, second, centre;
  bool left_turn = false;
  bool none = false;
  bool second_short = false;  // the second curve cannot be cut, the first could
};

bool cut_chamfer(const Curve& a, const Curve& b, double size, bool chamfer_line, Cut& cut) {
  const Point u = a.end_direction(), v = b.start_direction();
  if (std::fabs(cross(u, v)) < 1e-9 && dot(u, v) > 0) return cut.none = true;
  if (chamfer_line) {
    const double inner = std::acos(std::clamp(-dot(u, v), -1.0, 1.0));
    size = size / (2 * std::sin(inner / 2));
  }
  if (!at_distance(a, size, true, cut.first)) return false;
  cut.second_short = !at_distance(b, size, false, cut.second);
  return !cut.second_short;
}

/// Return the curvature of a curve, plus to the left.
double curvature(const Curve& curve) {
  return curve.straight() ? 0 : (curve.turn > 0 ? 1 : -1) / curve.radius();
}

/// Return how far the path turns to the left at a corner, as a sign. At a cusp, where the path goes
/// back the way it came, the curves decide which of them lies to the left.
double turn_at_corner(const Curve& a, const Curve& b, bool cusp) {
  return cusp ? -(curvature(a) + curvature(b)) : cross(a.end_direction(), b.start_direction());
}

/// Place a round of this centre; return whether it touches both curves.
bool touches(const Curve& a, const Curve& b, Point centre, Cut& cut) {
  cut.centre = centre;
  if (!foot_on(a, centre, cut.first)) return false;
  cut.second_short = !foot_on(b, centre, cut.second);
  return !cut.second_short;
}

bool cut_round(const Curve& a, const Curve& b, double radius, Cut& cut) {
  const Point u = a.end_direction(), v = b.start_direction();
  const bool in_line = std::fabs(cross(u, v)) < 1e-9, cusp = in_line && dot(u, v) < 0;
  if (in_line && !cusp) return cut.none = true;
  const double side = turn_at_corner(a, b, cusp);
  if (std::fabs(side) < 1e-9) return false;  // a line back along itself
  cut.left_turn = side > 0;
  const double offset = cut.left_turn ? radius : -radius;
  if (!cusp) {
    const auto centre = meeting(a, b, offset, 0);
    return centre && touches(a, b, *centre, cut);
  }
  // The two centres are equally far from the corner: the one beside both curves counts.
  const Meetings found = meetings(a, b, offset, 0);
  for (int i = 0; i < found.count; ++i)
    if (touches(a, b, found.points[i], cut)) return true;
  return false;
}

/// Return the angle an arc still runs through when its ends have been cut.
double rest_of_turn(const Curve& curve, Point from, Point to) {
  const Point r = from - curve.centre, s = to - curve.centre;
  double t = std::atan2(cross(r, s), dot(r, s));
  if (curve.turn > 0 && t < 0) t += 2 * kPi;
  if (curve.turn < 0 && t > 0) t -= 2 * kPi;
  return t;
}

}  // namespace

bool cut_corner(const PlaneView& view, const Axes& from, const Piece& first, const Piece& second,
                bool chamfer_line, CornerPieces& corner) {
  const Curve a = curve_of(view, from, first), b = curve_of(view, first.end, second);
  corner.first = first;
  corner.second = second;
  corner.at_first = corner.at_second = first.end;
  Cut cut;
  const bool round = first.corner == 'R';
  if (!(round ? cut_round(a, b, std::fabs(first.corner_size), cut)
              : cut_chamfer(a, b, std::fabs(first.corner_size), chamfer_line, cut))) {
    corner.second_short = cut.second_short;
    return false;
  }
  if (cut.none) return true;
  view.set(corner.at_first, cut.first);
  view.set(corner.at_second, cut.second);
  corner.first.end = corner.at_first;
  if (!a.straight()) corner.first.turn = rest_of_turn(a, a.from, cut.first);
  if (!b.straight()) corner.second.turn = rest_of_turn(b, cut.second, b.to);
  corner.has_between = true;
  corner.between = first;
  corner.between.corner_piece = true;
  corner.between.end = corner.at_second;
  corner.between.named = axis_bit(view.axes.a) | axis_bit(view.axes.b);
  corner.first.named |= corner.between.named;
  corner.between.kind = MoveKind::Feed;
  corner.between.turn = 0;
  if (!round) return true;
  corner.between.kind = cut.left_turn ? MoveKind::Ccw : MoveKind::Cw;
  view.set(corner.between.centre, cut.centre);
  const Curve arc{cut.first, cut.second, cut.centre, cut.left_turn ? 1.0 : -1.0};
  corner.between.turn = rest_of_turn(arc, cut.first, cut.second);
  return true;
}

}  // namespace cncsub
