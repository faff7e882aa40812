// Calls: M98 and its family, macro calls, calls by codes, and what refuses them.
#pragma once

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// A block with a subprogram call, and one with a macro call: its words, then the call, which waits
/// for the macro of a modal call that follows the block's move.
bool call(Run& run, const Block& block);
bool macro_call(Run& run, const Block& block);
/// What is left of them when their words are executed; the arguments lie in the running block.
bool call_now(Run& run, std::uint32_t aux, Target& target);

/// Calls that the state refuses, whatever is called; and those of this program.
std::optional<Fault> refused_here(const Run& run, const CallRecord& record);
std::optional<Fault> refused(const Run& run, const CallRecord& record, const Target& target);
/// The form of the call, before anything of its block is executed.
bool decode_target(Run& run, const CallRecord& record, Target& target);
/// The arguments of a call, evaluated at the caller's level, into the running block.
bool evaluate_arguments(Run& run, const CallRecord& record);

/// Opens a frame for what `target` says. The block is a step of the caller then. `modal`: the macro
/// is that of a modal call.
bool enter(Run& run, std::uint32_t index, const Target& target, std::int32_t modal);
/// Closes the frame and goes on in the caller: with what its block waited with, where it `goes_on`.
bool leave(Run& run, Address to, bool goes_on = true);

}  // namespace cncsub
