// The processors of this machine.
#pragma once

#include <cstddef>

namespace cncsub::system {

/// Return how many processors this process may use, one at least.
std::size_t cores();

}  // namespace cncsub::system
