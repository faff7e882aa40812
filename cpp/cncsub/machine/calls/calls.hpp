// Calls: M98 and its family, macro calls, calls by codes, and what refuses them.
#pragma once

#include "cncsub/code/search.hpp"
#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Execute a block with a subprogram call, or one with a macro call: its words, then the call,
/// which waits for the macro of a modal call that follows the block's move.
bool call(Run& run, const Block& block);
bool macro_call(Run& run, const Block& block);
/// Execute an O word: a subprogram, a branch or a loop.
bool run_labelled(Run& run, const Block& block);
/// Execute what is left of a call after the words; the arguments lie in the running block.
bool call_now(Run& run, std::uint32_t aux, Target& target);

/// Return why the state refuses a call whatever is called, and why it refuses this target.
std::optional<Fault> refused_here(const Run& run, const CallRecord& record);
std::optional<Fault> refused(const Run& run, const CallRecord& record, const Target& target);
/// Decode the form of the call, before anything of its block is executed.
bool decode_target(Run& run, const CallRecord& record, Target& target);
/// Evaluate the arguments of a call at the caller's level, into the running block.
bool evaluate_arguments(Run& run, const CallRecord& record);

/// Open a frame for what `target` says. The block is a step of the caller then. `modal`: the macro
/// is that of a modal call.
bool enter(Run& run, std::uint32_t index, const Target& target, std::int32_t modal);
/// Close the frame and go on in the caller; where it `goes_on`, with what its block waited with.
bool leave(Run& run, Address to, bool goes_on = true);

/// Evaluate which variables of the caller the parameters by reference stand for, as arguments.
bool evaluate_references(Run& run, const CallRecord& record);
/// Give the arrays that a call hands over by value copies of their own, on the level that is open.
void copy_arrays(Run& run, const CallRecord& record);
/// Return where a call begins its search: the main program, and the folder of CALLPATH.
SearchFrom search_of(const Run& run);
/// Return the record of the call of a block, by the program that it means now; nothing where that
/// program does not take it, and the run stopped.
std::optional<std::uint32_t> record_of(Run& run, const Block& block);
/// Find the program that the text of a call names.
bool find_by_text(Run& run, const CallRecord& record, Target& target);
/// Give the parameters of a program that a text names their own values: the call has none.
bool take_own_values(Run& run, const CallRecord& record, const Target& target);

}  // namespace cncsub
