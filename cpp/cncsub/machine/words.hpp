// The words of a block: their values, what they do, and the codes that go to the machine.
#pragma once

#include <string>

#include "cncsub/machine/context.hpp"
#include "cncsub/machine/output.hpp"

namespace cncsub {

/// Whether NC words stand in a block, beside what it calls or returns from.
inline bool has_words(const Block& block) { return block.mask != 0 || block.has_codes(); }

/// The words of a block with their values. A vacant variable's word is left out, or counts as 0, as
/// the control does. `at` is the address of the block, which may be a variant of the one there.
bool decode(Run& run, const Block& block, Address at, NcWords& words);

/// Decodes the words of a block, and does what they say. A block of nothing else is done then.
bool carry_out(Run& run, const Block& block);
/// The same for a block that may have none.
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
/// What is left of a block when its words are executed and it has nothing else: it is a step, and
/// the run goes on behind it, or with the macro that follows its move.
bool after_words(Run& run);

/// An M code, or #3006, asks the operator for cycle start; the run stops where he does not give it.
bool wait_for_operator(Run& run, const std::string& what);

}  // namespace cncsub
