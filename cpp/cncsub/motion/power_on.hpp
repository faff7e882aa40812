// The state before the first block.
#pragma once

#include "cncsub/motion/state/facts.hpp"

namespace cncsub {

MotionState state_of(const MotionFacts& facts, const Setup& setup);

/// Set the modes at power on; a reset keeps the units, the work coordinates and the feed.
void power_on(const MotionFacts& facts, MotionState& state, bool reset);

}  // namespace cncsub
