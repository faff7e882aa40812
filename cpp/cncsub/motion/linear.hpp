// The block that must be fast: G00 or G01 with nothing but X, Y, Z and F.
#pragma once

#include <algorithm>
#include <cmath>

#include "cncsub/motion/motion.hpp"  // NOLINT(misc-header-include-cycle): it ends with this file

namespace cncsub {

inline bool Motion::linear(std::uint32_t mask, const Cell* values, int g, std::uint32_t step,
                           Moves* moves, bool& moved) {
  MotionState& s = state_;
  const int code = g >= 0 ? g : s.motion_code;
  if (!s.plain || code > 1) return false;
  const bool has_feed = (mask & bit('F')) != 0;
  if (has_feed ? !(values->value > 0) : (code != 0 && !(s.feed > 0))) return false;
  if (code != s.motion_code) take_code(code);
  if (has_feed) take_feed((values++)->value);

  if (moves != nullptr && s.row_moves != moves) new_row_state(*moves);

  const double unit = s.unit;
  const auto travel = [&](char axis, double& at) {
    const double from = at;
    if ((mask & bit(axis)) != 0) at = (values++)->value * unit + (s.incremental ? from : 0);
    return at - from;
  };
  const double dx = travel('X', s.work[0]), dy = travel('Y', s.work[1]),
               dz = travel('Z', s.work[2]);
  moved = dx != 0 || dy != 0 || dz != 0;
  if (code == 0)
    s.time +=
        std::max(std::max(std::fabs(dx) * s.rapid_seconds[0], std::fabs(dy) * s.rapid_seconds[1]),
                 std::fabs(dz) * s.rapid_seconds[2]);
  else if (moved)  // what stands takes no time, also where the spindle stands
    s.time += std::sqrt(dx * dx * s.half[0] + dy * dy + dz * dz) * s.seconds_per_mm;
  const std::uint32_t axes = straight_axes(mask);
  if (axes == 0) return true;
  s.moved_before = true;
  s.named |= axes;
  if (moves == nullptr) return true;
  moves->mark(axes);
  moves->push(step, code != 0 ? MoveKind::Feed : MoveKind::Rapid, s.work, s.row_state);
  return true;
}

}  // namespace cncsub
