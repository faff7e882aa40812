// The fast path, Motion::linear and Motion::arc: what it needs to know.
#pragma once

#include "cncsub/motion/facts.hpp"

namespace cncsub {

/// Whether nothing but plain moves can happen, and what they count with.
void prepare_fast_path(const MotionFacts& facts, MotionState& state);

/// The rows of `moves` have another state of modes from here on.
void begin_row_state(const MotionFacts& facts, MotionState& state, Moves& moves);

}  // namespace cncsub
