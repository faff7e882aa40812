#include "cncsub/motion_geometry.hpp"

#include <algorithm>

namespace cncsub {

Point Curve::direction_at(Point p) const {
  Point d = line() ? to - from : left(p - centre);
  if (turn < 0) d = -1 * d;
  const double length = size(d);
  return length > 0 ? (1 / length) * d : Point{1, 0};
}

Curve curve_of(const PlaneView& view, const Axes& from, const Piece& piece) {
  return {view.point(from), view.point(piece.end), view.point(piece.centre), piece.turn};
}

namespace {

std::vector<Point> line_line(Point p, Point u, Point q, Point v) {
  const double denominator = cross(u, v);
  if (std::fabs(denominator) < 1e-12) return {};
  return {p + (cross(q - p, v) / denominator) * u};
}

std::vector<Point> line_circle(Point p, Point u, Point c, double r, double tolerance) {
  const double along = dot(c - p, u), distance = cross(u, c - p);
  const double square = r * r - distance * distance;
  if (std::fabs(distance) > r + tolerance) return {};
  const double half = square > 0 ? std::sqrt(square) : 0;
  return {p + (along - half) * u, p + (along + half) * u};
}

std::vector<Point> circle_circle(Point c, double r, Point d, double s, double tolerance) {
  const double distance = size(d - c);
  if (distance < 1e-12) return {};
  if (distance > r + s + tolerance || distance < std::fabs(r - s) - tolerance) return {};
  const double along = (r * r - s * s + distance * distance) / (2 * distance);
  const double square = r * r - along * along;
  const double half = square > 0 ? std::sqrt(square) : 0;
  const Point u = (1 / distance) * (d - c), foot = c + along * u;
  return {foot + half * left(u), foot - half * left(u)};
}

/// The radius of an arc moved to its left: an arc to the left has its centre there.
double moved_radius(const Curve& curve, double offset) {
  return curve.radius() - (curve.turn > 0 ? offset : -offset);
}

}  // namespace

std::vector<Point> meetings(const Curve& a, double offset_a, const Curve& b, double offset_b,
                            double tolerance) {
  if (!a.line() && b.line()) return meetings(b, offset_b, a, offset_a, tolerance);
  if (a.line()) {
    const Point u = a.start_direction(), p = a.from + offset_a * left(u);
    if (b.line()) {
      const Point v = b.start_direction();
      return line_line(p, u, b.from + offset_b * left(v), v);
    }
    const double radius = moved_radius(b, offset_b);
    return radius < 0 ? std::vector<Point>{} : line_circle(p, u, b.centre, radius, tolerance);
  }
  const double r = moved_radius(a, offset_a), s = moved_radius(b, offset_b);
  if (r < 0 || s < 0) return {};
  return circle_circle(a.centre, r, b.centre, s, tolerance);
}

bool nearest(const std::vector<Point>& points, Point to, Point& found) {
  double best = 0;
  bool any = false;
  for (const Point p : points) {
    const double distance = size(p - to);
    if (any && distance >= best) continue;
    best = distance;
    found = p;
    any = true;
  }
  return any;
}

namespace {

/// Where a curve is, `distance` (straight) before its end or behind its start.
bool at_distance(const Curve& curve, double distance, bool before_end, Point& found) {
  const Point corner = before_end ? curve.to : curve.from;
  if (curve.line()) {
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

/// The foot of a point on a curve, and whether it lies on the curve's own part.
bool foot_on(const Curve& curve, Point p, Point& foot) {
  if (curve.line()) {
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
};

bool cut_chamfer(const Curve& a, const Curve& b, double size, bool chamfer_line, Cut& cut) {
  const Point u = a.end_direction(), v = b.start_direction();
  if (std::fabs(cross(u, v)) < 1e-9 && dot(u, v) > 0) return cut.none = true;
  if (chamfer_line) {
    const double inner = std::acos(std::clamp(-dot(u, v), -1.0, 1.0));
    size = size / (2 * std::sin(inner / 2));
  }
  return at_distance(a, size, true, cut.first) && at_distance(b, size, false, cut.second);
}

bool cut_round(const Curve& a, const Curve& b, double radius, Cut& cut) {
  const Point u = a.end_direction(), v = b.start_direction();
  const double side = cross(u, v);
  if (std::fabs(side) < 1e-9 && dot(u, v) > 0) return cut.none = true;
  cut.left_turn = side > 0;
  const double offset = cut.left_turn ? radius : -radius;
  return nearest(meetings(a, offset, b, offset, 0), a.to, cut.centre) &&
         foot_on(a, cut.centre, cut.first) && foot_on(b, cut.centre, cut.second);
}

/// The angle an arc still runs through when its ends have been cut.
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
              : cut_chamfer(a, b, std::fabs(first.corner_size), chamfer_line, cut)))
    return false;
  if (cut.none) return true;
  view.set(corner.at_first, cut.first);
  view.set(corner.at_second, cut.second);
  corner.first.end = corner.at_first;
  if (!a.line()) corner.first.turn = rest_of_turn(a, a.from, cut.first);
  if (!b.line()) corner.second.turn = rest_of_turn(b, cut.second, b.to);
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
