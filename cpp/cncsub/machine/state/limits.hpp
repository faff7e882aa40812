// The limits of a run: time, memory, and whoever stops it.
#pragma once

#include <cstdint>
#include <functional>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// The time that a run is at work. As long as this lives, time counts, and the run asks
/// `interrupted`.
class AtWork {
 public:
  AtWork(Run& run, const std::function<bool()>& interrupted);
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;
  ~AtWork();

 private:
  Watch& watch_;
};

/// The limits of time and memory, lifted as long as this lives: a stretch runs again for which they
/// counted before.
class LiftedLimits {
 public:
  explicit LiftedLimits(Run& run);
  LiftedLimits(const LiftedLimits&) = delete;
  LiftedLimits& operator=(const LiftedLimits&) = delete;
  ~LiftedLimits();

 private:
  Run& run_;
  double seconds_, spent_;
  std::uint64_t memory_;
};

/// Return why the run is to stop now, if it is. Asked between blocks, and inside those that take
/// long.
Stop stops(Run& run);
/// Return whether to break off the running block, which then has done nothing.
bool breaks_off(Run& run);

constexpr std::uint32_t kLongText = 1000;  // of a block or an expression that takes long
/// Make the run look soon at time, memory and Ctrl-C, after a block that did the work of many.
inline void look_soon(Run& run) { run.watch.look_at = 0; }
/// Set when the run looks again, at the latest when `last` blocks are executed.
void look_later(Run& run, std::int64_t last);

/// Return the bytes of what was recorded, and of the state that grows with what a program does.
std::uint64_t memory(const Run& run);

}  // namespace cncsub
