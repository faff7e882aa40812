// Blocks that assign and say something besides executing words.
#pragma once

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Execute the block's assignments, all with the values from before, and its message. The words
/// have their values already, and are executed after it.
bool assign_in_parallel(Run& run);

}  // namespace cncsub
