// The path between two points: arcs, lines by their angle, corners, radius compensation.
#pragma once

#include <algorithm>
#include <cmath>

#include "cncsub/motion/state/modes.hpp"

namespace cncsub {

/// Return the least increment as a length: the words of a contour are rounded to it.
inline double least_length(MotionView m) {
  return m.facts.increment * (g20(m.state) ? kInch / 10 : 1);
}

/// Execute G02 and G03.
Result arc(MotionContext& m, BlockWords& block, Meaning meaning);
/// Add the full turns that an arc makes besides.
Result add_turns(MotionView m, const BlockWords& block, Piece& piece);
/// Execute an arc that goes on in the direction of the move before it.
Result tangent_arc(MotionContext& m, BlockWords& block);
/// Find the centre of an arc whose piece has all else, and the angle it runs through.
Result shape_arc(MotionView m, const BlockWords& block, Piece& piece, MotionOutcome& outcome);
/// Return whether an arc that begins and ends at these distances from its centre, mm, is refused.
inline bool is_off_circle(const MotionRules& rules, double first, double last, bool inches) {
  constexpr double kDiagonals = 2.8284271247461903;  // of a start or end, and of a centre
  const double rounding = rules.arc_rounding.value * (inches ? kInch / 10 : 1) * kDiagonals;
  const double allowed = rules.arc_rounding.value > 0 ? rounding : rules.arc_tolerance.value;
  const double tolerance = allowed * 1e-3 + 1e-9;
  const double miss = std::fabs(first - last);
  if (allowed == 0 || miss <= tolerance) return false;
  return miss > tolerance * 100 ||
         miss >= rules.arc_tolerance_share.value * 1e-3 * std::max(first, last);
}
/// The length in mm that an arc with R may lack where its words may be rounded. [rs274 2.9]
constexpr double kRadiusSlack = 5e-5 * kInch;
/// Return whether an arc has no radius at one of its ends.
inline bool has_no_radius(const MotionRules& rules, double first, double last) {
  return first == 0 ||
         (rules.arc_rounding.value > 0 && (first < kRadiusSlack || last < kRadiusSlack));
}
/// Execute G05 and G05.1: a curve to a point, by the directions at its ends or by where they meet.
Result spline(MotionContext& m, BlockWords& block);
/// Return whether a negative R goes the long way around.
inline bool takes_negative_radius(const MotionFacts& facts) {
  const NegativeRadius taken = facts.control->motion.negative_radius.value;
  return taken == NegativeRadius::LongWay || (taken == NegativeRadius::MillsOnly && !facts.lathe());
}
/// Execute an arc through a third point: I and K lead to it from the start, or name it. [TDi 5]
Result arc_by_points(MotionContext& m, BlockWords& block, Meaning meaning);

/// Read the angle of a straight move with the first axis of the plane, counter-clockwise, in
/// degrees.
bool angle_word(MotionView m, const BlockWords& block, double& angle);
Result pending_angle(MotionContext& m, BlockWords& block, Meaning meaning, double angle);
/// Check that after a straight move of which only the angle is known comes the one that tells its
/// end. One block without a move may stand between. [TDi 13 notes 6, 7]
Result check_angle(MotionContext& m, const BlockWords& block, bool waited);

/// Take over the words that say how the corners of this move and all after it are rounded.
Result set_corner_modes(MotionContext& m, const BlockWords& block);
/// Let a move that waits at a corner which is rounded as all are end where it is written: no other
/// side follows it.
Result leave_corner(MoveSink& sink);
/// Return whether the words of a block may say a chamfer or a corner round, and read what they say.
bool may_have_corner(MotionView m, const BlockWords& block);
Result corner_words(MotionView m, const BlockWords& block, Piece& piece);
/// Return the fault of a move that waits for a next one, where none comes: before its corner, or
/// because only its angle is known.
Result unfinished_move(MotionView m);
/// Pass a piece on to the table: through a corner, which waits for the next piece, and through
/// radius compensation, which does too.
Result through_corner(MoveSink& sink, const Piece& piece, const Axes& from);
Result through_radius(MoveSink& sink, const Piece& piece, const Axes& from);
Result flush_radius(MoveSink& sink);
/// Do the same where moves end on their own normals, and end their waiting.
Result by_own_normal(MoveSink& sink, const Piece& piece, const Axes& from);
Result end_own_normal(MoveSink& sink);
/// Count the blocks in a row without a move in the plane. After more of them than the control looks
/// over, the offset stands on the normal. `at`: the block.
Result count_idle(MoveSink& sink, std::uint32_t at);

}  // namespace cncsub
