// Radius compensation of the moves at one corner.
#pragma once

#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/geometry.hpp"
#include "cncsub/motion/path/path.hpp"

namespace cncsub {

/// Return the fault of an arc that is smaller than the tool: its radius or its centre is wrong.
inline Fault arc_too_small(Address block) {
  return fault_at({.addresses = bit('R') | kCentreWords}, Cause::CompensationArcTooSmall, block);
}

/// Return the offset of a piece, plus to the left, minus to the right. A negative radius swaps the
/// sides.
inline double offset_of(const Piece& piece) {
  return piece.side < 0 ? piece.radius : -piece.radius;
}

inline bool is_arc(const Piece& piece) { return piece.turn != 0; }

inline void straighten(Piece& piece) {
  piece.turn = 0;
  if (piece.kind != MoveKind::Rapid) piece.kind = MoveKind::Feed;
}

/// The join of two moves with their offsets.
struct Join {
  Point leave;                 // where the tool leaves the first move, from the corner
  std::array<Point, 3> way{};  // points in between, from the corner
  std::size_t points = 0;      // how many of them are set
  double turn = 0;             // of the arc around the corner that leads to the only point
  enum Step { None, First, Second } over = None;  // the move that is a step the tool goes over
  Point along;                                    // its direction where it touches the step

  void go_by(Point point) { way[points++] = point; }
};

/// The geometry of the moves at one corner, in the plane of the moves. Two points are one where the
/// least increment cannot tell them apart: a program rounds its points and centres to it, so that
/// what is tangent, or fits, on the drawing does so only within some increments.
struct RadiusPath {
  /// The factor on an increment in comparisons. Words lie whole increments apart, and so do the
  /// lengths compared with them: what is one increment long must stay within it, whichever way its
  /// numbers are rounded.
  static constexpr double kRoomy = 1 + 1e-5;

  MoveSink& sink;
  PlaneView view;
  double least = kRoomy * least_length(sink);

  RadiusPath(MoveSink& s, Plane plane) : sink(s), view{plane_axes(plane), s.facts.share(0)} {}

  /// Return whether two points are one. A step of one increment has no direction yet.
  bool same(Point p, Point q) const { return size(p - q) < 1.5 * least; }
  bool same_normal(Point p, Point q) const { return size(p - q) <= least / 2; }

  Result record(const Piece& piece, Point v) {
    std::array<double, 3> vector{piece.tip[0] + 0.0, piece.tip[1] + 0.0, piece.tip[2] + 0.0};
    vector[static_cast<std::size_t>(view.axes.a)] += v.a / view.a_share;
    vector[static_cast<std::size_t>(view.axes.b)] += v.b / view.b_share;
    if (auto wrong = record_move(sink, piece, vector)) return wrong;
    sink.state.lookahead.vector = {v.a, v.b};
    return std::nullopt;
  }

  /// Record a bit of path around a corner, as a move of the piece it belongs to.
  Result record_bit(Piece piece, const Axes& at, Point v, double turn) {
    piece.end = at;
    piece.corner_piece = true;
    straighten(piece);
    if (turn != 0) {
      piece.turn = turn;
      piece.kind = turn > 0 ? MoveKind::Ccw : MoveKind::Cw;
      view.set(piece.centre, view.point(at));
    }
    return record(piece, v);
  }

  /// Record a move without a path in the plane: the tool stays beside the contour.
  Result record_idle(Piece piece, Point v) {
    if (is_arc(piece)) straighten(piece);
    return record(piece, v);
  }

  /// Return whether the second of two directions turns to the tool's side. Where the path goes back
  /// along itself, the tool goes around.
  bool inside(Point u, Point v, double offset) const {
    return cross(u, v) * offset > 0 && !same_normal(offset * u, -offset * v);
  }
  void find_start(Axes& from) const;
  bool moves_in_plane(const Piece& piece, const Axes& from) const;
  /// `behind` is the move after the two at the corner, null where it is not known.
  Result join(const Curve& a, const Curve& b, const Curve* behind, double offset, std::uint32_t at,
              Join& join) const;
  Fault no_meeting(const Curve& a, const Curve& b, double offset, std::uint32_t at) const;
  void go_around(const Curve& a, const Curve& b, Point u, Point v, double offset, Join& join) const;
  Result check_direction(const Curve& curve, Piece& piece, Point& v, Point next) const;
  Result record_waiting(const Curve& curve, Point& v, const Join* join, Point next);
  Result leave(const Curve& curve, Point v, const Join* join, Point next);
  Result flush();
  Result cancel(const Piece& piece, const Curve& curve);
  /// `over` becomes true where the piece is a step that the tool goes over, in a line that begins
  /// at `from`.
  Result follow(const Piece& piece, const Curve& curve, const Curve* behind, Axes& from,
                bool& over);
  /// Find how the tool comes from the waiting move, which is the curve `before`, to this one.
  Result find_join(double side, std::uint32_t at, const Curve& before, const Curve& curve,
                   const Curve* behind, Join& way) const;

  // step.cpp: low steps.
  bool is_low_step(double side, const Curve& curve) const;
  Result take_step(const Curve* next);
  bool join_before_step(const Curve& a, const Curve& b, const Curve& behind, double offset,
                        Join& join) const;
  bool join_over_step(const Curve& a, const Curve& b, double offset, Join& join) const;
  void begin_step(const Piece& piece, Axes& from, Point along);
};

}  // namespace cncsub
