// The frame that points are named in: coordinates, tools, and what transforms points.
#pragma once

#include "cncsub/motion/state/context.hpp"
#include "cncsub/motion/state/modes.hpp"

namespace cncsub {

// Where points lie, and pieces that are not yet in the table.

/// Return where a point in work coordinates lies on the machine, the tool offsets included. The
/// offsets are added first, as the rows of the table of moves do.
inline Axes machine_point(const MotionState& state, const Axes& work) {
  return work + (state.offset + state.length);
}
inline Axes machine_point(const MotionState& state) { return machine_point(state, state.work); }
/// Return whether moves wait for those after them, or compensation holds the tool beside them.
inline bool moves_wait(const MotionState& state) {
  const LookaheadQueue& lookahead = state.lookahead;
  return lookahead.engaged || !lookahead.radius.empty() || !lookahead.corner.empty() ||
         state.pending_angle.waiting();
}
/// Let pieces count from where the work coordinates do, unless some wait that count from elsewhere.
inline void settle_origin(MotionState& state) {
  if (!moves_wait(state)) state.origin = state.offset;
}
/// Return the offset from work coordinates to those of pieces, and from there to the machine's.
inline Axes piece_offset(const MotionState& state) { return state.offset - state.origin; }
inline Axes piece_length(const MotionState& state) { return state.origin + state.length; }
/// Convert coordinates that are rotated as work coordinates are to the machine's own, and back.
inline Axes in_machine(const MotionState& state, const Axes& point) {
  return turned_by(state.frame_angle, point);
}
inline Axes in_frame(const MotionState& state, const Axes& machine) {
  return turned_by(-state.frame_angle, machine);
}

// Zero points.

/// Return the offset from work to base coordinates: EXT + G54... + G92 + G52, and the tool shift of
/// a lathe.
Axes zero_offset(const MotionState& state);
/// Return how far a work system is rotated about Z, in degrees; 7 is the first extra one.
double turn_of_system(const MotionState& state, int system);
/// The place of a system's rotation, after the offsets of its axes.
constexpr int kTurn = 9;
/// Return the length of a mill's tool on all axes, in machine coordinates.
Axes length_of_tool(const MotionState& state, int tool);
/// Return a datum of an edge of a tool by its number, see EdgeDatum: what a program wrote, or what
/// the setup says.
double datum_of_edge(MotionView m, std::int32_t number);
/// Execute G10 L2, L20, L1, L10 and L11 of controls whose work systems rotate, and whose tools have
/// lengths on all axes.
Result set_system_here(MotionContext& m, const BlockWords& block, double p);
Result set_tool_entry(MotionContext& m, const BlockWords& block, int l, double p);
/// Take over a changed zero point: the machine stays, the work coordinates change.
void refresh_offset(MotionState& state);
/// Return the number of the work system in force: 7 is the first extra one.
inline int system_in_force(const MotionState& state) {
  return state.work_system > 0 ? state.work_system : 6 + state.extra_system;
}
/// Keep the zero point that is in force, whatever its variables become.
void hold_zero(MotionState& state);
Result select_work(MotionContext& m, BlockWords& block);
/// G92, and G50 of a lathe: give the point these coordinates, on the named axes.
Result set_coordinate(MotionContext& m, BlockWords& block);
Result clear_coordinate(MotionContext& m, BlockWords& block);
/// Return the shift that its variables report, which a program may have written.
Axes reported_shift(const MotionState& state);
/// Drop what was written to the variables of the shift in force, when a work system is chosen: the
/// point is reported without it, and the shift stays what it was. [rs274 2.9]
void lose_written_shift(MotionState& state);
/// Give the shift of G92 by itself, clear it, suspend it or restore it.
/// [LC g-code, G52, G92.1, G92.2, G92.3]
Result change_shift(MotionContext& m, BlockWords& block, Meaning meaning);
/// Execute G52. U and W of a lathe say the same as X and Z. [TDi 19]
Result set_local(MotionContext& m, BlockWords& block);
/// Execute G10.
Result set_data(MotionContext& m, BlockWords& block);

// The end point that a block names.

/// The form in which words name a point.
struct PointForm {
  bool incremental = false;
  bool polar = false;  // a radius and an angle
};
/// A point, and the axes that the block names.
struct NamedPoint {
  Axes point;
  std::uint32_t named = 0;
};
/// Return the point that a block names; the axes without a word stay.
NamedPoint target(MotionContext& m, const BlockWords& block, const PointForm& form);
NamedPoint target(MotionContext& m, const BlockWords& block);
/// Return the point without polar coordinates, which do not reach into reference points and skips.
NamedPoint linear_target(MotionContext& m, const BlockWords& block);
/// Return the end of a move that G45 to G48 may make longer.
NamedPoint end_point(MotionContext& m, const BlockWords& block);

// Polar coordinates, and what transforms written points: rotation, scaling, mirror.

/// Set the end by polar words: the first axis of the plane is the radius, the second the angle.
void polar_target(MotionContext& m, const BlockWords& block, bool incremental, Axes& end,
                  std::uint32_t& named);
Result check_polar_words(MotionView m, const BlockWords& block);
void polar_words(MotionView m, const BlockWords& block, bool incremental, Axes& end,
                 std::uint32_t& named);
Result set_turned(MotionContext& m, BlockWords& block);
/// Transform the written point to the one the tool goes to: mirror, scaling, rotation.
void turn_point(const MotionState& state, Axes& point, std::uint32_t& named);
/// Return a point of the zero point as the frame of the program counts it.
Axes turned_back(const MotionState& state, Axes point);
/// Return the same where something turns points; else the point as it is.
inline Axes as_programmed(const MotionState& state, const Axes& point) {
  return is_turned(state) ? turned_back(state, point) : point;
}
/// Transform a distance in the plane, as I and J are.
void turn_vector(const MotionState& state, double& a, double& b, const PlaneAxes& plane);
bool mirrored_plane(const MotionState& state);

// The frame of the program, a matrix with a shift.

/// Put a frame in force, or add to the one that there is: shift, rotation, scale or mirror.
Result set_frame(MotionContext& m, BlockWords& block, Meaning meaning);
/// Apply the matrix of the frame to a point, and name the axes that move with the named ones.
void turn_in_frame(const GeneralFrame& frame, Axes& point, std::uint32_t& named);
Axes turned_back(const GeneralFrame& frame, Axes point);
/// Return whether arcs of the plane stay arcs of that plane in the frame.
bool keeps_arcs(const GeneralFrame& frame, const PlaneAxes& plane);
/// Return the factor of lengths in the plane, negative where the frame mirrors it.
double factor_in_plane(const GeneralFrame& frame, const PlaneAxes& plane);
/// Return the point from which increments count, in programmed coordinates.
Axes increments_from(const MotionState& state);
/// Let increments count on from a point, whatever has changed since, where the control has it so.
void keep_increments(const MotionFacts& facts, MotionState& state, const Axes& from);
/// Set the pole of polar words.
Result set_pole(MotionContext& m, BlockWords& block);

// Tools: T, H and D.

/// Put the edge D of the tool in the spindle in force, with its length; D1 comes with the tool.
Result set_edge(MotionContext& m, const BlockWords& block);

Result set_tool(MotionContext& m, BlockWords& block);
/// Execute G43, G44, G49 and H. A new value counts from this block on, on one axis.
Result set_length(MotionContext& m, BlockWords& block);
double radius_value(MotionView m);
/// Return the offset of the number of the tool in the spindle, 0 where there is none.
int offset_of_tool(const MotionState& state, const std::vector<double>& offsets);
/// Return whether an offset is that of the tool in the spindle: without its number, or by 0.
/// [rs274 2.9]
bool is_of_tool(MotionView m, const BlockWords& block, char letter);
/// Execute G45 to G48: the move of each named axis gets longer or shorter by an offset, or by twice
/// that. A canned cycle does not take notice of them. [M7 p.242]
Result set_longer(MotionView m, BlockWords& block);
/// Return the end of a move that G45 to G48 make longer in the direction of each axis. An increment
/// of zero goes in the direction of its sign, an absolute word that moves nothing stays so.
/// [M7 p.242 (3)]
Axes lengthened(MotionView m, const BlockWords& block, Axes end, std::uint32_t named);
/// Return the vector from the centre of the nose to the imaginary tip, which the program moves: tip
/// 3 points to -X and -Z, 8 to -X.
std::array<double, 3> tip_vector(MotionView m);

}  // namespace cncsub
