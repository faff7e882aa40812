// The path between two points: arcs, lines by their angle, corners, radius compensation.
#pragma once

#include "cncsub/motion/context.hpp"

namespace cncsub {

/// G02 and G03.
Result arc(MotionContext& m, BlockWords& block, Meaning meaning);
/// An arc through a third point: I and K lead to it from the start, or name it. [TDi 5]
Result arc_by_points(MotionContext& m, BlockWords& block, Meaning meaning);

/// The angle of a straight move with the first axis of the plane, counter-clockwise, in degrees.
bool angle_word(MotionView m, const BlockWords& block, double& angle);
Result angled(MotionContext& m, BlockWords& block, Meaning meaning, double angle);
/// Behind a straight move of which only the angle is known comes the one that tells its end; one
/// block without a move may stand between. [TDi 13 notes 6, 7]
Result check_angle(MotionContext& m, const BlockWords& block, bool waited);

/// Chamfers and corner rounds.
Result corner_words(MotionView m, const BlockWords& block, Piece& piece);
/// The way of a piece to the table: through a corner, which waits for the next piece, and through
/// radius compensation, which does too.
Result through_corner(MoveSink& sink, Piece piece, Axes from);
Result through_radius(MoveSink& sink, Piece piece, const Axes& from);
Result flush_radius(MoveSink& sink);
/// Looks over a few blocks without a move in the plane; behind more of them the offset stands on
/// the normal.
Result count_idle(MotionContext& m, const BlockWords& block);

}  // namespace cncsub
