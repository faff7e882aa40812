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
/// `zero`, or from where the tool is; `feed`: that of the block.
bool plan_line(MotionView m, const NcWords& words, bool rapid, const Axes* zero, double feed,
               PlainLine& line);

/// What absolute words count from.
inline constexpr Axes kOrigin{};

}  // namespace cncsub
