// A machine that Python holds, and what it recorded. It runs without the GIL. A caller that reads
// it meanwhile gets an error instead of half a row; many may read one that is at rest.
#pragma once

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "cncsub/machine/machine.hpp"
#include "gil.hpp"

namespace cncsub::bindings {

struct Live {
  template <class... Values>
  explicit Live(Values&&... values) : machine(std::forward<Values>(values)...) {}

  Machine machine;
  std::atomic<int> lookers = 0;  // how many read the machine; kAtWork: it changes
  static constexpr int kAtWork = -1;
  // Another thread asked the run that is under way, or the next one, to pause: for a moment, or for
  // good. Going back is worth a pause for good only.
  enum Pause : int { kNone, kMoment, kForGood };
  std::atomic<int> pause = kNone;

  /// Return its code, which may be asked for while the machine is at work.
  std::shared_ptr<const Code> code() const {
    const std::lock_guard lock(code_mutex_);
    return code_;
  }
  /// Return whether it runs this code, or ran it before it got more.
  bool has_run(const Code& code) const {
    const std::lock_guard lock(code_mutex_);
    const auto is_it = [&code](const auto& of) { return of.lock().get() == &code; };
    return code_.get() == &code || std::any_of(earlier_.begin(), earlier_.end(), is_it);
  }
  /// Note that the machine, which is at work for the caller, has got more code.
  void got_more_code() {
    const std::lock_guard lock(code_mutex_);
    earlier_.emplace_back(std::exchange(code_, machine.shared_code()));
  }

 private:
  mutable std::mutex code_mutex_;
  std::shared_ptr<const Code> code_ = machine.shared_code();
  std::vector<std::weak_ptr<const Code>> earlier_;
};

/// Exclusive access to the machine, to change it.
class Work {
 public:
  explicit Work(Live& live) : live_(live) {
    int none = 0;
    if (!live.lookers.compare_exchange_strong(none, Live::kAtWork))
      throw std::runtime_error("the machine is in use in another thread; use a copy of it there");
  }
  Work(const Work&) = delete;
  Work& operator=(const Work&) = delete;
  ~Work() { live_.lookers = 0; }

  Machine& operator*() const { return live_.machine; }
  Machine* operator->() const { return &live_.machine; }

 private:
  Live& live_;
};

/// Access to the machine at rest: nobody changes it meanwhile.
class Look {
 public:
  explicit Look(Live& live) : live_(live) {
    int lookers = live.lookers;
    do {
      if (lookers == Live::kAtWork)
        throw std::runtime_error(
            "the machine is at work in another thread; use a copy of it there");
    } while (!live.lookers.compare_exchange_weak(lookers, lookers + 1));
  }
  Look(const Look&) = delete;
  Look& operator=(const Look&) = delete;
  ~Look() { --live_.lookers; }

  const Machine& operator*() const { return live_.machine; }
  const Machine* operator->() const { return &live_.machine; }

 private:
  Live& live_;
};

/// Run a machine without the GIL. What the job gets takes the GIL now and then to let Ctrl-C in,
/// which ends the job, and asks whether another thread wants it to pause. An exception that another
/// signal's handler raises is passed on. Return whether it was to pause.
template <class Job>
bool with_signals(Live& live, Job&& job) {
  std::optional<pybind11::error_already_set> other;
  bool paused = false;
  {
    GilRelease away;
    const auto interrupted = [&] {
      if (live.pause.exchange(Live::kNone) != Live::kNone) return paused = true;
      if (PyErr_CheckSignals() == 0) return false;
      if (PyErr_ExceptionMatches(PyExc_KeyboardInterrupt) != 0)
        PyErr_Clear();
      else
        other.emplace();
      return true;
    };
    std::forward<Job>(job)(std::function<bool()>([&] { return away.ask(interrupted); }));
  }
  if (other) throw std::move(*other);
  return paused;
}

using MachineClass = pybind11::class_<Live, std::shared_ptr<Live>>;
/// Add breakpoints, the way back and expressions to the machine.
void add_debugging(MachineClass& machine);

/// The record of a machine, which may go on, or of one part of a stream.
class Record {
 public:
  explicit Record(std::shared_ptr<Live> live)
      : trace_(live, &live->machine.trace()), live_(std::move(live)) {}
  Record(std::shared_ptr<const Code> code, Trace trace)
      : code_(std::move(code)), trace_(std::make_shared<const Trace>(std::move(trace))) {}

  /// Return the code as it is now: a machine gets another one where blocks are typed in.
  std::shared_ptr<const Code> code() const { return live_ ? live_->code() : code_; }
  const Trace& trace() const { return *trace_; }
  /// Return the seconds of all moves.
  double time() const {
    const Reading reading(*this);
    if (live_) return live_->machine.motion().time();
    double time = 0;
    work_away([&](InterruptCheck& interrupt) { time = trace_->moves.time(&interrupt); });
    return time;
  }

  /// A scope in which nothing is recorded.
  class Reading {
   public:
    explicit Reading(const Record& record) {
      if (record.live_) look_.emplace(*record.live_);
    }

   private:
    std::optional<Look> look_;
  };

 private:
  std::shared_ptr<const Code> code_;  // of a part; that of a machine is asked for
  std::shared_ptr<const Trace> trace_;
  std::shared_ptr<Live> live_;
};

}  // namespace cncsub::bindings
