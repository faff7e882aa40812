// A block: what does not go together in it, the modes that it sets, and what its codes do.
#pragma once

#include <bit>
#include <vector>

#include "cncsub/motion/state/context.hpp"

namespace cncsub {

/// The codes that turn the work coordinates.
constexpr std::uint32_t kTurning = bit(Group::Rotation) | bit(Group::Scaling) | bit(Group::Mirror);

/// Execute a block. `of_cycle`: it is a part of a cycle's profile.
Result run_block(MotionContext& m, const NcWords& words, std::uint32_t step, bool of_cycle = false);

/// Return what is wrong with a G code by itself, and note the codes that do not count.
Result read_codes(MotionContext& m, const BlockWords& block);
/// Return what may not stand together, before anything changes.
Result check_block(MotionView m, const BlockWords& block);
Result check_conflicts(MotionView m, const BlockWords& block);
Result set_modes(MotionContext& m, BlockWords& block);
/// Return the fault of a word that neither a code of its block nor the mode uses, see WordUses.
std::optional<Fault> unused_word(MotionView m, const NcWords& words);

/// Execute G70 to G73, which follow a profile.
Result contour(MotionContext& m, BlockWords& block, Meaning meaning);
/// Execute G04.
Result dwell(MotionContext& m, BlockWords& block);
/// Return the seconds that the words of a G04 say, 0 where none of them does.
double dwell_seconds(MotionView m, const NcWords& words);
/// Take F over where it is a feed.
Result set_feed(MotionContext& m, const BlockWords& block);
/// Execute M06: the tool of T is in the spindle.
void change_tool(const Control& control, MotionState& state);
/// Do what an M code does to the spindle.
void take_spindle(MotionState& state, Role role);

// Reference points and machine coordinates.

/// G53: move the named axes to machine coordinates. The tool length is taken away on them.
/// [0iMB p.228]
Result machine_move(MotionContext& m, BlockWords& block);
/// G28 and G30: rapid to the intermediate point, then to the reference point, the named axes only.
Result reference(MotionContext& m, BlockWords& block, int number_of_point);
/// Make the place of the tool reference point 1 or 2. [LC g-code, G28.1, G30.1]
Result store_reference(MotionContext& m, BlockWords& block);
/// G29: move over the intermediate point of the last G28 to the point. Under G91 the values count
/// from the intermediate point.
Result from_reference(MotionContext& m, BlockWords& block);
Result check_reference(MotionContext& m, BlockWords& block);
/// G60: rapid past the point on the same side every time, then rapid to the point.
Result one_way(MotionContext& m, BlockWords& block);

/// One of the moves that axes make which go beside the path: until the first of them arrives.
struct BesideMove {
  Axes end{};
  std::uint32_t axes = 0;  // those on their way
  double feed = 0;         // of them together, mm/min
};
/// Return the moves from one point to another, each axis at its own feed in force.
std::vector<BesideMove> moves_beside_path(MotionView m, const Axes& from, const Axes& end);
/// Move axes beside the path.
Result position_axes(MotionContext& m, BlockWords& block);

// Tools.

/// Move the axis of a changed tool vector at once, unless the block moves it anyway.
Result move_by_length(MotionContext& m, BlockWords& block, const Axes& before);
Result set_radius(MotionContext& m, BlockWords& block);
/// Take over the allowance beside the contour.
void set_contour_offset(MotionContext& m, const BlockWords& block);

// Skip signals and measuring.

/// G31: feed to where the skip signal comes. The rest of the path is dropped: the blocks after it
/// go on from there, increments too. [15iM p.564; M7 p.547]
Result skip(MotionContext& m, BlockWords& block);
/// Execute G36 and G37.
Result measure_tool(MotionContext& m, BlockWords& block);
/// Return the feed of a skip. A control that stops at once is not let go fast. [TDi 16, TDi 17]
double held_skip_feed(MotionView m, double feed, FeedMode mode);
/// Return the signals that G31 or G04 watches; none is no signal at all.
SignalMask signals_of(MotionView m, const BlockWords& block);
/// Return where on the path the first of these signals comes, 0 to 1, and let the path end there.
std::optional<double> signal_on_way(MotionContext& m, SignalMask signals, Axes& end);

}  // namespace cncsub
