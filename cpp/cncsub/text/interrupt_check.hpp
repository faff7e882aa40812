// The interruption of work on texts of any size.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <utility>

namespace cncsub {

/// The check that asks now and then, while work is done, whether somebody wants it interrupted.
class InterruptCheck {
 public:
  static constexpr std::size_t kBlock = 8;       // the work of going over a block again, in bytes
  static constexpr std::size_t kLook = 1 << 16;  // bytes after which the clock is read

  explicit InterruptCheck(std::function<bool()> interrupted = {})
      : interrupted_(std::move(interrupted)) {}

  /// Return whether the work is to stop; `bytes` of text were worked on since the last question.
  bool requested(std::size_t bytes) {
    worked_ += bytes;
    if (worked_ < kLook || !interrupted_ || requested_) return requested_;
    worked_ = 0;
    const auto now = Clock::now();
    if (now - asked_ < kBetweenQuestions) return false;
    requested_ = interrupted_();
    asked_ = Clock::now();
    return requested_;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::milliseconds kBetweenQuestions{20};

  std::function<bool()> interrupted_;
  std::size_t worked_ = 0;
  Clock::time_point asked_ = Clock::now();
  bool requested_ = false;
};

}  // namespace cncsub
