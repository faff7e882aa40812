#include "cncsub/machine/state/limits.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "cncsub/machine/state/stop.hpp"

namespace cncsub {

namespace {

constexpr std::int64_t kLookBlocks = 1 << 14;   // blocks between two looks, at most
constexpr std::int64_t kLookMoves = 1 << 16;    // or moves
constexpr std::int64_t kFewest = 1 << 6;        // where memory is nearly used up
constexpr std::uint64_t kBlockBytes = 1 << 10;  // that a block hardly records more than
constexpr std::uint64_t kMoveBytes = 1 << 7;
constexpr double kAskSeconds = 0.02;      // between two questions whether to stop, which may wait
constexpr std::uint64_t kNodeBytes = 64;  // of a map

double seconds_since(Watch::Clock::time_point begun) {
  return std::chrono::duration<double>(Watch::Clock::now() - begun).count();
}

}  // namespace

AtWork::AtWork(Run& run, const std::function<bool()>& interrupted) : watch_(run.watch) {
  watch_.interrupted = &interrupted;
  watch_.broken_off = Stop::Running;
  watch_.begun = Watch::Clock::now();
  watch_.asked = watch_.spent;
}

AtWork::~AtWork() {
  watch_.spent += seconds_since(watch_.begun);
  watch_.interrupted = nullptr;
  watch_.marked = nullptr;
}

LiftedLimits::LiftedLimits(Run& run)
    : run_(run),
      seconds_(std::exchange(run.options.max_seconds, 0)),
      spent_(run.watch.spent),
      memory_(std::exchange(run.options.max_memory, std::numeric_limits<std::uint64_t>::max())) {}

LiftedLimits::~LiftedLimits() {
  run_.options.max_seconds = seconds_;
  run_.options.max_memory = memory_;
  run_.watch.spent = spent_;
}

Stop stops(Run& run) {
  Watch& watch = run.watch;
  const double seconds = watch.spent + seconds_since(watch.begun);
  if (*watch.interrupted && seconds - watch.asked > kAskSeconds) {
    watch.asked = seconds;
    if ((*watch.interrupted)()) return Stop::Interrupted;
  }
  const bool late = run.options.max_seconds > 0 && seconds > run.options.max_seconds;
  return late || memory(run) > run.options.max_memory ? Stop::Limit : Stop::Running;
}

bool breaks_off(Run& run) {
  run.watch.broken_off = stops(run);
  if (run.watch.broken_off == Stop::Running) return false;
  rollback(run);
  look_soon(run);
  return true;
}

// The run looks the sooner, the less memory is left.
void look_later(Run& run, std::int64_t last) {
  const std::uint64_t left = run.options.max_memory - std::min(memory(run), run.options.max_memory);
  const auto many = [left](std::uint64_t bytes, std::int64_t most) {
    const std::uint64_t fit = std::min(left / bytes, static_cast<std::uint64_t>(most));
    return std::max(kFewest, static_cast<std::int64_t>(fit));
  };
  const std::uint64_t block = kBlockBytes + run.watched.places.size() * sizeof(Trace::Change);
  run.watch.look_at = std::min(run.state.executed + many(block, kLookBlocks), last);
  run.watch.look_moves = many(kMoveBytes, kLookMoves);
  run.watch.moves = 0;
}

std::uint64_t memory(const Run& run) {
  const State& s = run.state;
  const auto locals = static_cast<std::size_t>(run.code->locals) * sizeof(double);
  const auto elements = static_cast<std::size_t>(run.code->elements) * sizeof(double);
  return run.trace.bytes() + held_bytes(run.motion.state()) + run.watch.in_block +
         (s.frames.size() - 1) * (sizeof(OpenFrame) + sizeof(Frame)) +
         static_cast<std::size_t>(s.level) * (locals + elements) + s.texts.bytes() +
         s.frame_values.bytes() + s.copies.size() * sizeof(double) +
         s.modals.size() * (sizeof(ModalCall) + locals) + s.waiting.size() * sizeof(WaitingBlock) +
         s.loops.size() * sizeof(OpenLoop) + (s.system.size() + s.names.size()) * kNodeBytes +
         s.commons.size() * sizeof(double);
}

}  // namespace cncsub
