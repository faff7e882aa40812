// Modal macro calls: G66, G66.1, G67, the macro that follows a move or takes a block's words, and
// the block whose own call, return or jump waits for it.
#pragma once

#include <cstdint>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// G66 only declares: what it calls is looked up at the first call.
bool modal_call(Run& run, const Block& block);
/// G67.
bool cancel_modal(Run& run, const Block& block);
/// A block under G66.1: its words are the arguments.
bool every_block(Run& run, const Block& block);
/// Whether the last modal call takes the words of the running block.
inline bool takes_words(const Run& run) {
  return !run.state.modals.empty() && run.state.modals.back().every_block &&
         run.frame().modal < 0 && !run.block.follows_moves;
}

/// Whether this modal call follows the move of the running block.
inline bool follows_moves(const Run& run, std::int32_t modal) {
  const auto& modals = run.state.modals;
  const auto place = static_cast<std::size_t>(modal);
  return !modals[place].every_block || (run.block.follows_moves && place + 1 == modals.size());
}
std::int32_t modal_of_move(const Run& run);
/// The modal call that follows the move of the running block, whose words are executed; -1 where
/// none does.
inline std::int32_t modal_after(const Run& run) {
  return run.state.modals.empty() ? -1 : modal_of_move(run);
}
/// Enters the macro that follows the move of a block, which is a step; or nothing follows it.
bool call_after_move(Run& run);

/// The running block as one that waits with `op`; what that needs is to be added.
inline WaitingBlock waiting_block(const Run& run, Op op, std::uint32_t aux) {
  WaitingBlock waiting;
  waiting.op = op;
  waiting.aux = aux;
  waiting.at = run.state.pc;
  waiting.step = run.state.executed;
  return waiting;
}
/// The modal macro of a block's move comes before the block's own call, return or jump, and from
/// the same frame. The block is a step when the macro begins.
bool do_behind_modal(Run& run, WaitingBlock waiting);
/// Behind the macro the block that waited goes on; it may return behind another one.
bool resume_waiting(Run& run);

}  // namespace cncsub
