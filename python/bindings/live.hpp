// A machine as Python holds it, and what it recorded. A machine is used by one thread at a time: it
// works without the GIL, and whoever looks at it meanwhile gets an error instead of half a row.
#pragma once

#include <atomic>
#include <memory>
#include <stdexcept>
#include <utility>

#include "cncsub/machine.hpp"

namespace cncsub::bindings {

struct Live {
  template <class... Values>
  explicit Live(Values&&... values) : machine(std::forward<Values>(values)...) {}

  Machine machine;
  std::atomic<bool> busy = false;
};

/// The machine for as long as this lives.
class Use {
 public:
  explicit Use(Live& live) : live_(live) {
    if (live.busy.exchange(true))
      throw std::runtime_error("the machine is at work in another thread; use a copy of it there");
  }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;
  ~Use() { live_.busy = false; }

  Machine& operator*() const { return live_.machine; }
  Machine* operator->() const { return &live_.machine; }

 private:
  Live& live_;
};

/// What was recorded: by a machine, which may go on, or in one part of a stream.
class Record {
 public:
  explicit Record(std::shared_ptr<Live> live)
      : code_(live->machine.shared_code()),
        trace_(live, &live->machine.trace()),
        live_(std::move(live)) {}
  Record(std::shared_ptr<const Code> code, Trace trace)
      : code_(std::move(code)), trace_(std::make_shared<const Trace>(std::move(trace))) {}

  const Code& code() const { return *code_; }
  const Trace& trace() const { return *trace_; }
  /// Seconds of all moves.
  double time() const {
    const Reading reading(*this);
    return live_ ? live_->machine.motion().time() : trace_->moves.time();
  }

  /// Nothing is recorded while this lives.
  class Reading {
   public:
    explicit Reading(const Record& record) {
      if (record.live_) use_.emplace(*record.live_);
    }

   private:
    std::optional<Use> use_;
  };

 private:
  std::shared_ptr<const Code> code_;
  std::shared_ptr<const Trace> trace_;
  std::shared_ptr<Live> live_;
};

}  // namespace cncsub::bindings
