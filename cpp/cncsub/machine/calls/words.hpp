// The words of a block: their values, what they do, and the codes that go to the machine.
#pragma once

#include <string>

#include "cncsub/machine/state/context.hpp"
#include "cncsub/machine/statements/output.hpp"

namespace cncsub {

/// Return whether NC words stand in a block, beside what it calls or returns from.
inline bool has_words(const Block& block) { return block.mask != 0 || block.has_codes(); }

/// Decode the words of a block, and do what they say. A block of nothing else is done then.
bool carry_out(Run& run, const Block& block);
/// Execute the words of a block that may have none.
inline bool execute_words(Run& run, const Block& block) {
  run.block.outcome = {};
  if (has_words(block)) return carry_out(run, block);
  if ((block.flags & Block::kDrops) != 0) tell_dropped(run, block, {});
  if (block.n >= 0) run.state.last_n = block.n;
  if (!is_words(block.op)) return true;
  record_step(run);
  run.state.pc = run.block.next;
  return true;
}
/// Execute codes that save the modes, forget them or restore them. Return false where that alarms.
bool change_saved_modes(Run& run, const NcWords& words);
/// Save the modes as they are when a program is entered whose return restores them: its codes, and
/// neither F nor S.
void keep_modes_of_caller(Run& run);
/// Restore, after a return, the modes that were to come back.
bool come_back_to_modes(Run& run);
/// Finish a block whose words are executed and that has nothing else. It is a step, and the run
/// goes on after it, or with the macro that follows its move.
bool after_words(Run& run);

}  // namespace cncsub
