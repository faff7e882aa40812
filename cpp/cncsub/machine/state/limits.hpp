// The limits of a run: time, memory, and whoever stops it.
#pragma once

#include <cstdint>
#include <functional>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// The run is at work for as long as this lives: its time counts, and it asks `interrupted`.
class AtWork {
 public:
  AtWork(Run& run, const std::function<bool()>& interrupted);
  AtWork(const AtWork&) = delete;
  AtWork& operator=(const AtWork&) = delete;
  ~AtWork();

 private:
  Watch& watch_;
};

/// Why the run is to stop now, if it is: asked between blocks, and inside those that take long.
Stop stops(Run& run);
/// Whether to break off the running block, which then has done nothing.
bool breaks_off(Run& run);

constexpr std::uint32_t kLongText = 1000;  // of a block or an expression that takes long
/// A block that did the work of many: time, memory and Ctrl-C are asked about soon.
inline void look_soon(Run& run) { run.watch.look_at = 0; }
/// When the run looks around again, at the latest when `last` blocks are executed.
void look_later(Run& run, std::int64_t last);

/// Bytes of what was recorded, and of the state that grows with what a program does.
std::uint64_t memory(const Run& run);

}  // namespace cncsub
