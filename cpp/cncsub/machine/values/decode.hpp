// Decodes the words of a block, with the values that their expressions have now.
#pragma once

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Decode the words of a block with their values. A vacant variable's word is left out, or counts
/// as 0, as the control does. `at` is the address of the block, which may be a variant of the one
/// there.
bool decode(Run& run, const Block& block, Address at, NcWords& words);

}  // namespace cncsub
