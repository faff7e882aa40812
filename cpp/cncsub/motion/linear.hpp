// The block that must be fast: G00 or G01 with nothing but X, Y, Z and F.
#pragma once

#include <algorithm>
#include <cmath>

#include "cncsub/motion/fast_path.hpp"
#include "cncsub/motion/motion.hpp"  // NOLINT(misc-header-include-cycle): it ends with this file
#include "cncsub/system/compiler.hpp"

namespace cncsub {

/// Move along one axis if its letter is in the mask, its value next in `values`. Return how far.
CNCSUB_ALWAYS_INLINE inline double travel(ModalState& s, std::uint32_t mask, char axis,
                                          const Cell*& values) {
  double& at = s.work[static_cast<std::size_t>(axis - 'X')];
  const double from = at;
  if ((mask & bit(axis)) != 0) at = (values++)->value * s.unit + (s.incremental ? from : 0);
  return at - from;
}
/// Return how long a rapid takes whose axes go at their own rates.
inline double rapid_seconds(const ModalState& s, double dx, double dy, double dz) {
  const auto& each = s.rapid_seconds;
  return std::max(std::max(std::fabs(dx) * each[0], std::fabs(dy) * each[1]),
                  std::fabs(dz) * each[2]);
}
/// Return how long a line takes. A line without length takes no time, also where the spindle
/// stands.
inline double feed_seconds(const ModalState& s, double dx, double dy, double dz) {
  return std::sqrt(dx * dx * s.x_share + dy * dy + dz * dz) * s.seconds_per_mm;
}

inline bool Motion::linear(std::uint32_t mask, const Cell* values, int g, std::uint32_t step,
                           Moves* moves, bool& moved) {
  MotionState& s = now();
  const int code = g >= 0 ? g : s.motion_code;
  if (!s.plain || code > 1) return false;
  const bool has_feed = (mask & bit('F')) != 0;
  if (has_feed ? !(values->value > 0) : (code != 0 && !(s.feed > 0))) return false;
  if (code != s.motion_code) take_code(*facts_, s, code);
  if (has_feed) take_feed(s, (values++)->value);

  if (moves != nullptr && s.row_moves != moves) begin_row_state(*facts_, s, *moves);

  const double dx = travel(s, mask, 'X', values), dy = travel(s, mask, 'Y', values),
               dz = travel(s, mask, 'Z', values);
  moved = std::fabs(dx) + std::fabs(dy) + std::fabs(dz) >= kStanding;
  if (moved) s.time += code == 0 ? rapid_seconds(s, dx, dy, dz) : feed_seconds(s, dx, dy, dz);
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
