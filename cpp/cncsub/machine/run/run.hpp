// Executes blocks one after the other: a run from where it stands to its end, or to the next block.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

constexpr std::int64_t kAllBlocks = std::numeric_limits<std::int64_t>::max();

/// Execute one block. Return false where the run has stopped before one was executed, or where
/// `interrupted` stopped the block, which then did nothing. A block of very many moves asks it now
/// and then.
bool run_one(Run& run, const std::function<bool()>& interrupted);
/// What may pause a run between two blocks.
struct Pauses {
  std::function<bool()> ask = {};        // whether to pause before the block at State::pc
  const std::uint8_t* marked = nullptr;  // by address, before which blocks it asks; null: all
};
/// Run until the run stops, or pauses, or `until` blocks are executed, or fewer where they made
/// very many moves.
void run_on(Run& run, const std::function<bool()>& interrupted, const Pauses& pauses,
            std::int64_t until = kAllBlocks);
/// Skip the block at State::pc and return true if a block-skip switch says so, or if a pass of
/// RepeatPart ends before it.
bool passes_over(Run& run);
/// Execute one block of any kind: the one at State::pc, a variant of it, or what stands after its
/// THEN. Return false where the run stopped.
bool dispatch(Run& run, const Block& block);

}  // namespace cncsub
