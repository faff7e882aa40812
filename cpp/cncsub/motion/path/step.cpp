// Radius compensation of low steps: moves of a few increments, whose direction comes of rounding.
// Such a step waits for the move after it. Where the tool touches it only at an end, the step
// decides no corner: the tool goes over it, from the move before it to the one after it.
#include <algorithm>

#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/geometry.hpp"
#include "cncsub/motion/path/radius.hpp"

namespace cncsub {
namespace {

/// The most increments by which a word may be rounded. Inches are written with a digit less than
/// they have.
constexpr double kLowStep = 16;
constexpr double kShortStep = 64;  // the longest low step, in increments

double sign(double value) { return value > 0 ? 1 : -1; }

/// Return the direction of a tool that goes around an edge.
Point along_edge(Point tool, Point edge, double offset) {
  return (-1 / offset) * left(tool - edge);
}

/// Return how far a tool beside the start of a move cuts into it. The extension of an arc before
/// its start does not count.
double cut_into(const Curve& curve, Point tool, double offset) {
  const double beside =
      std::fabs(offset) - cross(curve.start_direction(), tool - curve.from) * sign(offset);
  if (curve.straight()) return beside;
  const double away = moved_radius(curve, curve.from, offset) - size(tool - curve.centre);
  return std::min(beside, (curve.turn > 0) == (offset > 0) ? -away : away);
}

/// Return where the tool stops following `a` because it touches the end of `b`, a low step after an
/// inside corner, and reaches nothing else of `b`. Return nothing where the tool follows `b`.
std::optional<Point> over_step(const Curve& a, const Curve& b, double offset, double least) {
  const double height = cross(a.end_direction(), b.to - b.from) * sign(offset);
  if (height > kLowStep * least || std::fabs(b.turn) > kPi / 2) return std::nullopt;
  const Curve end{b.to, b.to, b.to, -sign(offset)};  // an arc without a radius
  const auto touch = meeting(a, end, offset, least);
  if (!touch || dot(*touch - b.to, b.end_direction()) < -least) return std::nullopt;
  if (dot(*touch - b.to, a.end_direction()) > least) return std::nullopt;  // passed the step
  return touch;
}

}  // namespace

/// Return whether the corner before a move is better decided once the move after it is known.
bool RadiusPath::is_low_step(double side, const Curve& curve) const {
  const LookaheadQueue& lookahead = sink.state.lookahead;
  if (size(curve.to - curve.from) > kShortStep * least || std::fabs(curve.turn) > kPi / 2 ||
      lookahead.radius.empty() || lookahead.starting)
    return false;
  return offset_of(lookahead.radius.front()) * side > 0;
}

/// Record the move before the waiting low step, which then is the waiting move. `next` is the move
/// after the step, null where it is not known.
Result RadiusPath::take_step(const Curve* next) {
  LookaheadQueue& lookahead = sink.state.lookahead;
  if (lookahead.step == 0) return std::nullopt;
  const auto first = lookahead.radius.begin() + static_cast<std::ptrdiff_t>(lookahead.step);
  Pieces rest(first, lookahead.radius.end());
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

/// Join two moves if the tool goes over one of them, a low step. After an inside corner the tool
/// stops where it touches the end of the step, before one it starts where it touches the start. It
/// may not cut into the moves beside the step.
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

/// Join two moves at an outside corner before a low step. The tool goes around only as far as the
/// move after the step asks, or straight to that move where the two meet in a corner that is inside
/// by a hair.
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

/// Make the step that the tool goes over a short line, along which the tool comes to its end.
void RadiusPath::begin_step(const Piece& piece, Axes& from, Point along) {
  LookaheadQueue& lookahead = sink.state.lookahead;
  const Point end = view.point(piece.end), corner = view.point(from);
  const Point start = end - size(end - corner) * along;
  const Point tool = corner + Point{lookahead.vector[0], lookahead.vector[1]};
  view.set(from, start);
  lookahead.vector = {(tool - start).a, (tool - start).b};
}

}  // namespace cncsub
