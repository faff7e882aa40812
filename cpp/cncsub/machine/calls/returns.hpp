// Returns, jumps and ends: M99, M97, M02, M30 and the end of a text.
#pragma once

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Execute M99, with P or L; it waits for the macro of a modal call that follows the block's move.
bool return_from_call(Run& run, const Block& block);
/// Execute what is left of M99 when its words are executed.
bool return_now(Run& run, const CallRecord& back, double p, double l);

/// Jump to a block of the running program (M97); it waits as M99 does.
bool jump(Run& run, const Block& block);
bool jump_now(Run& run, const JumpRecord& jump, double p);

/// Execute M02 or M30.
bool end_program(Run& run, const Block& block);
/// Return whether M02 or M30 here ends the run, and does not return from a subprogram.
bool ends_the_run(const Run& run);
/// Stop where the text of a program ends without M02, M30 or M99.
bool end_of_record(Run& run);

}  // namespace cncsub
