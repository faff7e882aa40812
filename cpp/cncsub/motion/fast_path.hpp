// The fast path, Motion::linear and Motion::arc: what it needs to know.
#pragma once

#include "cncsub/code/code.hpp"
#include "cncsub/motion/state/facts.hpp"

namespace cncsub {

/// Whether nothing but plain moves can happen, and what they count with.
void prepare_fast_path(const MotionFacts& facts, MotionState& state);

/// F of a block as a feed: times a minute have no unit of length.
inline double plain_feed(const MotionState& state, double value) {
  const bool times = state.modal[at(Group::Feed)].meaning == Meaning::InverseTime;
  return times ? value : value * state.unit;
}

/// Which of the codes of a path a meaning is, 0 for G00 to 3 for G03; -1 where it is none.
inline int path_of(Meaning meaning) {
  const int path = static_cast<int>(meaning) - static_cast<int>(Meaning::Rapid);
  return path >= 0 && path < 4 ? path : -1;
}

/// What stands for the code of a path where another one is in force.
constexpr std::uint8_t kOtherPath = 4;
/// A code of plain moves, 0 to 3, is that of the moves to come.
void take_code(const MotionFacts& facts, MotionState& state, int code);
/// F of a block holds from here on.
void take_feed(MotionState& state, double value);

/// The rows of `moves` have another state of modes from here on.
void begin_row_state(const MotionFacts& facts, MotionState& state, Moves& moves);

}  // namespace cncsub
