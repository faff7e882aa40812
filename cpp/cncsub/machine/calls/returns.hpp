// Where a run goes on that leaves a program or a cycle of one: M99, M97, M02 and M30, the end of
// the text.
#pragma once

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// M99, with P or L; it waits for the macro of a modal call that follows the block's move.
bool return_from_call(Run& run, const Block& block);
/// What is left of it when its words are executed.
bool return_now(Run& run, const CallRecord& back, double p, double l);

/// M97: to a block of the running program; it waits as M99 does.
bool jump(Run& run, const Block& block);
bool jump_now(Run& run, const JumpRecord& jump, double p);

/// M02, M30.
bool end_program(Run& run, const Block& block);
/// Whether M02 or M30 ends the run where it stands now, and does not return from a subprogram.
bool ends_the_run(const Run& run);
/// The text of a program ends without M02, M30 or M99.
bool end_of_record(Run& run);

}  // namespace cncsub
