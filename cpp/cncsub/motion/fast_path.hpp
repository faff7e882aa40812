// The fast path, Motion::linear and Motion::arc: what it needs to know.
#pragma once

#include "cncsub/motion/facts.hpp"

namespace cncsub {

/// Whether nothing but plain moves can happen, and what they count with.
void prepare_fast_path(const MotionFacts& facts, MotionState& state);

}  // namespace cncsub
