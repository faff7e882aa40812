// Work without the GIL.
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <thread>
#include <utility>

#include "cncsub/text/interrupt_check.hpp"

namespace cncsub::bindings {

/// The GIL is given away for as long as this lives.
///
/// When Python ends, a thread of a daemon that wants the GIL back is ended on the spot: with glibc
/// the stack is unwound as by an exception, through functions that throw none and with objects of
/// Python in them. Such a thread sleeps here instead until the process is gone.
class GilRelease {
 public:
  GilRelease() : state_(PyEval_SaveThread()) {}
  GilRelease(const GilRelease&) = delete;
  GilRelease& operator=(const GilRelease&) = delete;
  ~GilRelease() { come_back(); }

  /// Takes the GIL for a question to Python.
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

/// Does what may take long without the GIL; it asks the interrupt it is given. Ctrl-C is let in,
/// and is an exception behind it.
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
