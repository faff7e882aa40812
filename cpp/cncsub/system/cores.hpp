// The processors of this machine.
#pragma once

#include <cstddef>

namespace cncsub::system {

/// How many of them this process may use, one at least.
std::size_t cores();

}  // namespace cncsub::system
