// The next block, as somebody sets it from outside between two blocks.
#pragma once

#include <optional>
#include <string>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Return why a run that has stopped does not go on; nothing where it does.
std::optional<std::string> over(Stop stop);
/// Go on at another block of the program that runs, without executing one. Loops that do not hold
/// it are left, as a jump of the program leaves them, and an alarm or a wait is over. Return why it
/// cannot be, or nothing; then nothing has changed.
std::optional<std::string> set_next_block(Run& run, Address to);

}  // namespace cncsub
