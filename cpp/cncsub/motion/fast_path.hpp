// The fast path, Motion::linear and Motion::arc: its conditions.
#pragma once

#include "cncsub/code/code.hpp"
#include "cncsub/motion/state/facts.hpp"

namespace cncsub {

/// Find whether nothing but plain moves can happen, and the values that they count with.
void prepare_fast_path(const MotionFacts& facts, MotionState& state);

/// Return F of a block as a feed. Times a minute have no unit of length.
inline double plain_feed(const MotionState& state, double value) {
  const bool times = state.modal[at(Group::Feed)].meaning == Meaning::InverseTime;
  return times ? value : value * state.feed_unit;
}

/// Return which of the codes of a path a meaning is, 0 for G00 to 3 for G03; -1 where it is none.
inline int path_of(Meaning meaning) {
  const int path = static_cast<int>(meaning) - static_cast<int>(Meaning::Rapid);
  return path >= 0 && path < 4 ? path : -1;
}

/// The value for the code of a path where another code is in force.
constexpr std::uint8_t kOtherPath = 4;
/// Put a code of plain moves, 0 to 3, in force.
void take_code(const MotionFacts& facts, MotionState& state, int code);
/// Put F of a block in force.
void take_feed(MotionState& state, double value);

/// Begin another state of modes for the rows of `moves`.
void begin_row_state(const MotionFacts& facts, MotionState& state, Moves& moves);

}  // namespace cncsub
