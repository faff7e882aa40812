// From a block's motion to the rows of the table.
#pragma once

#include "cncsub/motion/state/context.hpp"

namespace cncsub {

MoveState move_state(const MotionState& state);

/// Return a motion of this block to a point in work coordinates, without radius compensation.
Piece uncompensated(MotionView m, const BlockWords& block, MoveKind kind, const Axes& work_end,
                    std::uint32_t named);
/// Return the same with the compensation in force.
Piece make_piece(MotionView m, const BlockWords& block, MoveKind kind, const Axes& work_end,
                 std::uint32_t named);

Result move(MotionContext& m, BlockWords& block, const Piece& piece);
Result move(MotionContext& m, BlockWords& block, MoveKind kind, const Axes& work_end,
            std::uint32_t named);
Result move_axis(MotionContext& m, BlockWords& block, MoveKind kind, int axis, double value);
Result add_dwell(MotionContext& m, BlockWords& block, double seconds);

/// Return whether the tool comes to another place.
inline bool comes_elsewhere(const Axes& from, const Axes& to) {
  if (same_bits(from, to)) return false;
  for (std::size_t i = 0; i < from.size(); ++i)
    if (std::fabs(to[i] - from[i]) >= kStanding) return true;
  return false;
}

/// Write the row of a piece whose tool path is known. `vector` leads from the programmed point to
/// the tool.
Result record_move(MoveSink& sink, const Piece& piece, const std::array<double, 3>& vector);

// Where the tool may not go: the travel of the axes, and the area of G22.
Result check_travel(MotionView m, const Piece& piece, const Axes& machine);
/// Execute stored stroke check 2: no move leads through the area, or out of it.
Result check_area(MotionView m, const Piece& piece, const Axes& machine);
bool checks_area(const MotionState& state);
/// Execute G22 X Y Z I J K: the upper and the lower corner of the area, in machine coordinates;
/// what is not written stays. [TDi 31]
Result set_area(MotionContext& m, BlockWords& block);

}  // namespace cncsub
