// Radius compensation: a compensated move waits until the next one says where the tool leaves it.
#include "cncsub/motion/path/radius.hpp"

#include <algorithm>
#include <utility>

#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/geometry.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/modes.hpp"

namespace cncsub {
namespace {

/// Return the signed angle from one direction to another, at most half a turn.
double angle(Point from, Point to) { return std::atan2(cross(from, to), dot(from, to)); }

/// Return how far a step along `u` leads away from a line along `v`, 0 to 1.
double sharpness(Point u, Point v) { return dot(u, v) < 0 ? 1 : std::fabs(cross(u, v)); }

/// The most moves that wait because they are too short.
constexpr std::size_t kReadAhead = 8;

/// Around a corner by more than this the tool goes in an arc, also where a code lets the moved
/// paths meet: as DISC=0 has it. [general knowledge of the SINUMERIK 840D]
constexpr double kLeastMeeting = 100 * kPi / 180;

}  // namespace

/// Set the start of a move to the end of the last one in the plane, where the increment cannot tell
/// the two points apart.
void RadiusPath::find_start(Axes& from) const {
  const LookaheadQueue& lookahead = sink.state.lookahead;
  if (lookahead.radius.empty() && !lookahead.engaged) return;
  const Point corner = view.point(lookahead.radius_to), there = view.point(from);
  if ((corner.a != there.a || corner.b != there.b) && same(corner, there)) view.set(from, corner);
}

bool RadiusPath::moves_in_plane(const Piece& piece, const Axes& from) const {
  if (piece.kind == MoveKind::Dwell) return false;
  return std::fabs(piece.turn) > kPi || !same(view.point(from), view.point(piece.end));
}

/// Join two moves around an outside corner. Up to 90 degrees the tool follows the tangents to where
/// they meet. [M7 p.191]
void RadiusPath::go_around(const Curve& a, const Curve& b, Point u, Point v, double offset,
                           Join& join) const {
  const Point na = offset * left(u), nb = offset * left(v);
  const double reach = std::fabs(offset);
  join.leave = na;
  // The tool goes straight on after the first move: a line is made longer, an arc goes on in a
  // line.
  const auto go_on = [&](double along) {
    if (a.straight())
      join.leave = na + along * u;
    else
      join.go_by(na + along * u);
  };
  const double cosine = dot(u, v);
  const AcuteCorner corner = sink.facts.control->motion.acute_corner.value;
  const bool by_code = corner == AcuteCorner::ByCode;
  const bool meets = sink.state.modal[at(Group::Corner)].meaning == Meaning::CornerMeet;
  if (by_code ? meets && cosine > std::cos(kLeastMeeting) : cosine >= -1e-9) {
    go_on(reach * std::fabs(cross(u, v)) / (1 + cosine));
    if (!b.straight()) join.go_by(nb);
    return;
  }
  if (corner != AcuteCorner::Lines) {
    join.go_by(nb);
    join.turn = std::acos(std::max(cosine, -1.0)) * (offset > 0 ? -1 : 1);
    return;
  }
  go_on(reach);
  join.go_by(nb - reach * v);
  if (!b.straight()) join.go_by(nb);
}

Result RadiusPath::join(const Curve& a, const Curve& b, const Curve* behind, double offset,
                        std::uint32_t at, Join& join) const {
  const Point u = a.end_direction(), v = b.start_direction();
  const Point na = offset * left(u), nb = offset * left(v);
  if (behind != nullptr && join_before_step(a, b, *behind, offset, join)) return std::nullopt;
  if (same_normal(na, nb)) {  // tangent: an arc keeps its own normal
    join.leave = a.straight() ? nb : na;
  } else if (!inside(u, v, offset)) {
    go_around(a, b, u, v, offset, join);
  } else if (join_over_step(a, b, offset, join)) {
    return std::nullopt;
  } else if (const auto meet = meeting(a, b, offset, least)) {
    join.leave = *meet - a.to;
  } else {
    return no_meeting(a, b, offset, at);
  }
  return std::nullopt;
}

/// Return why two offset moves do not meet: the tool does not fit into one of them, or they lie
/// apart.
Fault RadiusPath::no_meeting(const Curve& a, const Curve& b, double offset,
                             std::uint32_t at) const {
  if (!a.straight() && moved_radius(a, a.to, offset) < -least)
    return arc_too_small(sink.state.lookahead.radius.front().at);
  if (!b.straight() && moved_radius(b, b.from, offset) < -least) return arc_too_small(at);
  Fault wrong = fault_at({.addresses = kAxisWords}, Cause::CompensationNoIntersection, at);
  wrong.kind = {a.straight() ? 'L' : 'A', b.straight() ? 'L' : 'A'};
  return wrong;
}

/// Refuse a move that the tool would make backwards. [16iLB p.208] The tool may go back as far as
/// does not cut an increment into the moves beside. An arc into which the tool only just fits has
/// no path left, and becomes a line.
Result RadiusPath::check_direction(const Curve& curve, Piece& piece, Point& v, Point next) const {
  const LookaheadQueue& lookahead = sink.state.lookahead;
  const Point start = curve.from + Point{lookahead.vector[0], lookahead.vector[1]},
              stop = curve.to + v;
  const Point u = curve.start_direction(), w = curve.end_direction();
  const auto cuts = [&](double back) {
    const double before = sharpness({lookahead.entered[0], lookahead.entered[1]}, u);
    return back * std::max(before, sharpness(w, next)) > least;
  };
  const auto interference = [&] {
    return fault_at({.addresses = kAxisWords}, Cause::CompensationInterference, piece.at);
  };
  if (curve.straight()) return cuts(-dot(stop - start, u)) ? Result(interference()) : std::nullopt;
  const double first = moved_radius(curve, curve.from, offset_of(piece)),
               last = moved_radius(curve, curve.to, offset_of(piece));
  if (first + last < -2 * least) return arc_too_small(piece.at);
  const double radius = std::max(first, last);
  if (radius <= least) {  // around the centre there is no direction
    straighten(piece);
    return std::nullopt;
  }
  const Point r = start - curve.centre, s = stop - curve.centre;
  const double way =
      curve.turn + angle(curve.to - curve.centre, s) - angle(curve.from - curve.centre, r);
  const double forward = curve.turn > 0 ? way : -way;
  if (cuts(-forward * radius)) return interference();
  if (forward <= 0)
    straighten(piece);
  else if (forward > 2 * kPi)  // once round, and a hair further
    v = start - curve.to;
  return std::nullopt;
}

/// Record the waiting move, which is this curve, up to its end, then the path around the corner.
Result RadiusPath::record_waiting(const Curve& curve, Point& v, const Join* join, Point next) {
  LookaheadQueue& lookahead = sink.state.lookahead;
  Piece& first = lookahead.radius.front();
  Point u;
  if (!lookahead.starting) {
    const bool over = join != nullptr && join->over == Join::First;
    if (over)
      straighten(first);
    else if (auto wrong = check_direction(curve, first, v, next))
      return wrong;
    if (join != nullptr) u = over ? join->along : curve.end_direction();
  }
  lookahead.entered = {u.a, u.b};
  if (auto wrong = record(first, v)) return wrong;
  for (std::size_t i = 0; join != nullptr && i < join->points; ++i) {
    v = join->way[i];
    if (auto wrong = record_bit(first, first.end, v, join->turn)) return wrong;
  }
  return std::nullopt;
}

/// Record the waiting move, the path around the corner, and the idle blocks after them. `next` is
/// the direction of the move after the corner, the zero vector where there is none.
Result RadiusPath::leave(const Curve& curve, Point v, const Join* join, Point next) {
  LookaheadQueue& lookahead = sink.state.lookahead;
  if (auto wrong = record_waiting(curve, v, join, next)) return wrong;
  for (std::size_t i = 1; i < lookahead.radius.size(); ++i)
    if (auto wrong = record_idle(lookahead.radius[i], v)) return wrong;
  lookahead.radius.clear();
  lookahead.starting = false;
  lookahead.engaged = true;
  return std::nullopt;
}

/// End the waiting move on its own normal.
Result RadiusPath::flush() {
  const LookaheadQueue& lookahead = sink.state.lookahead;
  if (auto wrong = take_step(nullptr)) return wrong;
  if (lookahead.radius.empty()) return std::nullopt;
  const Piece& first = lookahead.radius.front();
  const Curve curve = curve_of(view, lookahead.radius_from, first);
  return leave(curve, offset_of(first) * left(curve.end_direction()), nullptr, {});
}

/// End the compensation. The last compensated move ends on its normal, or goes around an outside
/// corner; then the tool goes straight to the point.
Result RadiusPath::cancel(const Piece& piece, const Curve& curve) {
  LookaheadQueue& lookahead = sink.state.lookahead;
  const bool around = sink.facts.control->motion.start_up.value == StartUp::TypeB &&
                      !lookahead.radius.empty() && !lookahead.starting && !is_arc(piece);
  if (around) {
    const Piece& first = lookahead.radius.front();
    const Curve before = curve_of(view, lookahead.radius_from, first);
    const double offset = offset_of(first);
    if (!inside(before.end_direction(), curve.start_direction(), offset)) {
      Join way;
      if (auto wrong = join(before, curve, nullptr, offset, piece.at, way)) return wrong;
      if (auto wrong = leave(before, way.leave, &way, curve.start_direction())) return wrong;
    }
  }
  if (auto wrong = flush()) return wrong;
  if (is_arc(piece)) return Fault{Cause::CompensationEndArc, piece.at, 1, {}};
  lookahead.engaged = false;
  return record(piece, {});
}

Result RadiusPath::find_join(double side, std::uint32_t at, const Curve& before, const Curve& curve,
                             const Curve* behind, Join& way) const {
  const LookaheadQueue& lookahead = sink.state.lookahead;
  const double offset = offset_of(lookahead.radius.front());
  const Point u = before.end_direction(), v = curve.start_direction();
  const StartUp start_up = sink.facts.control->motion.start_up.value;
  const bool start_around = lookahead.starting && start_up == StartUp::TypeB &&
                            !inside(u, v, side) && std::fabs(cross(u, v)) > 1e-9;
  if (lookahead.starting && !start_around) {
    way.leave = offset * left(v);
  } else if (!lookahead.starting && offset * side < 0) {  // to the other side
    way.leave = offset * left(u);
    way.go_by(side * left(v));
  } else {
    return join(before, curve, behind, offset, at, way);
  }
  return std::nullopt;
}

/// Record the waiting move: the next one says where the tool leaves it.
Result RadiusPath::follow(const Piece& piece, const Curve& curve, const Curve* behind, Axes& from,
                          bool& over) {
  const LookaheadQueue& lookahead = sink.state.lookahead;
  const Point v = curve.start_direction();
  if (lookahead.radius.empty()) {
    const Point normal = offset_of(piece) * left(v);
    // After a flush the tool first goes onto the normal of this move.
    if (same_normal(normal, {lookahead.vector[0], lookahead.vector[1]})) return std::nullopt;
    return record_bit(piece, from, normal, 0);
  }
  const Curve before = curve_of(view, lookahead.radius_from, lookahead.radius.front());
  Join way;
  if (auto wrong = find_join(offset_of(piece), piece.at, before, curve, behind, way)) return wrong;
  over = way.over == Join::Second;
  if (auto wrong = leave(before, way.leave, &way, over ? way.along : v)) return wrong;
  if (over) begin_step(piece, from, way.along);
  return std::nullopt;
}

Result flush_radius(MoveSink& sink) {
  if (sink.state.lookahead.radius.empty()) return std::nullopt;
  if (is_by_own_normal(sink.facts)) return end_own_normal(sink);
  return RadiusPath(sink, sink.state.lookahead.radius.front().plane).flush();
}

/// Let a move without a path in the plane wait after the one that has one; without one, record it.
static Result look_over(RadiusPath& path, const Piece& piece, const Axes& from) {
  LookaheadQueue& lookahead = path.sink.state.lookahead;
  // A step of an increment has no direction, but its block counts as one with a move: on a diameter
  // it is half an increment long.
  if (piece.kind != MoveKind::Dwell && lookahead.radius.size() < kReadAhead &&
      size(path.view.point(piece.end) - path.view.point(from)) > path.least / 4)
    lookahead.moved = true;
  if (lookahead.radius.empty())
    return path.record_idle(piece, {lookahead.vector[0], lookahead.vector[1]});
  lookahead.radius.push_back(piece);
  return std::nullopt;
}

Result through_radius(MoveSink& sink, const Piece& piece, const Axes& from) {
  LookaheadQueue& lookahead = sink.state.lookahead;
  const bool active = piece.side != 0;
  if (!active && !lookahead.engaged && lookahead.radius.empty())
    return record_move(sink, piece, {});
  if (is_by_own_normal(sink.facts)) return by_own_normal(sink, piece, from);
  RadiusPath path(sink, piece.plane);
  Axes start = from;
  path.find_start(start);
  if (!path.moves_in_plane(piece, start)) return look_over(path, piece, from);
  const Curve curve = curve_of(path.view, start, piece);
  lookahead.moved = true;
  const bool along =
      !lookahead.radius.empty() && offset_of(lookahead.radius.front()) * offset_of(piece) > 0;
  if (auto wrong = path.take_step(along ? &curve : nullptr)) return wrong;
  if (!active) return path.cancel(piece, curve);
  if (path.is_low_step(offset_of(piece), curve)) {
    lookahead.step = lookahead.radius.size();
    lookahead.step_from = start;
    lookahead.radius_to = piece.end;
    lookahead.radius.push_back(piece);
    return std::nullopt;
  }
  bool over = false;
  if (lookahead.engaged || !lookahead.radius.empty()) {
    if (auto wrong = path.follow(piece, curve, nullptr, start, over)) return wrong;
  } else if (is_arc(piece)) {
    return Fault{Cause::CompensationArc, piece.at, 1, {}};
  } else {
    lookahead.starting = true;
  }
  lookahead.radius_from = start;
  lookahead.radius_to = piece.end;
  lookahead.radius.push_back(piece);
  if (over) straighten(lookahead.radius.back());
  return std::nullopt;
}

/// Count the blocks in a row without a move in the plane. After more of them than the control looks
/// over, the waiting move ends on its normal.
Result count_idle(MoveSink& sink, std::uint32_t at) {
  LookaheadQueue& lookahead = sink.state.lookahead;
  const bool moved = std::exchange(lookahead.moved, false) || !lookahead.corner.empty() ||
                     sink.state.pending_angle.waiting();
  if (lookahead.radius.empty() || moved || is_by_own_normal(sink.facts)) {
    lookahead.idle = 0;
    return std::nullopt;
  }
  const Control& c = *sink.facts.control;
  if (++lookahead.idle <= c.motion.idle_blocks.value) return std::nullopt;
  if (sink.facts.refuses(Cause::CompensationIdle)) return Fault{Cause::CompensationIdle, at, 1, {}};
  lookahead.idle = 0;
  return flush_radius(sink);
}

}  // namespace cncsub
