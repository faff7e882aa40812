// The frame that points are named in: coordinates, reference points, tools, what turns points, and
// what a stylus finds.
#pragma once

#include "cncsub/motion/context.hpp"

namespace cncsub {

// Zero points.

/// The way from work to base coordinates: EXT + G54... + G92 + G52, and the tool shift of a lathe.
Axes zero_offset(const MotionState& state);
/// How far a work system is turned about Z, degrees; 7 is the first extra one.
double turn_of_system(const MotionState& state, int system);
/// Behind the offsets of the axes of a system stands its turn.
constexpr int kTurn = 9;
/// The length of a mill's tool on all axes, machine coordinates.
Axes length_of_tool(const MotionState& state, int tool);
/// G10 L2, L20, L1, L10 and L11 of controls whose work systems turn, and whose tools have lengths
/// on all axes.
Result set_system_here(MotionContext& m, const BlockWords& block, double p);
Result set_tool_entry(MotionContext& m, const BlockWords& block, int l, double p);
/// Takes a changed zero point over: the machine stays, the work coordinates change.
void refresh_offset(MotionState& state);
/// The number of the work system in force: 7 is the first extra one.
inline int system_in_force(const MotionState& state) {
  return state.work_system > 0 ? state.work_system : 6 + state.extra_system;
}
const Axes& zero_of(const MotionState& state, int system);
/// Keeps the zero point that is in force, whatever its variables become.
void hold_zero(MotionState& state);
Result select_work(MotionContext& m, BlockWords& block);
/// G92, and G50 of a lathe: the point gets these coordinates, on the named axes.
Result set_coordinate(MotionContext& m, BlockWords& block);
Result clear_coordinate(MotionContext& m, BlockWords& block);
/// The shift that its variables tell, which a program may have written.
Axes told_shift(const MotionState& state);
/// A work system is chosen while variables of the shift in force were written: the point is
/// told without what is written, and the shift stays what it was. [rs274 2.9]
void lose_written_shift(MotionState& state);
/// The shift that G92 sets is given by itself, cleared, put aside or taken back in. [LC g-code,
/// G52, G92.1, G92.2, G92.3]
Result change_shift(MotionContext& m, BlockWords& block, Meaning meaning);
/// G52. U and W of a lathe say the same as X and Z. [TDi 19]
Result set_local(MotionContext& m, BlockWords& block);
/// G10.
Result set_data(MotionContext& m, BlockWords& block);

// The end point that a block names.

/// How words name a point.
struct PointForm {
  bool incremental = false;
  bool polar = false;  // a radius and an angle
};
PointForm point_form(const MotionState& state);
/// The axes without a word stay.
Axes target(MotionContext& m, BlockWords& block, const PointForm& form, std::uint32_t& named);
Axes target(MotionContext& m, BlockWords& block, std::uint32_t& named);
/// Without polar coordinates, which do not reach into reference points and skips.
Axes linear_target(MotionContext& m, BlockWords& block, std::uint32_t& named);
/// Of a move that G45 to G48 may make longer.
Axes end_point(MotionContext& m, BlockWords& block, std::uint32_t& named);

// Polar coordinates, and what turns written points: rotation, scaling, mirror.

/// The first axis of the plane is the radius, the second the angle.
void polar_target(MotionContext& m, const BlockWords& block, bool incremental, Axes& end,
                  std::uint32_t& named);
/// @ and ^, the radius and the angle of a point in G17: what does not go with them, and the point.
constexpr std::uint32_t kPolarWords = 1u << kRadius | 1u << kAngle;
constexpr std::uint32_t kAxisWords =
    kEndWords | bit('A') | bit('B') | bit('C') | bit('U') | bit('V') | bit('W') | kPolarWords;
Result check_polar_words(MotionView m, const BlockWords& block);
void polar_words(MotionView m, const BlockWords& block, bool incremental, Axes& end,
                 std::uint32_t& named);
Result set_turned(MotionContext& m, BlockWords& block);
/// From the written point to the one the tool goes to: mirror, scaling, rotation.
void turn_point(const MotionState& state, Axes& point, std::uint32_t& named);
Axes turned_back(const MotionState& state, Axes point);
/// The same for a distance in the plane, as I and J are.
void turn_vector(const MotionState& state, double& a, double& b, const PlaneAxes& plane);
bool mirrored_plane(const MotionState& state);

// Reference points and machine coordinates.

/// G53: the named axes go to machine coordinates; the tool length is taken away on them. [0iMB
/// p.228]
Result machine_move(MotionContext& m, BlockWords& block);
/// G28 and G30: rapid to the intermediate point, rapid to the reference point, the named axes only.
Result reference(MotionContext& m, BlockWords& block, int number_of_point);
/// The place of the tool becomes reference point 1 or 2. [LC g-code, G28.1, G30.1]
Result store_reference(MotionContext& m, BlockWords& block);
/// G29: over the intermediate point of the last G28 to the point; under G91 the values count from
/// there.
Result from_reference(MotionContext& m, BlockWords& block);
Result check_reference(MotionContext& m, BlockWords& block);
/// G60: rapid past the point on the same side every time, then rapid to the point.
Result one_way(MotionContext& m, BlockWords& block);

// Tools: T, H and D.

Result set_tool(MotionContext& m, BlockWords& block);
/// G43, G44, G49 and H. A new value counts from this block on, on one axis.
Result set_length(MotionContext& m, BlockWords& block);
/// A changed tool vector moves its axis at once when the block does not move it anyway.
Result move_by_length(MotionContext& m, BlockWords& block, const Axes& before);
Result set_radius(MotionContext& m, BlockWords& block);
double radius_value(MotionView m);
/// G45 to G48: the move of each named axis gets longer or shorter by an offset, or by twice that.
/// A canned cycle does not take notice of them. [M7 p.242]
Result set_longer(MotionView m, BlockWords& block);
/// The end of a move that G45 to G48 make longer along the way of each axis. An increment of zero
/// goes the way of its sign, an absolute word that moves nothing stays so. [M7 p.242 (3)]
Axes lengthened(MotionView m, const BlockWords& block, Axes end, std::uint32_t named);
/// From the centre of the nose to the imaginary tip, which the program moves: tip 3 points to -X
/// and -Z, 8 to -X.
std::array<double, 3> tip_vector(MotionView m);

// Skip signals and measuring.

/// G31: a feed that ends where the skip signal comes. The rest of the way is dropped: the blocks
/// behind go on from there, increments too. [15iM p.564; M7 p.547]
Result skip(MotionContext& m, BlockWords& block);
/// G36 and G37.
Result measure_tool(MotionContext& m, BlockWords& block);
/// A control that stops at once is not let go fast. [TDi 16, TDi 17]
double held_skip_feed(MotionView m, double feed, FeedMode mode);
/// The signals that G31 or G04 watches; none is no signal at all.
SignalMask signals_of(MotionView m, const BlockWords& block);
/// Where on the way the first of these signals comes, 0 to 1; the way then ends there.
std::optional<double> signal_on_way(MotionContext& m, SignalMask signals, Axes& end);

}  // namespace cncsub
