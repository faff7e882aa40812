// Arcs through a third point, in the plane and in space.
#include <algorithm>
#include <cmath>
#include <optional>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/geometry.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

constexpr std::string_view kCentreNames = "IJK";

/// Return whether a block without a word for an axis of the point between means 0 there: of the two
/// axes of the plane one may be left out. [SONE p.198]
bool is_left_out(MotionView m, const BlockWords& block, int axis) {
  const PlaneAxes plane = plane_axes(m.state.plane);
  if (axis == plane.across) return false;
  const int other = axis == plane.a ? plane.b : plane.a;
  return block.words.has(kCentreNames[static_cast<std::size_t>(other)]);
}

/// Return the point between, whose words are coordinates or increments as those of the end are.
Axes point_between(MotionView m, const BlockWords& block) {
  const MotionState& s = m.state;
  const Axes start = as_programmed(s, s.work);
  Axes middle = start;
  std::uint32_t named = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const char name = kCentreNames[i];
    const bool written = block.words.has(name);
    if (!written && !is_left_out(m, block, static_cast<int>(i))) continue;
    named |= axis_bit(static_cast<int>(i));
    const bool adds = block.words.forms.is_incremental(bit(name), s.incremental);
    middle[i] = (written ? number(m, block, name) : 0) + (adds ? start[i] : 0);
  }
  if (is_turned(s)) turn_point(s, middle, named);
  return middle;
}

using Vector = std::array<double, 3>;

Vector operator*(double factor, const Vector& v) {
  return {factor * v[0], factor * v[1], factor * v[2]};
}
Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
double inner(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vector outer(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector way(const Axes& from, const Axes& to) {
  return {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
}

/// An arc in space: its radius from the centre to the start, and the direction at the start as long
/// as that.
struct SpaceArc {
  Vector centre{}, radius{}, along{};
  double turn = 0;

  Vector at(double angle) const {
    return centre + std::cos(angle) * radius + std::sin(angle) * along;
  }
  Vector direction(double angle) const {
    return std::cos(angle) * along + -std::sin(angle) * radius;
  }
};

/// Return the arc through three points; nothing where they lie in a line.
std::optional<SpaceArc> arc_through(const Axes& start, const Axes& middle, const Axes& end) {
  const Vector a = way(start, middle), b = way(start, end), normal = outer(a, b);
  const double area = std::sqrt(inner(normal, normal));
  if (area < kStanding) return std::nullopt;
  const Vector to_centre =
      1 / (2 * area * area) * (inner(b, b) * outer(normal, a) + inner(a, a) * outer(b, normal));
  SpaceArc arc{.centre = Vector{start[0], start[1], start[2]} + to_centre,
               .radius = -1 * to_centre};
  arc.along = 1 / area * outer(normal, arc.radius);
  const Vector last = b + arc.radius;
  arc.turn = std::atan2(inner(last, arc.along), inner(last, arc.radius));
  if (arc.turn < 0) arc.turn += 2 * kPi;
  return arc;
}

/// Return the plane, that of the block first, along which three points lie.
std::optional<Plane> plane_along(Plane first, const Axes& a, const Axes& b, const Axes& c) {
  for (const Plane plane : {first, Plane::XY, Plane::ZX, Plane::YZ}) {
    const auto across = static_cast<std::size_t>(plane_axes(plane).across);
    if (std::fabs(b[across] - a[across]) <= kStanding &&
        std::fabs(c[across] - a[across]) <= kStanding)
      return plane;
  }
  return std::nullopt;
}

/// Refuse what no arc outside of the plane in force has.
Result check_beside_plane(MotionView m, const BlockWords& block, const Axes& middle,
                          const Axes& end) {
  for (std::size_t i = 0; i < kCentreNames.size(); ++i)
    if (!block.words.has(kCentreNames[i]) &&
        std::max(std::fabs(end[i] - m.state.work[i]), std::fabs(middle[i] - m.state.work[i])) >
            kStanding)
      return fault_at({.addresses = kCentreWords}, Cause::CodeNotComputed, block,
                      "cncsub computes an arc outside of the plane only with I1, J1 and K1");
  const bool each_cut = m.state.modal[at(Group::Feed)].meaning == Meaning::InverseTime;
  if (side_of(m.state) == 0 && !moves_wait(m.state) && !may_have_corner(m, block) && !each_cut)
    return std::nullopt;
  return fault_at({.addresses = kCentreWords}, Cause::CodeNotComputed, block,
                  "cncsub computes an arc outside of the plane only without compensation, corners "
                  "and G93");
}

/// Move along an arc in space, in lines that are an increment away from it at most.
Result move_in_space(MotionContext& m, BlockWords& block, const SpaceArc& arc, const Axes& end,
                     std::uint32_t named) {
  const Axes start = m.state.work;
  const double size = std::sqrt(inner(arc.radius, arc.radius));
  const double away = std::min(least_length(m) / size, 1.0);
  const double count = std::ceil(arc.turn / (2 * std::acos(1 - away)));
  for (double i = 1; i < count; ++i) {
    const double share = i / count;
    const Vector point = arc.at(share * arc.turn);
    Axes to = start;
    for (std::size_t axis = 0; axis < to.size(); ++axis)
      to[axis] =
          axis < point.size() ? point[axis] : start[axis] + share * (end[axis] - start[axis]);
    if (auto wrong = move(m, block, MoveKind::Feed, to, named | 7u)) return wrong;
  }
  if (auto wrong = move(m, block, MoveKind::Feed, end, named | 7u)) return wrong;
  if (!m.facts.keeps_heading) return std::nullopt;
  const Vector direction = arc.direction(arc.turn);  // that of the arc, not of its last line
  Axes heading{};
  std::copy(direction.begin(), direction.end(), heading.begin());
  if (m.state.frame.turned) heading = turned_back(m.state.frame, heading);
  std::copy_n(heading.begin(), m.state.heading.size(), m.state.heading.begin());
  return std::nullopt;
}

}  // namespace

// A line for each case: shorter would be harder to read.
// NOLINTNEXTLINE(readability-function-size,readability-function-cognitive-complexity)
Result arc_by_points(MotionContext& m, BlockWords& block, Meaning meaning) {
  const auto [end, named] = target(m, block);
  if (named == 0) return std::nullopt;
  if (auto wrong = need_feed(m, block, meaning)) return wrong;
  const auto letter = [](int axis) { return kCentreNames[static_cast<std::size_t>(axis)]; };
  PlaneAxes plane = plane_axes(m.state.plane);
  const bool by_mode = m.state.modal[at(Group::Motion)].variant == 1;
  const bool between = by_mode
                           ? (block.words.mask & kCentreWords) != 0
                           : block.words.has(letter(plane.a)) || block.words.has(letter(plane.b));
  if (!between)
    return fault_at({.addresses = kCentreWords}, Cause::ThreePoints, block,
                    by_mode ? "no word gives the point between the ends of the arc"
                            : "the arc has neither I nor K");
  Piece piece = make_piece(m, block, MoveKind::Cw, end, named);
  const Axes start = m.state.work + piece.offset;
  Axes middle = start;
  if (by_mode) {
    middle = point_between(m, block);
    const auto beside = plane_along(m.state.plane, m.state.work, middle, end);
    if (beside != m.state.plane)
      if (auto wrong = check_beside_plane(m, block, middle, end)) return wrong;
    if (!beside) {
      const auto arc = arc_through(m.state.work, middle, end);
      if (!arc) return fault_at({.addresses = kCentreWords}, Cause::ThreePoints, block);
      return move_in_space(m, block, *arc, end, named);
    }
    middle = middle + piece.offset;
    piece.plane = piece.state.plane = *beside;
    plane = plane_axes(*beside);
  } else {
    for (const int axis : {plane.a, plane.b}) {
      const char name = kCentreNames[static_cast<std::size_t>(axis)];
      const double value = block.words.has(name) ? number(m, block, name) : 0;
      if (meaning == Meaning::ThreePointsAbsolute)
        middle[axis] = value + piece.offset[axis];
      else
        middle[axis] += value / m.facts.share(axis);
    }
  }
  const PlaneView view{plane, m.facts.share(0)};
  const Point p = view.point(start), u = view.point(middle) - p, v = view.point(piece.end) - p;
  const double area = 2 * cross(u, v);
  if (std::fabs(area) < 1e-9)
    return fault_at({.addresses = kCentreWords}, Cause::ThreePoints, block);
  const Point centre = p + Point{(v.b * dot(u, u) - u.b * dot(v, v)) / area,
                                 (u.a * dot(v, v) - v.a * dot(u, u)) / area};
  const bool clockwise = area < 0;
  view.set(piece.centre, centre);
  piece.kind = clockwise ? MoveKind::Cw : MoveKind::Ccw;
  const Point from = p - centre, to = p + v - centre;
  piece.turn = turn_between(std::atan2(from.b, from.a), std::atan2(to.b, to.a), clockwise);
  return move(m, block, piece);
}

}  // namespace cncsub
