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
/// Run until the run stops, or `pause` says so (asked before each block when it is given), or
/// `until` blocks are executed, or fewer where they made very many moves.
void run_on(Run& run, const std::function<bool()>& interrupted, const std::function<bool()>& pause,
            std::int64_t until = kAllBlocks);
/// Execute one block of any kind: the one at State::pc, a variant of it, or what stands after its
/// THEN. Return false where the run stopped.
bool dispatch(Run& run, const Block& block);

}  // namespace cncsub
