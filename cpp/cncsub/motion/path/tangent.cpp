// Arcs that go on in the direction of the move before them.
#include <cmath>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/geometry.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {

Result tangent_arc(MotionContext& m, BlockWords& block) {
  const PlaneAxes plane = plane_axes(m.state.plane);
  const auto [end, named] = end_point(m, block);
  if (named == 0) return std::nullopt;
  if (auto wrong = need_feed(m, block, Meaning::Cw)) return wrong;
  Point way{m.state.heading[static_cast<std::size_t>(plane.a)],
            m.state.heading[static_cast<std::size_t>(plane.b)]};
  turn_vector(m.state, way.a, way.b, plane);
  if (size(way) < kStanding) return fault(Cause::NoTangent, block);
  Piece piece = make_piece(m, block, MoveKind::Cw, end, named);
  if (auto wrong = corner_words(m, block, piece)) return wrong;
  const PlaneView view{plane, m.facts.share(0)};
  const Point from = view.point(m.state.work + piece.offset), chord = view.point(piece.end) - from;
  const Point across{-way.b / size(way), way.a / size(way)};
  const double aside = dot(chord, across);
  if (std::fabs(aside) < kStanding) {  // straight on, which no turn may follow [SONE p.203]
    if (dot(chord, way) < 0)
      return fault(Cause::NoTangent, block, "its end lies straight behind the tool");
    for (const char name : m.facts.control->motion.added_turns.value)
      if (block.words[name] != 0) return fault_at(name, Cause::ValueOutOfRange, block);
    piece.kind = MoveKind::Feed;
    return move(m, block, piece);
  }
  const double radius = dot(chord, chord) / (2 * aside);
  const Point centre = from + radius * across;
  view.set(piece.centre, centre);
  piece.kind = aside > 0 ? MoveKind::Ccw : MoveKind::Cw;
  const Point first = from - centre, last = from + chord - centre;
  piece.turn = turn_between(std::atan2(first.b, first.a), std::atan2(last.b, last.a), aside < 0);
  if (auto wrong = add_turns(m, block, piece)) return wrong;
  return move(m, block, piece);
}

}  // namespace cncsub
