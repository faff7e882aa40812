// A block: what does not go together in it, the modes that it sets, and what its codes do.
#pragma once

#include <bit>

#include "cncsub/motion/state/context.hpp"

namespace cncsub {

/// Carries a block out. `of_cycle`: as a part of a cycle's profile.
Result run_block(MotionContext& m, const NcWords& words, std::uint32_t step, bool of_cycle = false);

/// What is wrong with a G code by itself, and which of them do not count.
Result read_codes(MotionContext& m, const BlockWords& block);
/// What may not stand together, before anything changes.
Result check_block(MotionView m, const BlockWords& block);
Result check_conflicts(MotionView m, const BlockWords& block);
Result set_modes(MotionContext& m, BlockWords& block);
/// The fault of a word that neither a code of its block nor the mode uses, see WordUses.
std::optional<Fault> unused_word(MotionView m, const NcWords& words);

/// G70 to G73: what follows a profile.
Result contour(MotionContext& m, BlockWords& block, Meaning meaning);
/// G04.
Result dwell(MotionContext& m, BlockWords& block);
/// The seconds that the words of a G04 say, 0 where none of them does.
double dwell_seconds(MotionView m, const NcWords& words);
/// Takes F over, where it is a feed.
Result set_feed(MotionContext& m, const BlockWords& block);
/// M06: the tool of T is in the spindle.
void change_tool(const Control& control, MotionState& state);
/// What an M code does to the spindle.
void take_spindle(MotionState& state, Role role);

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

// Tools.

/// A changed tool vector moves its axis at once when the block does not move it anyway.
Result move_by_length(MotionContext& m, BlockWords& block, const Axes& before);
Result set_radius(MotionContext& m, BlockWords& block);

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
