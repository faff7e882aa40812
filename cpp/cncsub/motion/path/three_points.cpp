// Arcs through a third point.
#include <cmath>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/geometry.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

constexpr std::string_view kCentreNames = "IJK";

/// Read the point between, whose words are coordinates or increments as those of the end are.
Result point_between(MotionView m, const BlockWords& block, Axes& middle) {
  const MotionState& s = m.state;
  const Axes start = as_programmed(s, s.work);
  middle = start;
  std::uint32_t named = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const char name = kCentreNames[i];
    if (!block.words.has(name)) continue;
    named |= axis_bit(static_cast<int>(i));
    const bool adds = block.words.forms.is_incremental(bit(name), s.incremental);
    middle[i] = number(m, block, name) + (adds ? start[i] : 0);
  }
  const auto across = static_cast<std::size_t>(plane_axes(s.plane).across);
  if (std::fabs(middle[across] - start[across]) > kStanding)
    return fault_at(kCentreNames[across], Cause::CodeNotComputed, block,
                    "cncsub computes an arc through a point only in the plane");
  if (is_turned(s)) turn_point(s, middle, named);
  return std::nullopt;
}

}  // namespace

// A line for each case: shorter would be harder to read.
// NOLINTNEXTLINE(readability-function-size,readability-function-cognitive-complexity)
Result arc_by_points(MotionContext& m, BlockWords& block, Meaning meaning) {
  const PlaneAxes plane = plane_axes(m.state.plane);
  const auto [end, named] = target(m, block);
  if (named == 0) return std::nullopt;
  if (auto wrong = need_feed(m, block, meaning)) return wrong;
  const auto letter = [](int axis) { return kCentreNames[static_cast<std::size_t>(axis)]; };
  if (!block.words.has(letter(plane.a)) && !block.words.has(letter(plane.b)))
    return fault_at({.addresses = kCentreWords}, Cause::ThreePoints, block,
                    "the arc has neither I nor K");
  const auto across = static_cast<std::size_t>(plane.across);
  const bool by_mode = m.state.modal[at(Group::Motion)].variant == 1;
  if (by_mode && std::fabs(end[across] - m.state.work[across]) > kStanding)
    return fault_at(kAxisNames[across], Cause::CodeNotComputed, block,
                    "cncsub computes an arc through a point only in the plane");
  Piece piece = make_piece(m, block, MoveKind::Cw, end, named);
  const PlaneView view{plane, m.facts.share(0)};
  const Axes start = m.state.work + piece.offset;
  Axes middle = start;
  if (by_mode) {
    if (auto wrong = point_between(m, block, middle)) return wrong;
    middle = middle + piece.offset;
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
