// From a block's motion to the rows of the table.
#pragma once

#include "cncsub/motion/context.hpp"

namespace cncsub {

/// Where a point in work coordinates lies on the machine, the tool offsets included. The offsets
/// are added first, as the rows of the table of moves do.
inline Axes machine_point(const MotionState& state, const Axes& work) {
  return work + (state.offset + state.length);
}
inline Axes machine_point(const MotionState& state) { return machine_point(state, state.work); }
/// Whether moves wait for those behind them, or compensation holds the tool beside them.
inline bool moves_wait(const MotionState& state) {
  const Held& held = state.held;
  return held.engaged || !held.radius.empty() || !held.corner.empty() || state.angled.waiting();
}
/// Pieces count from where the work coordinates do, unless some wait that count from elsewhere.
inline void settle_origin(MotionState& state) {
  if (!moves_wait(state)) state.origin = state.offset;
}
/// What leads from work coordinates to those of pieces, and from there to the machine's.
inline Axes piece_offset(const MotionState& state) { return state.offset - state.origin; }
inline Axes piece_length(const MotionState& state) { return state.origin + state.length; }
/// From coordinates that are turned as work coordinates are to the machine's own, and back.
inline Axes in_machine(const MotionState& state, const Axes& point) {
  return turned_by(state.frame_angle, point);
}
inline Axes in_frame(const MotionState& state, const Axes& machine) {
  return turned_by(-state.frame_angle, machine);
}
MoveState move_state(const MotionState& state);

/// A motion of this block to a point in work coordinates, without radius compensation.
Piece uncompensated(MotionView m, const BlockWords& block, MoveKind kind, const Axes& work_end,
                    std::uint32_t named);
/// The same with what compensation there is.
Piece make_piece(MotionView m, const BlockWords& block, MoveKind kind, const Axes& work_end,
                 std::uint32_t named);

Result move(MotionContext& m, BlockWords& block, const Piece& piece);
Result move(MotionContext& m, BlockWords& block, MoveKind kind, const Axes& work_end,
            std::uint32_t named);
Result move_axis(MotionContext& m, BlockWords& block, MoveKind kind, int axis, double value);
Result add_dwell(MotionContext& m, BlockWords& block, double seconds);

/// Whether the tool comes to another place.
inline bool comes_elsewhere(const Axes& from, const Axes& to) {
  if (same_bits(from, to)) return false;
  for (std::size_t i = 0; i < from.size(); ++i)
    if (std::fabs(to[i] - from[i]) >= kStanding) return true;
  return false;
}

/// Writes the row of a piece whose tool path is known. `vector` leads from the programmed point to
/// the tool.
Result record_move(MoveSink& sink, const Piece& piece, const std::array<double, 3>& vector);

// Where the tool may not go: the travel of the axes, and the area of G22.
Result check_travel(MotionView m, const Piece& piece, const Axes& machine);
/// The stored stroke check 2: no move leads through the area, or out of it.
Result check_area(MotionView m, const Piece& piece, const Axes& machine);
bool checks_area(const MotionState& state);
/// G22 X Y Z I J K: the upper and the lower corner of the area, in machine coordinates; what is not
/// written stays. [TDi 31]
Result set_area(MotionContext& m, BlockWords& block);

}  // namespace cncsub
