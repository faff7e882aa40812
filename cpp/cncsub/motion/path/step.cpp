// Radius compensation of low steps: moves of some increments, whose direction rounding made. Such a
// step waits for the move behind it. Where the tool touches it only at an end, the step decides no
// corner: the tool goes over it, from the move before it to the one behind it.
#include <algorithm>

#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/geometry.hpp"
#include "cncsub/motion/path/radius.hpp"

namespace cncsub {
namespace {

/// So many increments a word may be rounded by: inches are written with a digit less than they
/// have.
constexpr double kLowStep = 16;
constexpr double kShortStep = 64;  // its length, in increments

double sign(double value) { return value > 0 ? 1 : -1; }

/// The direction of a tool that goes around an edge.
Point along_edge(Point tool, Point edge, double offset) {
  return (-1 / offset) * left(tool - edge);
}

/// How far a tool beside the start of a move cuts into it: not into what an arc would be before it.
double cut_into(const Curve& curve, Point tool, double offset) {
  const double beside =
      std::fabs(offset) - cross(curve.start_direction(), tool - curve.from) * sign(offset);
  if (curve.straight()) return beside;
  const double away = moved_radius(curve, curve.from, offset) - size(tool - curve.centre);
  return std::min(beside, (curve.turn > 0) == (offset > 0) ? -away : away);
}

/// Where the tool stops to follow `a` because it touches the end of `b`, a low step behind an
/// inside corner, while nothing else of `b` is in its reach; nothing where it follows `b`.
std::optional<Point> over_step(const Curve& a, const Curve& b, double offset, double least) {
  const double height = cross(a.end_direction(), b.to - b.from) * sign(offset);
  if (height > kLowStep * least || std::fabs(b.turn) > kPi / 2) return std::nullopt;
  const Curve end{b.to, b.to, b.to, -sign(offset)};  // an arc without a radius
  const auto touch = meeting(a, end, offset, least);
  if (!touch || dot(*touch - b.to, b.end_direction()) < -least) return std::nullopt;
  if (dot(*touch - b.to, a.end_direction()) > least) return std::nullopt;  // it has passed by it
  return touch;
}

}  // namespace

/// Whether the corner before a move is better decided when the move behind it is known.
bool RadiusPath::is_low_step(double side, const Curve& curve) const {
  const LookaheadQueue& lookahead = sink.state.lookahead;
  if (size(curve.to - curve.from) > kShortStep * least || std::fabs(curve.turn) > kPi / 2 ||
      lookahead.radius.empty() || lookahead.starting)
    return false;
  return offset_of(lookahead.radius.front()) * side > 0;
}

/// The low step that waits follows the move before it, now that the `next` one is known.
Result RadiusPath::take_step(const Curve* next) {
  LookaheadQueue& lookahead = sink.state.lookahead;
  if (lookahead.step == 0) return std::nullopt;
  const auto first = lookahead.radius.begin() + static_cast<std::ptrdiff_t>(lookahead.step);
  std::vector<Piece> rest(first, lookahead.radius.end());
  lookahead.radius.erase(first, lookahead.radius.end());
  lookahead.step = 0;
  Axes start = lookahead.step_from;
  bool over = false;
  if (auto wrong = follow(rest.front(), curve_of(view, start, rest.front()), next, start, over))
    return wrong;
  if (over) straighten(rest.front());
  lookahead.radius_from = start;
  lookahead.radius = std::move(rest);
  return std::nullopt;
}

/// Behind an inside corner the tool stops where it touches the end of the step, before one it comes
/// from where it touches the start; neither may cut into the moves beside the step.
bool RadiusPath::join_over_step(const Curve& a, const Curve& b, double offset, Join& join) const {
  const auto go_over = [&](Join::Step step, Point touch, Point along) {
    join.over = step;
    join.leave = touch - a.to;
    join.along = along;
    return true;
  };
  if (const auto touch = over_step(a, b, offset, least))
    return go_over(Join::Second, *touch, along_edge(*touch, b.to, offset));
  const LookaheadQueue& lookahead = sink.state.lookahead;
  const Point before{lookahead.entered[0], lookahead.entered[1]};
  if (dot(before, before) == 0 || inside(before, a.start_direction(), offset)) return false;
  const auto touch = over_step(reversed(b), reversed(a), -offset, least);
  const Point tool = a.from + Point{lookahead.vector[0], lookahead.vector[1]};
  const double cut = cut_into(b, tool, offset);
  if (!touch || cut > least) return false;
  const Point along = along_edge(*touch, a.from, offset);
  if (!inside(before, along, offset)) return go_over(Join::First, *touch, along);
  return cut > -least && go_over(Join::First, tool, before);
}

/// Before a low step in an outside corner: the tool goes around only as far as the move behind the
/// step asks, or straight to that where the two meet in a corner that is inside by a hair.
bool RadiusPath::join_before_step(const Curve& a, const Curve& b, const Curve& behind,
                                  double offset, Join& join) const {
  const Point u = a.end_direction();
  if (inside(u, b.start_direction(), offset)) return false;
  const Point v = b.end_direction(), w = behind.start_direction();
  if (!inside(v, w, offset) || same_normal(offset * v, offset * w)) return false;
  const auto touch = over_step(reversed(behind), reversed(b), -offset, least);
  if (!touch) return false;
  const Point along = along_edge(*touch, b.from, offset);
  if (!inside(u, along, offset)) {
    go_around(a, {b.from, b.from + along, {}, 0}, u, along, offset, join);
    return true;
  }
  if (cut_into(behind, a.to + offset * left(u), offset) > 2 * least) return false;
  const auto meet = meeting(a, behind, offset, least);
  if (meet) join.leave = *meet - a.to;
  return meet.has_value();
}

/// The move that the tool goes over becomes a bit of a line along which it comes to its end.
void RadiusPath::begin_step(const Piece& piece, Axes& from, Point along) {
  LookaheadQueue& lookahead = sink.state.lookahead;
  const Point end = view.point(piece.end), corner = view.point(from);
  const Point start = end - size(end - corner) * along;
  const Point tool = corner + Point{lookahead.vector[0], lookahead.vector[1]};
  view.set(from, start);
  lookahead.vector = {(tool - start).a, (tool - start).b};
}

}  // namespace cncsub
