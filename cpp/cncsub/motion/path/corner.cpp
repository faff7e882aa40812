// Chamfers and corner rounds between two moves: the first waits for the second.
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/geometry.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

/// Read `G01 Z_ I_` and `G01 X_ K_`, the older form between moves at right angles.
/// [general knowledge]
Result right_angle_chamfer(MotionView m, const BlockWords& block, Piece& piece) {
  const NcWords& w = block.words;
  const bool written = w.has('I') || w.has('K');
  if (!m.facts.control->turning.chamfer_ik.value || !m.facts.lathe() || !written ||
      piece.kind != MoveKind::Feed || piece.turn != 0)
    return std::nullopt;
  const Axes end = piece.end - piece.offset;
  const auto goes = [&](std::size_t axis) {
    return std::fabs(end[axis] - m.state.work[axis]) > least_length(m) / 2;
  };
  if (goes(0) && goes(2))
    return fault_at({.addresses = bit('I') | bit('K')}, Cause::CornerTaper, block);
  if (w.has('I') && w.has('K')) return fault_at('K', Cause::CornerFormat, block);
  piece.corner_size = std::fabs(number(m, block, w.has('I') ? 'I' : 'K'));
  if (piece.corner_size > 0) piece.corner = 'C';
  return std::nullopt;
}

/// Refuse a corner where none may be.
Result check_corner(MotionView m, const BlockWords& block, const Piece& piece) {
  if (polar(m.state) && m.facts.refuses(Cause::PolarCorner))
    return fault_at(m.facts.corner_name(piece), Cause::PolarCorner, block);
  if (block.has(Group::Radius) && m.facts.refuses(Cause::CornerOffset))
    return fault_at(m.facts.corner_name(piece), Cause::CornerOffset, block);
  return std::nullopt;
}

}  // namespace

bool may_have_corner(MotionView m, const BlockWords& block) {
  return (block.words.mask & m.facts.corner_words()) != 0;
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one case after the other
Result corner_words(MotionView m, const BlockWords& block, Piece& piece) {
  const int chamfer = m.facts.chamfers.find(block.words.mask);
  int round = m.facts.rounds.find(block.words.mask);
  const bool arc = piece.kind == MoveKind::Cw || piece.kind == MoveKind::Ccw;
  if (arc && round == 'R' - 'A') round = -1;
  if (chamfer < 0 && round < 0) return right_angle_chamfer(m, block, piece);
  const bool comma = chamfer >= kCommaC || round >= kCommaC;
  if (piece.kind == MoveKind::Rapid || piece.kind == MoveKind::Thread)
    return comma ? Result(fault_at(m.facts.corner_name(piece), Cause::CornerInRapid, block))
                 : std::nullopt;
  if (auto wrong = check_corner(m, block, piece)) return wrong;
  if (chamfer >= 0 && round >= 0)
    return fault_at({.addresses = 1u << round}, Cause::CornerFormat, block);
  piece.corner_size = length_at(m, block.words, chamfer >= 0 ? chamfer : round);
  if (piece.corner_size < 0 && m.facts.refuses(Cause::ValueOutOfRange))
    return fault_at(m.facts.corner_name(piece), Cause::ValueOutOfRange, block,
                    "a chamfer or a rounding is not below zero");
  if (m.state.frame.turned)
    piece.corner_size *= std::fabs(factor_in_plane(m.state.frame, plane_axes(piece.plane)));
  if (piece.corner_size != 0) piece.corner = chamfer == kCommaD ? 'L' : chamfer >= 0 ? 'C' : 'R';
  return std::nullopt;
}

Result unfinished_move(MotionView m) {
  if (const auto& corner = m.state.lookahead.corner; !corner.empty())
    return fault_at(m.facts.corner_name(corner.back()), Cause::CornerNoMove, corner.back().at);
  if (const PendingAngle& angle = m.state.pending_angle; angle.waiting())
    return fault_at({.addresses = m.facts.angles.mask}, Cause::AngleNoEnd, angle.line.front().at);
  return std::nullopt;
}

namespace {

/// Let a move before a corner wait for the one after it.
Result wait_for_corner(MoveSink& sink, const Piece& piece, const Axes& from) {
  if (piece.corner == 0) return through_radius(sink, piece, from);
  sink.state.lookahead.corner_from = from;
  sink.state.lookahead.corner.push_back(piece);
  return std::nullopt;
}

/// Cut the corner between the move that waited and this one.
Result end_corner(MoveSink& sink, const Piece& piece) {
  LookaheadQueue& lookahead = sink.state.lookahead;
  Piece first = lookahead.corner.back();
  const bool by_length = first.corner == 'L';  // its number is the length of the chamfer
  if (by_length) first.corner = 'C';
  lookahead.corner.clear();
  if (piece.kind != MoveKind::Feed && piece.kind != MoveKind::Cw && piece.kind != MoveKind::Ccw)
    return fault_at({}, Cause::CornerNextMove, piece.at);
  CornerPieces corner;
  const PlaneView view{plane_axes(first.plane), sink.facts.share(0)};
  const bool stands = piece.kind == MoveKind::Feed &&
                      size(view.point(piece.end) - view.point(first.end)) < kStanding;
  if (stands && sink.facts.control->motion.corner_idle_blocks.value > 0)
    return fault_at({.addresses = kAxisWords}, Cause::CodeNotComputed, piece.at,
                    "cncsub computes no corner between whose sides a move goes across the plane");
  const bool chamfer_side =
      by_length || sink.facts.control->turning.chamfer_length.value == ChamferLength::Line;
  if (!cut_corner(view, lookahead.corner_from, first, piece, chamfer_side, corner))
    return corner.second_short && sink.facts.refuses(Cause::CornerNextShort)
               ? fault_at({.addresses = kAxisWords}, Cause::CornerNextShort, piece.at)
               : fault_at(sink.facts.corner_name(first), Cause::CornerTooShort, first.at);
  if (auto wrong = through_radius(sink, corner.first, lookahead.corner_from)) return wrong;
  if (corner.has_between)
    if (auto wrong = through_radius(sink, corner.between, corner.at_first)) return wrong;
  return wait_for_corner(sink, corner.second, corner.at_second);
}

}  // namespace

Result through_corner(MoveSink& sink, const Piece& piece, const Axes& from) {
  return sink.state.lookahead.corner.empty() ? wait_for_corner(sink, piece, from)
                                             : end_corner(sink, piece);
}

}  // namespace cncsub
