// Straight moves of the fast path that are more than X, Y and Z as they are written.
#pragma once

#include "cncsub/motion/facts.hpp"
#include "cncsub/motion/state.hpp"

namespace cncsub {

/// A straight move of other axes than X, Y and Z too, before anything changes.
struct PlainLine {
  Axes end{};  // work coordinates
  std::uint32_t named = 0;
  double seconds = 0;
  bool moved = false;
};

/// False where the general path has something to say about it. The words of the block count from
/// `zero`, or from where the tool is; `feed`: that of the block, or the lead of a thread.
bool plan_line(MotionView m, const NcWords& words, MoveKind kind, const Axes* zero, double feed,
               PlainLine& line);
/// Makes the move, under the modes that are in force.
void go_along(const MotionFacts& facts, MotionState& s, const PlainLine& line, MoveKind kind,
              std::uint32_t step, Moves* moves);

/// What absolute words count from.
inline constexpr Axes kOrigin{};

}  // namespace cncsub
