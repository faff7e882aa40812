// Radius compensation whose moves end on their own normals. A move waits only for the corner at its
// end: an inside corner moves that end back, around an outside one the tool goes in an arc.
#include <algorithm>

#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/geometry.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/path/radius.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

constexpr double kCorner = 0.05;  // radians: what turns by less is no corner [rs274 2.9]
constexpr double kSlack =
    0.0254;  // radians by which an arc may get longer, in mm; a thousandth in inches
constexpr double kMismatch = 0.01;  // program units by which the radii of an arc may differ

Point unit_of(double angle) { return {std::cos(angle), std::sin(angle)}; }
double direction(Point way) { return std::atan2(way.b, way.a); }
/// Return whether the tool goes inside of an arc.
bool goes_inside(const Piece& arc) { return offset_of(arc) * arc.turn > 0; }
double quarter(bool left) { return left ? kPi / 2 : -kPi / 2; }

/// Return the whole turns that an arc makes beside the one that leads to its end.
double more_turns(const Piece& arc) {
  return std::max(0.0, std::ceil(std::fabs(arc.turn) / (2 * kPi) - 1e-9) - 1);
}
double turn_of(const Piece& arc, Point from, Point centre, Point to) {
  const bool clockwise = arc.turn < 0;
  const double turn = turn_between(direction(from - centre), direction(to - centre), clockwise);
  return turn + (clockwise ? -2 : 2) * kPi * more_turns(arc);
}

std::string kind_name(const Piece& piece) {
  if (is_arc(piece)) return "Arc move";
  return piece.kind == MoveKind::Rapid ? "Straight traverse" : "Straight feed";
}

Fault cut_short(const Piece& waiting, std::uint32_t at) {
  Fault wrong = fault_at({.addresses = kAxisWords}, Cause::CompensationInterference, at);
  wrong.name = kind_name(waiting);
  return wrong;
}

Fault no_corner(const Piece& first, const Piece& second) {
  Fault wrong = fault_at({.addresses = kAxisWords}, Cause::CompensationNoIntersection, second.at);
  wrong.kind = {is_arc(first) ? 'A' : 'L', is_arc(second) ? 'A' : 'L'};
  wrong.name = is_arc(second) ? "Arc to arc motion" : "Arc to straight motion";
  return wrong;
}

struct OwnNormal {
  MoveSink& sink;
  PlaneView view;

  OwnNormal(MoveSink& s, Plane plane) : sink(s), view{plane_axes(plane), s.facts.share(0)} {}

  LookaheadQueue& lookahead() const { return sink.state.lookahead; }
  /// Return where the contour is, and the tool beside it.
  Point corner() const { return view.point(lookahead().radius_to); }
  Point tool() const { return corner() + Point{lookahead().vector[0], lookahead().vector[1]}; }

  Result record(const Piece& piece, Point beside) const {
    std::array<double, 3> vector{};
    view.set(vector, beside);
    return record_move(sink, piece, vector);
  }
  Result let_go() const;
  Result move_back(Point to, std::uint32_t at) const;
  Result go_around(const Piece& next, Point to) const;
  Result stands_at(Result wrong, Point at) const;
  void wait(const Piece& piece, Point to, Point way) const;

  Result begin(Piece piece, Point start) const;
  Result line(Piece piece) const;
  Result arc(Piece piece) const;
  Result end_before_line(const Piece& piece, Point v, double away) const;
  Result end_before_arc(const Piece& piece, Point u, double away) const;
  Result end_line_before_arc(const Piece& piece, Point u, double away) const;
  Result end_arc_before_arc(const Piece& piece) const;
  double away_from_tool(const Piece& next, Point v) const;
  Point last_direction(const Piece& next) const;
};

/// Record what waits as it is.
Result OwnNormal::let_go() const {
  lookahead().begun_known = false;
  for (const Piece& piece : lookahead().radius)
    if (auto wrong = record(piece, {piece.beside[0], piece.beside[1]})) return wrong;
  lookahead().radius.clear();
  return std::nullopt;
}

/// Note that the tool stands at `at` when the next move begins; return `wrong`.
Result OwnNormal::stands_at(Result wrong, Point at) const {
  lookahead().begun = {at.a, at.b};
  lookahead().begun_known = true;
  return wrong;
}

/// End what waits at `to` instead, but not backwards.
Result OwnNormal::move_back(Point to, std::uint32_t at) const {
  LookaheadQueue& h = lookahead();
  if (h.radius.empty()) return std::nullopt;
  const Point begun{h.begun[0], h.begun[1]};
  const double unit = sink.state.unit;
  for (Piece& piece : h.radius) {
    if (piece.kind == MoveKind::Dwell) continue;
    const Point end = view.point(piece.end);
    if (is_arc(piece)) {
      const Point centre = view.point(piece.centre);
      const double before = size(end + Point{piece.beside[0], piece.beside[1]} - centre);
      if (std::fabs(before - size(to - centre)) > kMismatch * unit) return no_corner(piece, piece);
      const double slack = unit == 1 ? kSlack : kSlack / kInch;
      const double turn = turn_of(piece, begun, centre, to);
      if (h.begun_known && std::fabs(turn) > std::fabs(piece.turn) + slack)
        return cut_short(piece, at);
    } else if (h.begun_known && dot({piece.way[0], piece.way[1]}, to - begun) < 0) {
      return cut_short(piece, at);
    }
    piece.beside = {(to - end).a, (to - end).b};
  }
  return stands_at(let_go(), to);
}

/// Go around the corner in an arc; a rapid goes straight.
Result OwnNormal::go_around(const Piece& next, Point to) const {
  Piece bit = next;
  const Axes& from = lookahead().radius_to;
  view.set(bit.end, corner());
  bit.end[static_cast<std::size_t>(view.axes.across)] =
      from[static_cast<std::size_t>(view.axes.across)];
  bit.corner_piece = true;
  if (next.kind != MoveKind::Rapid) {
    bit.turn = offset_of(next) > 0 ? -kPi : kPi;
    bit.kind = bit.turn > 0 ? MoveKind::Ccw : MoveKind::Cw;
    view.set(bit.centre, corner());
  }
  return stands_at(record(bit, to - corner()), to);
}

void OwnNormal::wait(const Piece& piece, Point to, Point way) const {
  LookaheadQueue& h = lookahead();
  const Point beside = to - view.point(piece.end);
  h.radius_to = piece.end;
  h.vector = {beside.a, beside.b};
  h.engaged = true;
  h.radius.push_back(piece);
  h.radius.back().beside = h.vector;
  h.radius.back().way = {way.a, way.b};
}

/// Begin with the first move: from where the tool is, to beside the end.
Result OwnNormal::begin(Piece piece, Point start) const {
  const double offset = offset_of(piece), radius = std::fabs(offset);
  const Point end = view.point(piece.end);
  Fault too_short = fault_at({.groups = bit(Group::Radius)}, Cause::CompensationEntry, piece.at);
  too_short.name = is_arc(piece) ? "Radius of cutter compensation entry arc"
                                 : "Length of cutter compensation entry move";
  if (size(end - start) <= radius) return too_short;
  if (!is_arc(piece)) {
    const Point to = end + offset * left((1 / size(end - start)) * (end - start));
    (void)stands_at(std::nullopt, start);
    wait(piece, to, to - end);
    return std::nullopt;
  }
  const Point centre = view.point(piece.centre);
  if (goes_inside(piece) && size(start - centre) <= radius) return arc_too_small(piece.at);
  // The arc's end moves, and its centre on the line between them, until both ends are on it.
  const double inwards = direction(centre - end);
  const Point to = end + radius * unit_of(goes_inside(piece) ? inwards : inwards + kPi);
  const Point towards = unit_of(direction(centre - to));
  const double cosine = dot(start - to, towards) / size(start - to);
  if (std::fabs(cosine) < 1e-4) return arc_too_small(piece.at);
  const Point moved = to + (size(start - to) / 2 / cosine) * towards;
  piece.turn = turn_of(piece, start, moved, to);
  view.set(piece.centre, moved);
  wait(piece, to, {});
  return std::nullopt;
}

/// Return the direction in which the move before ends: the tool stands square to it.
Point OwnNormal::last_direction(const Piece& next) const {
  return unit_of(direction(tool() - corner()) - quarter(offset_of(next) > 0));
}

/// Return how far a direction turns away from the tool's side, from a quarter turn towards it on.
double OwnNormal::away_from_tool(const Piece& next, Point v) const {
  const Point u = last_direction(next);
  const double turn = direction(u) - direction(v);
  const double away = std::remainder(offset_of(next) > 0 ? turn : -turn, 2 * kPi);
  return away < -kPi / 2 ? away + 2 * kPi : away;
}

/// End the waiting move where a line along `v` begins, after an inside corner.
Result OwnNormal::end_before_line(const Piece& piece, Point v, double away) const {
  const Piece& before = lookahead().radius.front();
  const double radius = std::fabs(offset_of(piece));
  if (!is_arc(before)) {
    const Point back = -radius / std::tan((away + kPi) / 2) * last_direction(piece);
    return move_back(tool() + back, piece.at);
  }
  const Point centre = view.point(before.centre);
  const double own =
      size(view.point(before.end) + Point{before.beside[0], before.beside[1]} - centre);
  const double towards = direction(v) + quarter(before.turn > 0);
  const bool inside = goes_inside(before);
  const double contour = inside ? own + radius : own - radius;
  const double far = contour * std::cos(towards - direction(centre - corner()));
  const double share = (inside ? far - radius : far + radius) / own;
  if (share > 1 || share < -1) return no_corner(before, piece);
  const double half = inside == (before.turn > 0) ? -std::acos(share) : std::acos(share);
  return move_back(centre + own * unit_of(towards + kPi + half), piece.at);
}

Result OwnNormal::line(Piece piece) const {
  const Point start = corner(), end = view.point(piece.end);
  if (size(end - start) < kStanding) {  // nothing in the plane
    wait(piece, tool(), {});
    return std::nullopt;
  }
  const Point v = (1 / size(end - start)) * (end - start);
  const Point beside = offset_of(piece) * left(v);
  const double away = away_from_tool(piece, v);
  const auto& queue = lookahead().radius;
  const bool over_arc = away > kPi - kCorner && !queue.empty() && is_arc(queue.front()) &&
                        !goes_inside(queue.front());
  const bool inside = away < -kCorner || away > kPi + kCorner || over_arc;
  if (inside) {
    if (!queue.empty())
      if (auto wrong = end_before_line(piece, v, away)) return wrong;
  } else if (away > kCorner) {
    if (auto wrong = move_back(tool(), piece.at)) return wrong;
    if (auto wrong = go_around(piece, start + beside)) return wrong;
  } else if (auto wrong = stands_at(let_go(), tool())) {
    return wrong;
  }
  wait(piece, end + beside, end - start);
  return std::nullopt;
}

Result OwnNormal::end_line_before_arc(const Piece& piece, Point u, double away) const {
  const Point centre = view.point(piece.centre);
  const double radius = std::fabs(offset_of(piece));
  const double own = size(centre - view.point(piece.end)), across = -own * std::cos(away);
  const bool inside = goes_inside(piece), left_turn = piece.turn > 0;
  const double moved = inside ? own - radius : own + radius;
  const double share = (inside ? across + radius : across - radius) / moved;
  if (share > 1 || share < -1) return cut_short(piece, piece.at);
  const double half = std::asin(share);
  const double angle = inside ? (left_turn ? half : -half) : kPi + (left_turn ? -half : half);
  return move_back(centre + moved * unit_of(direction(u) + angle), piece.at);
}

Result OwnNormal::end_arc_before_arc(const Piece& piece) const {
  const Piece& before = lookahead().radius.front();
  const Point first = view.point(before.centre), second = view.point(piece.centre);
  const double radius = std::fabs(offset_of(piece));
  const double old =
      size(view.point(before.end) + Point{before.beside[0], before.beside[1]} - first);
  const double own = size(second - view.point(piece.end));
  const double moved = goes_inside(piece) ? own - radius : own + radius;
  const double apart = size(second - first);
  if (old == 0 || apart == 0) return no_corner(before, piece);
  const double share = (old * old + apart * apart - moved * moved) / (2 * old * apart);
  if (share > 1 || share < -1) return no_corner(before, piece);
  const bool plus = goes_inside(before) == (piece.turn > 0);
  const double angle = direction(second - first) + (plus ? std::acos(share) : -std::acos(share));
  return move_back(first + old * unit_of(angle), piece.at);
}

Result OwnNormal::end_before_arc(const Piece& piece, Point u, double away) const {
  if (lookahead().radius.empty()) return std::nullopt;
  return is_arc(lookahead().radius.front()) ? end_arc_before_arc(piece)
                                            : end_line_before_arc(piece, u, away);
}

Result OwnNormal::arc(Piece piece) const {
  const Point start = corner(), end = view.point(piece.end), centre = view.point(piece.centre);
  const double radius = std::fabs(offset_of(piece));
  const bool inside = goes_inside(piece);
  if (inside && size(centre - end) <= radius) return arc_too_small(piece.at);
  const double inwards = direction(centre - start);
  const Point v = unit_of(inwards - quarter(piece.turn > 0));
  const double away = away_from_tool(piece, v);
  const double out = inside ? 0 : kPi;
  if (away < -kCorner || away > kPi + kCorner || (std::fabs(away - kPi) < kCorner && !inside)) {
    if (auto wrong = end_before_arc(piece, last_direction(piece), away)) return wrong;
  } else if (away > kCorner) {
    if (auto wrong = let_go()) return wrong;
    if (auto wrong = go_around(piece, start + radius * unit_of(inwards + out))) return wrong;
  } else if (auto wrong = stands_at(let_go(), tool())) {
    return wrong;
  }
  wait(piece, end + radius * unit_of(direction(centre - end) + out), {});
  return std::nullopt;
}

/// Record a dwell after G40: the tool waits where it is, until a move leads it to the path.
Result wait_beside(MoveSink& sink, const Piece& piece) {
  const Axes way = sink.state.tool_at - (piece.end + piece.length);
  return record_move(
      sink, piece,
      sink.state.lookahead.engaged ? std::array{way[0], way[1], way[2]} : std::array<double, 3>{});
}

}  // namespace

Result end_own_normal(MoveSink& sink) {
  LookaheadQueue& lookahead = sink.state.lookahead;
  if (lookahead.radius.empty()) return std::nullopt;
  OwnNormal path(sink, lookahead.radius.front().plane);
  if (auto wrong = path.move_back(path.tool(), lookahead.radius.back().at)) return wrong;
  lookahead.begun_known = false;
  return std::nullopt;
}

Result by_own_normal(MoveSink& sink, const Piece& piece, const Axes& from) {
  LookaheadQueue& lookahead = sink.state.lookahead;
  if (piece.side == 0 || piece.radius == 0) {
    if (auto wrong = end_own_normal(sink)) return wrong;
    if (lookahead.engaged && is_arc(piece))
      return Fault{Cause::CompensationEndArc, piece.at, 1, {}};
    if (piece.kind == MoveKind::Dwell) return wait_beside(sink, piece);
    lookahead.engaged = lookahead.ended = false;
    return record_move(sink, piece, {});
  }
  OwnNormal path(sink, piece.plane);
  const bool first = !lookahead.engaged || lookahead.ended;
  if (piece.kind == MoveKind::Dwell) {
    if (first) return record_move(sink, piece, {});
    if (lookahead.radius.empty())
      return path.record(piece, {lookahead.vector[0], lookahead.vector[1]});
    lookahead.radius.push_back(piece);
    lookahead.radius.back().beside = lookahead.vector;
    return std::nullopt;
  }
  lookahead.ended = false;
  if (first) return path.begin(piece, path.view.point(from));
  return is_arc(piece) ? path.arc(piece) : path.line(piece);
}

}  // namespace cncsub
