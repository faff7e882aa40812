// The limits of a run: time, memory, and whoever stops it.
#include <algorithm>

#include "cncsub/machine.hpp"

namespace cncsub {

namespace {

constexpr std::int64_t kLookBlocks = 1 << 14;   // blocks between two looks around, at most
constexpr std::int64_t kLookMoves = 1 << 16;    // or moves
constexpr std::int64_t kFewest = 1 << 6;        // where memory is nearly used up
constexpr std::uint64_t kBlockBytes = 1 << 10;  // that a block hardly records more than
constexpr std::uint64_t kMoveBytes = 1 << 7;
constexpr double kAskSeconds = 0.02;      // between two questions whether to stop, which may wait
constexpr std::uint64_t kNodeBytes = 64;  // of a map

}  // namespace

Machine::AtWork::AtWork(Machine& of, const std::function<bool()>& interrupted) : machine(of) {
  machine.interrupted_ = &interrupted;
  machine.broken_off_ = Stop::Running;
  machine.begun_ = Clock::now();
  machine.asked_ = machine.spent_;
}

Machine::AtWork::~AtWork() {
  machine.spent_ += std::chrono::duration<double>(Clock::now() - machine.begun_).count();
  machine.interrupted_ = nullptr;
}

Stop Machine::stops() {
  const double seconds = spent_ + std::chrono::duration<double>(Clock::now() - begun_).count();
  if (*interrupted_ && seconds - asked_ > kAskSeconds) {
    asked_ = seconds;
    if ((*interrupted_)()) return Stop::Interrupted;
  }
  const bool late = options_.max_seconds > 0 && seconds > options_.max_seconds;
  return late || memory() > options_.max_memory ? Stop::Limit : Stop::Running;
}

bool Machine::breaks_off() {
  broken_off_ = stops();
  if (broken_off_ == Stop::Running) return false;
  give_back();
  look_soon();
  return true;
}

/// When the run looks around again: the sooner, the less memory is left.
void Machine::look_later(std::int64_t last) {
  const std::uint64_t left = options_.max_memory - std::min(memory(), options_.max_memory);
  const auto many = [left](std::uint64_t bytes, std::int64_t most) {
    const std::uint64_t fit = std::min(left / bytes, static_cast<std::uint64_t>(most));
    return std::max(kFewest, static_cast<std::int64_t>(fit));
  };
  look_at_ = std::min(executed_ + many(kBlockBytes, kLookBlocks), last);
  look_moves_ = many(kMoveBytes, kLookMoves);
  moves_ = 0;
}

/// What was recorded, and the state that grows with what a program does.
std::uint64_t Machine::memory() const {
  const auto locals = static_cast<std::size_t>(code_->locals) * sizeof(double);
  return trace_.bytes() + motion_.held_bytes() + in_block_ +
         (stack_.size() - 1) * (sizeof(Open) + sizeof(Frame)) +
         static_cast<std::size_t>(level_) * locals + modals_.size() * (sizeof(Modal) + locals) +
         waiting_.size() * sizeof(waiting_[0]) + loops_.size() * sizeof(Address) +
         (system_.size() + names_.size()) * kNodeBytes + commons_.size() * sizeof(double);
}

}  // namespace cncsub
