// Cycles: many moves from one block.
#pragma once

#include <utility>

#include "cncsub/motion/state/context.hpp"

namespace cncsub {

// Canned cycles: drilling, boring, tapping. Those of a lathe count R from the initial level, to
// which the tool returns. [TA 24]
Result enter_cycle(MotionContext& m, BlockWords& block);
void end_cycles(const MotionFacts& facts, MotionState& state);
Result canned_cycle(MotionContext& m, BlockWords& block);

// Cycles of lathes: G90 G92 G94, grooving G74 G75.
/// Execute G90, G92 or G94. A thread of several starts is cut start by start. [TDi 24.9, TA 18: L]
Result turning_cycle(MotionContext& m, BlockWords& block, Meaning meaning);
/// Execute G74 or G75. G74 pecks along Z and steps along X, G75 the other way around.
Result grooving(MotionContext& m, BlockWords& block, Meaning meaning);
/// Return P or Q of a lathe's cycle. Whole numbers count least increments, also where a length
/// would be millimetres.
double cycle_length(MotionView m, const BlockWords& block, char address);

// Threads.
/// Return whether F of this block is the lead of a thread.
bool cuts_thread(const MotionState& state, const BlockWords& block);
/// Take over F of a thread, or I: so many threads an inch. [TDi 24.1]
void set_lead(MotionContext& m, const BlockWords& block);
Result need_lead(MotionView m, const BlockWords& block);
/// The run-out of a thread: so far before the end of its line, so far to the side; radius values.
struct RunOut {
  double along = 0, across = 0;
};
/// Cut to `end`; the run-out goes to the side `way`. The lead grows by `growth` with every
/// revolution.
Result cut_thread(MotionContext& m, BlockWords& block, const Axes& end, std::uint32_t named,
                  RunOut out, double way, double growth);
/// Execute G32, G33 or G34.
Result thread(MotionContext& m, BlockWords& block, Meaning meaning);
/// Take over J and K, which stay until another motion code. [TDi 24.1 note 1]
Result take_run_out(MotionContext& m, const BlockWords& block, bool of_cycle);
/// Cut the thread of a cycle: it runs out towards the start, and not beyond it. [TA 18 note 5]
Result cut_cycle_thread(MotionContext& m, BlockWords& block, const Axes& end, double tenths,
                        double level);
/// Execute G76 of a mill: thread passes beside a drive line, from the tool to Z.
Result drive_line_thread(MotionContext& m, BlockWords& block);
/// Cut a thread with the lead K, or a tap, which goes back the way it came. [LC g-code, G33, G33.1]
Result thread_by_k(MotionContext& m, BlockWords& block);
/// Execute G76 of a lathe.
Result multiple_thread(MotionContext& m, BlockWords& block);

// The path to a hole of a mill.

/// Return whether a series that began below R goes to R before it goes to a hole.
bool goes_to_r_first(const MotionFacts& facts);
/// Return whether a cycle goes back to R, not to where its series began.
bool returns_to_r(const MotionState& state);
/// Return the levels of R and of the bottom. Where a series goes to R first, the mode of the block
/// says how R and the depth count, whichever block gave them.
std::pair<double, double> hole_levels(MotionView m);
/// Move over the hole, the `first` of its block or a repeat, and to R.
Result approach_hole(MotionContext& m, BlockWords& block, int axis, double r, bool first);

}  // namespace cncsub
