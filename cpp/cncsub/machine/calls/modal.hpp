// Modal macro calls: G66, G66.1, G67, the macro that follows a move or takes a block's words, and
// the block whose own call, return or jump waits for it.
#pragma once

#include <cstdint>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Execute G66. It only declares: what it calls is looked up at the first call.
bool modal_call(Run& run, const Block& block);
/// Execute G67.
bool cancel_modal(Run& run, const Block& block);
/// Call the macro of G66.1 with the words of a block as its arguments.
bool every_block(Run& run, const Block& block);
/// Return whether the last modal call takes the words of the running block.
inline bool takes_words(const Run& run) {
  return !run.state.modals.empty() && run.state.modals.back().every_block &&
         run.frame().modal < 0 && !run.block.follows_moves;
}

/// Return whether this modal call follows the move of the running block.
inline bool follows_moves(const Run& run, std::int32_t modal) {
  const auto& modals = run.state.modals;
  const auto place = static_cast<std::size_t>(modal);
  return !modals[place].every_block || (run.block.follows_moves && place + 1 == modals.size());
}
std::int32_t modal_of_move(const Run& run);
/// Return the modal call that follows the move of the running block, whose words are executed; -1
/// where none does.
inline std::int32_t modal_after(const Run& run) {
  return run.state.modals.empty() ? -1 : modal_of_move(run);
}
/// Return whether a modal call follows the running block although it is a macro statement.
bool follows_statements(const Run& run);
/// Enter the macro that follows the move of a block, if one does. The block is a step already.
bool call_after_move(Run& run);

/// Return the running block as one that waits with `op`; what `op` needs is to be added.
inline WaitingBlock waiting_block(const Run& run, Op op, std::uint32_t aux) {
  WaitingBlock waiting;
  waiting.op = op;
  waiting.aux = aux;
  waiting.at = run.state.pc;
  waiting.step = run.state.executed;
  return waiting;
}
/// Enter the modal macro of a block's move. It comes before the block's own call, return or jump,
/// and from the same frame. The block is a step when the macro begins.
bool do_behind_modal(Run& run, WaitingBlock waiting);
/// Go on with the block that waited for the macro. Its return may end the wait of another one.
bool resume_waiting(Run& run);

}  // namespace cncsub
