// Parts of a program that are executed as a call: REPEAT LABEL, CALL BLOCK FIRST TO LAST.
#pragma once

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Open a frame for the part, which is executed as often as the block says.
bool repeat_part(Run& run, const Block& block);
/// Where a pass of the running frame ends before the block at State::pc, begin the next one or
/// leave the frame. Return whether it did so.
bool end_pass(Run& run);

}  // namespace cncsub
