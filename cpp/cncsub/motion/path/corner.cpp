// Chamfers and corner rounds between two moves: the first waits for the second.
#include <algorithm>
#include <cmath>
#include <utility>

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

namespace {

/// Return the first letter of a rule that a block has as a word, 0 where it has none.
char word_of(const Letters& letters, const BlockWords& block) {
  const auto* const found = std::find_if(letters.begin(), letters.end(),
                                         [&](char letter) { return block.words.has(letter); });
  return found == letters.end() ? '\0' : *found;
}

/// Read a feed of corners.
Result corner_feed_of(MotionView m, const BlockWords& block, char letter, bool may_be_zero,
                      double& feed) {
  const double value = block.words[letter];
  if (value < 0 || (value == 0 && !may_be_zero))
    return fault_at(letter, Cause::ValueOutOfRange, block, "a feed of corners is above zero");
  feed = value * m.state.feed_unit;
  return std::nullopt;
}

}  // namespace

Result set_corner_modes(MotionContext& m, const BlockWords& block) {
  const MotionRules& rules = m.facts.control->motion;
  if (const char round = word_of(rules.modal_round_words.value, block)) {
    if (block.words[round] < 0)
      return fault_at(round, Cause::ValueOutOfRange, block, "a rounding is not below zero");
    m.state.modal_round = number(m, block, round);
  }
  if (const char feed = word_of(rules.modal_corner_feed_words.value, block))
    return corner_feed_of(m, block, feed, true, m.state.corner_feed);
  return std::nullopt;
}

bool may_have_corner(MotionView m, const BlockWords& block) {
  return (block.words.mask & m.facts.corner_words()) != 0 || m.state.modal_round > 0;
}

namespace {

/// Return whether the next corner round of all moves follows a piece: it moves in the plane.
bool ends_at_corner(MotionView m, const Piece& piece) {
  if (piece.kind == MoveKind::Thread || piece.kind == MoveKind::Dwell) return false;
  const PlaneAxes plane = plane_axes(piece.plane);
  const Axes way = piece.end - piece.offset - m.state.work;
  const bool arc = piece.kind == MoveKind::Cw || piece.kind == MoveKind::Ccw;
  return arc || std::hypot(way[static_cast<std::size_t>(plane.a)],
                           way[static_cast<std::size_t>(plane.b)]) >= kStanding;
}

/// Let the corner round of all moves follow a piece.
void take_modal_round(MotionView m, Piece& piece) {
  if (!ends_at_corner(m, piece)) return;
  piece.modal_corner = true;
  piece.corner = 'R';
  piece.corner_size = m.state.modal_round;
  if (m.state.frame.turned)
    piece.corner_size *= std::fabs(factor_in_plane(m.state.frame, plane_axes(piece.plane)));
}

}  // namespace

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one case after the other
Result corner_words(MotionView m, const BlockWords& block, Piece& piece) {
  int chamfer = m.facts.chamfers.find(block.words.mask);
  int round = m.facts.rounds.find(block.words.mask);
  const bool arc = piece.kind == MoveKind::Cw || piece.kind == MoveKind::Ccw;
  if (arc && round == 'R' - 'A') round = -1;
  piece.corner_feed = m.state.corner_feed;
  if (const char feed = word_of(m.facts.control->motion.corner_feed_words.value, block))
    if (auto wrong = corner_feed_of(m, block, feed, false, piece.corner_feed)) return wrong;
  if (chamfer < 0 && round < 0 && m.state.modal_round > 0)
    return take_modal_round(m, piece), std::nullopt;
  if (chamfer < 0 && round < 0) return right_angle_chamfer(m, block, piece);
  const bool comma = chamfer >= kCommaC || round >= kCommaC;
  const bool rapid =
      piece.kind == MoveKind::Rapid && !m.facts.control->motion.corners_in_rapid.value;
  if (rapid || piece.kind == MoveKind::Thread)
    return comma ? Result(fault_at(m.facts.corner_name(piece), Cause::CornerInRapid, block))
                 : std::nullopt;
  if (auto wrong = check_corner(m, block, piece)) return wrong;
  if (chamfer >= 0 && round >= 0) {
    if (!m.facts.control->motion.round_before_chamfer.value)
      return fault_at({.addresses = 1u << round}, Cause::CornerFormat, block);
    chamfer = -1;
  }
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
  const auto& corner = m.state.lookahead.corner;
  if (!corner.empty() && corner.back().modal_corner)
    return fault_at({}, Cause::CodeNotComputed, corner.back().at,
                    "cncsub does not compute a stop at a corner that is rounded as all are");
  if (!corner.empty())
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

/// Return whether a piece may be a side of a corner.
bool may_be_side(const Piece& piece) {
  return piece.kind == MoveKind::Feed || piece.kind == MoveKind::Cw || piece.kind == MoveKind::Ccw;
}

/// Check the sides of a corner that is rounded as all are. What no source tells of is not computed.
Result check_modal_sides(const Piece& first, const Piece& second, bool stands, bool ended) {
  const auto refuse = [&](const char* why) -> Result {
    return fault_at(
        {}, Cause::CodeNotComputed, second.at,
        std::string("cncsub does not compute ") + why + ": end it in the block of the last side");
  };
  if (!may_be_side(first) || !may_be_side(second))
    return refuse("the rounding of all corners beside a move that is no line or arc at the feed");
  if (stands) return refuse("the rounding of all corners before a move across the plane");
  if (ended) return refuse("the end of the rounding of all corners between two sides");
  return std::nullopt;
}

/// Check the sides of a corner. Between two rapid moves a chamfer is one too; a rounding at rapid
/// and a corner from a rapid move to one at the feed are not computed.
Result check_sides(MotionView m, const Piece& first, const Piece& second) {
  const bool rapid = first.kind == MoveKind::Rapid || second.kind == MoveKind::Rapid;
  if (!rapid || !m.facts.control->motion.corners_in_rapid.value)
    return may_be_side(second) ? Result() : fault_at({}, Cause::CornerNextMove, second.at);
  const bool both = first.kind == second.kind;
  if (both && first.corner == 'C') return std::nullopt;
  return fault_at(m.facts.corner_name(first), Cause::CodeNotComputed, first.at,
                  both ? "cncsub does not compute a rounding between rapid moves"
                       : "cncsub does not compute a corner between a rapid move and one at the "
                         "feed");
}

/// Return the fault of sides that are too short for their corner.
Result too_short(MotionView m, const Piece& first, const Piece& second, bool second_short) {
  if (m.facts.control->motion.corner_reduced.value)
    return fault_at(m.facts.corner_name(first), Cause::CodeNotComputed, first.at,
                    "the control makes a chamfer or a rounding smaller that has no room, and "
                    "cncsub does not compute by how much");
  return second_short && m.facts.refuses(Cause::CornerNextShort)
             ? fault_at({.addresses = kAxisWords}, Cause::CornerNextShort, second.at)
             : fault_at(m.facts.corner_name(first), Cause::CornerTooShort, first.at);
}

/// Give what is put in at a corner its feed.
void set_corner_feed(MotionView m, const Piece& first, const Piece& second, Piece& between) {
  if (first.kind == MoveKind::Rapid) {
    between.kind = MoveKind::Rapid;
    return;
  }
  if (first.corner_feed > 0)
    between.state.feed = first.corner_feed;
  else if (m.facts.control->motion.corner_feed_of_next.value)
    between.state = second.state;
}

/// Cut the corner between the move that waited and this one.
Result end_corner(MoveSink& sink, const Piece& piece) {
  LookaheadQueue& lookahead = sink.state.lookahead;
  const bool ended = std::exchange(lookahead.round_ended, false);
  Piece first = lookahead.corner.back();
  if (first.modal_corner && ended && !may_be_side(piece)) {
    if (auto wrong = leave_corner(sink)) return wrong;
    return wait_for_corner(sink, piece, first.end);
  }
  const bool by_length = first.corner == 'L';  // its number is the length of the chamfer
  if (by_length) first.corner = 'C';
  lookahead.corner.clear();
  CornerPieces corner;
  const PlaneView view{plane_axes(first.plane), sink.facts.share(0)};
  const bool stands = (piece.kind == MoveKind::Feed || piece.kind == MoveKind::Rapid) &&
                      size(view.point(piece.end) - view.point(first.end)) < kStanding;
  if (first.modal_corner)
    if (auto wrong = check_modal_sides(first, piece, stands, ended)) return wrong;
  if (auto wrong = check_sides(sink, first, piece)) return wrong;
  if (stands && sink.facts.control->motion.corner_idle_blocks.value > 0)
    return fault_at({.addresses = kAxisWords}, Cause::CodeNotComputed, piece.at,
                    "cncsub computes no corner between whose sides a move goes across the plane");
  const bool chamfer_side =
      by_length || sink.facts.control->turning.chamfer_length.value == ChamferLength::Line;
  if (!cut_corner(view, lookahead.corner_from, first, piece, chamfer_side, corner))
    return too_short(sink, first, piece, corner.second_short);
  if (corner.has_between) set_corner_feed(sink, first, piece, corner.between);
  if (auto wrong = through_radius(sink, corner.first, lookahead.corner_from)) return wrong;
  if (corner.has_between)
    if (auto wrong = through_radius(sink, corner.between, corner.at_first)) return wrong;
  return wait_for_corner(sink, corner.second, corner.at_second);
}

}  // namespace

Result leave_corner(MoveSink& sink) {
  LookaheadQueue& lookahead = sink.state.lookahead;
  if (lookahead.corner.empty() || !lookahead.corner.back().modal_corner) return std::nullopt;
  Piece piece = lookahead.corner.back();
  piece.corner = 0;
  lookahead.corner.clear();
  return through_radius(sink, piece, lookahead.corner_from);
}

Result through_corner(MoveSink& sink, const Piece& piece, const Axes& from) {
  return sink.state.lookahead.corner.empty() ? wait_for_corner(sink, piece, from)
                                             : end_corner(sink, piece);
}

}  // namespace cncsub
