// O words: subprograms, branches and loops.
#pragma once

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

bool run_labelled(Run& run, const Block& block);

}  // namespace cncsub
