// How a block or a run ends before its time: alarms, stops, and what is put back.
#pragma once

#include <vector>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Stops the run. It is false, as what says that the run goes on.
bool end_run(Run& run, Stop stop);
/// Stops the run with an alarm, in the fault's block or in the running one, which is a step where
/// its words are executed, and otherwise has done nothing.
bool alarm(Run& run, const Fault& fault);
/// The same for a fault of the motion, which knows the block it stands in and no text.
bool alarm_of_motion(Run& run, Fault fault);
/// Puts back what the running block has assigned and said, and what it has taken from outside: it
/// alarms, or is to be run again.
void rollback(Run& run);
/// The calls that are open end with the last block that was executed.
void finish_calls(Run& run);
/// The open calls, the last one first, as an alarm shows them.
std::vector<Frame> open_calls(const Run& run);
/// The main program starts over: a cycle is done.
bool restart_main(Run& run);
/// Goes on with this block, or with what an M code has made of it (see RunningBlock::next).
bool proceed(Run& run, Address next);
/// An M code, or #3006, asks the operator for cycle start; the run stops where he does not give it.
bool wait_for_operator(Run& run, const std::string& what);

}  // namespace cncsub
