// Work without the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <thread>
#include <utility>

#include "cncsub/text/interrupt_check.hpp"

namespace cncsub::bindings {

/// A scope in which this thread does not hold the GIL.
///
/// When Python ends, it ends a daemon thread at once that wants the GIL back: glibc unwinds the
/// stack as an exception does, through functions that throw none and with objects of Python in
/// them. Such a thread sleeps here instead until the process is gone.
class GilRelease {
 public:
  GilRelease() : state_(PyEval_SaveThread()) {}
  GilRelease(const GilRelease&) = delete;
  GilRelease& operator=(const GilRelease&) = delete;
  ~GilRelease() { come_back(); }

  /// Take the GIL back for one question to Python.
  template <class Question>
  auto ask(Question&& question) {
    come_back();
    const struct Leave {
      GilRelease& away;
      ~Leave() { away.state_ = PyEval_SaveThread(); }
    } leave{*this};
    return std::forward<Question>(question)();
  }

 private:
  void come_back() noexcept {
    try {
      PyEval_RestoreThread(state_);
    } catch (...) {
      for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
    }
  }

  PyThreadState* state_;
};

/// Do long work without the GIL. The job checks the interrupt that it gets. Ctrl-C stops it, and is
/// an exception after it.
template <class Job>
void work_away(Job&& job) {
  {
    GilRelease away;
    InterruptCheck interrupt(
        [&away] { return away.ask([] { return PyErr_CheckSignals() != 0; }); });
    std::forward<Job>(job)(interrupt);
  }
  if (PyErr_Occurred() != nullptr) throw pybind11::error_already_set();
}

}  // namespace cncsub::bindings
