// The end of a block or a run before its time: alarms, stops, and rollback.
#pragma once

#include <vector>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Stop the run. Return false, as functions do that say whether the run goes on.
bool end_run(Run& run, Stop stop);
/// Stop the run with an alarm, in the fault's block or in the running one. The block is a step
/// where its words are executed, and otherwise has done nothing.
bool alarm(Run& run, const Fault& fault);
/// Alarm with a fault of the motion, which knows the block it stands in and no text.
bool alarm_of_motion(Run& run, Fault fault);
/// Undo what the running block has assigned and said, and what it has read from outside: it alarms,
/// or is to be run again.
void rollback(Run& run);
/// End the open calls with the last block that was executed.
void finish_calls(Run& run);
/// Let the open calls go on: the run stopped in them, and runs again.
void reopen_calls(Run& run);
/// Return the open calls, the last one first, as an alarm shows them.
std::vector<Frame> open_calls(const Run& run);
/// Start the main program over: a cycle is done.
bool restart_main(Run& run);
/// Go on with this block, or with what an M code has made of it (see RunningBlock::next).
bool proceed(Run& run, Address next);
/// Ask the operator for cycle start, for an M code or #3006. The run stops where he does not give
/// it.
bool wait_for_operator(Run& run, const std::string& what);

}  // namespace cncsub
