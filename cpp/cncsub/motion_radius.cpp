// Radius compensation: a compensated move waits until the next one says where the tool leaves it.
#include "cncsub/motion_geometry.hpp"

namespace cncsub {
namespace {

/// To the left plus, to the right minus; a negative radius swaps the sides.
double offset_of(const Piece& piece) { return piece.side < 0 ? piece.radius : -piece.radius; }

bool is_arc(const Piece& piece) { return piece.turn != 0; }

/// How two moves with their offsets join.
struct Join {
  Point leave;             // where the tool leaves the first move, from the corner
  std::vector<Point> way;  // points in between, from the corner
  double turn = 0;         // of the arc around the corner that leads to the only one of them
};

}  // namespace

/// The geometry of the moves at one corner, in the plane of the moves.
struct RadiusPath {
  Motion& motion;
  Moves* moves;
  PlaneView view;

  using Result = std::optional<Fault>;

  std::array<double, 3> vector_of(Point v) const {
    std::array<double, 3> vector{};
    view.set(vector, v);
    return vector;
  }

  Result record(const Piece& piece, Point v) {
    auto& held = motion.s_.held;
    std::array<double, 3> vector = vector_of(v);
    for (std::size_t i = 0; i < 3; ++i) vector[i] += piece.tip[i];
    if (auto wrong = motion.record(piece, moves, vector)) return wrong;
    held.vector = {v.a, v.b};
    return std::nullopt;
  }

  /// A straight bit around a corner, as a move of the piece it belongs to.
  Result record_bit(Piece piece, const Axes& at, Point v, double turn) {
    piece.end = at;
    piece.turn = turn;
    piece.corner_piece = true;
    if (turn != 0) {
      piece.kind = turn > 0 ? MoveKind::Ccw : MoveKind::Cw;
      view.set(piece.centre, view.point(at));
    } else if (piece.kind != MoveKind::Rapid) {
      piece.kind = MoveKind::Feed;
    }
    return record(piece, v);
  }

  static bool inside(Point u, Point v, double offset) { return cross(u, v) * offset > 0; }

  Result join(const Curve& a, const Curve& b, double offset, std::uint32_t at, Join& join) const;
  void go_around(const Curve& a, const Curve& b, Point u, Point v, double offset, Join& join) const;
  Result check_direction(const Curve& curve, const Piece& piece, double offset, Point end,
                         Point v) const;
  Result leave(Point v, const Join* join);
};

/// Outside corners. Up to 90 degrees the tangents are followed to where they meet. [M7 p.191]
void RadiusPath::go_around(const Curve& a, const Curve& b, Point u, Point v, double offset,
                           Join& join) const {
  const Point na = offset * left(u), nb = offset * left(v);
  const double reach = std::fabs(offset);
  const double angle = std::acos(std::clamp(dot(u, v), -1.0, 1.0));
  // Straight on behind the first move: a line is made longer, an arc goes on in a line.
  const auto go_on = [&](double along) {
    if (a.line())
      join.leave = na + along * u;
    else
      join.way.push_back(na + along * u);
  };
  if (dot(u, v) >= -1e-9) {
    go_on(reach * std::tan(angle / 2));
    if (!b.line()) join.way.push_back(nb);
    return;
  }
  if (motion.facts_->control->acute_corner.value == AcuteCorner::Arc) {
    join.way.push_back(nb);
    join.turn = angle * (offset > 0 ? -1 : 1);
    return;
  }
  go_on(reach);
  join.way.push_back(nb - reach * v);
  if (!b.line()) join.way.push_back(nb);
}

RadiusPath::Result RadiusPath::join(const Curve& a, const Curve& b, double offset, std::uint32_t at,
                                    Join& join) const {
  const Point u = a.end_direction(), v = b.start_direction(), corner = a.to;
  const Point normal = offset * left(u);
  join.leave = normal;
  if (offset == 0) return std::nullopt;
  if (std::fabs(cross(u, v)) < 1e-6 && dot(u, v) > 0) return std::nullopt;
  if (!inside(u, v, offset)) {
    go_around(a, b, u, v, offset, join);
    return std::nullopt;
  }
  Point meet;
  if (!nearest(meetings(a, offset, b, offset, 1e-9), corner, meet))
    return Fault{Cause::CompensationNoIntersection, at, 1, {}};
  join.leave = meet - corner;
  return std::nullopt;
}

/// The tool must go the way the program goes, not back. [16iLB p.208]
RadiusPath::Result RadiusPath::check_direction(const Curve& curve, const Piece& piece,
                                               double offset, Point end, Point v) const {
  Axes tool = motion.s_.tool_at;
  for (std::size_t i = 0; i < tool.size(); ++i)
    tool[i] -= piece.length[i] + (i < 3 ? piece.tip[i] : 0);
  const Point start = view.point(tool), stop = end + v;
  Fault wrong{Cause::CompensationInterference, piece.at, 1, {}};
  if (curve.line()) {
    if (dot(stop - start, curve.start_direction()) < -1e-6) return wrong;
    return std::nullopt;
  }
  if (curve.radius() - (curve.turn > 0 ? offset : -offset) < -1e-9)
    return Fault{Cause::CompensationArcTooSmall, piece.at, 1, {}};
  const Point r = start - curve.centre, s = stop - curve.centre;
  if (size(r) < 1e-9 || size(s) < 1e-9) return std::nullopt;
  const double turn = std::atan2(cross(r, s), dot(r, s));
  const double way = curve.turn + std::remainder(turn - curve.turn, 2 * kPi);
  const bool back = (way > 0) != (curve.turn > 0);
  if (back && std::fabs(way) > 1e-9) return wrong;
  return std::nullopt;
}

/// Records the waiting move up to its end, the blocks behind it, and the way around the corner.
RadiusPath::Result RadiusPath::leave(Point v, const Join* join) {
  Held& held = motion.s_.held;
  const Piece first = held.radius.front();
  const Curve curve = curve_of(view, held.radius_from, first);
  if (!held.starting)
    if (auto wrong = check_direction(curve, first, offset_of(first), curve.to, v)) return wrong;
  if (auto wrong = record(first, v)) return wrong;
  for (std::size_t i = 1; i < held.radius.size(); ++i)
    if (auto wrong = record(held.radius[i], v)) return wrong;
  if (join != nullptr)
    for (const Point& at : join->way)
      if (auto wrong = record_bit(first, first.end, at, join->turn)) return wrong;
  held.radius.clear();
  held.starting = false;
  held.engaged = true;
  return std::nullopt;
}

/// The waiting move ends on its own normal.
Motion::Result Motion::flush_radius(Moves* moves) {
  if (s_.held.radius.empty()) return std::nullopt;
  const Piece& first = s_.held.radius.front();
  RadiusPath path{*this, moves, {plane_axes(first.plane), facts_->share(0)}};
  const Curve curve = curve_of(path.view, s_.held.radius_from, first);
  return path.leave(offset_of(first) * left(curve.end_direction()), nullptr);
}

Motion::Result Motion::through_radius(Piece piece, const Axes& from, Moves* moves) {
  Held& held = s_.held;
  const bool active = piece.side != 0;
  if (!active && !held.engaged && held.radius.empty()) return record(piece, moves, {});
  RadiusPath path{*this, moves, {plane_axes(piece.plane), facts_->share(0)}};
  const Curve curve = curve_of(path.view, from, piece);
  const bool in_plane =
      piece.kind != MoveKind::Dwell && (is_arc(piece) || size(curve.to - curve.from) > 1e-9);
  if (!in_plane) {
    if (!held.radius.empty()) {
      held.radius.push_back(piece);
      return std::nullopt;
    }
    return path.record(piece, {held.vector[0], held.vector[1]});
  }
  if (!active) {
    if (auto wrong = flush_radius(moves)) return wrong;
    if (is_arc(piece)) return Fault{Cause::CompensationEndArc, piece.at, 1, {}};
    held.engaged = false;
    return path.record(piece, {});
  }
  const Point normal = offset_of(piece) * left(curve.start_direction());
  if (!held.engaged && held.radius.empty()) {
    if (is_arc(piece)) return Fault{Cause::CompensationArc, piece.at, 1, {}};
    held.starting = true;
  } else if (held.radius.empty()) {
    // Behind blocks that were not looked over the tool first goes onto the normal of this move.
    if (size(normal - Point{held.vector[0], held.vector[1]}) > 1e-9)
      if (auto wrong = path.record_bit(piece, from, normal, 0)) return wrong;
  } else {
    const Piece& first = held.radius.front();
    const Curve before = curve_of(path.view, held.radius_from, first);
    const double offset = offset_of(first);
    const bool other_side = offset * offset_of(piece) < 0;
    const Point u = before.end_direction(), v = curve.start_direction();
    const bool outside = !RadiusPath::inside(u, v, offset_of(piece)) && cross(u, v) != 0;
    Join join;
    if (held.starting) {
      join.leave = offset * left(v);
      if (facts_->control->start_up.value == StartUp::TypeB && outside)
        if (auto wrong = path.join(before, curve, offset, piece.at, join)) return wrong;
    } else if (other_side) {
      join.leave = offset * left(u);
      join.way.push_back(normal);
    } else if (auto wrong = path.join(before, curve, offset, piece.at, join)) {
      return wrong;
    }
    if (auto wrong = path.leave(join.leave, &join)) return wrong;
  }
  held.radius = {piece};
  held.radius_from = from;
  return std::nullopt;
}

/// Looks over a few blocks without a move in the plane; behind more of them the offset stands on
/// the normal.
Motion::Result Motion::count_idle(BlockWords& block) {
  Held& held = s_.held;
  if (held.radius.empty() || block.in_plane) {
    held.idle = 0;
    return std::nullopt;
  }
  const Control& c = *facts_->control;
  if (++held.idle <= c.idle_blocks.value) return std::nullopt;
  if (c.idle_blocks_alarm.value) return fault(Cause::CompensationIdle, block);
  held.idle = 0;
  return flush_radius(block.moves);
}

}  // namespace cncsub
