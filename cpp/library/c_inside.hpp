// What the handles of the C face hold, and what its functions share.
#pragma once

#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "cncsub/cncsub.h"
#include "cncsub/comparison.hpp"

namespace nc = cncsub::api;

struct cncsub_library {
  nc::Library library;
  std::vector<std::string> programs;
  std::vector<nc::Finding> findings;
};
struct cncsub_options {
  nc::Options options;
};
struct cncsub_run {
  nc::Run run;
  std::optional<nc::Alarm> alarm;
  nc::Step step{};  // what was asked for last
  nc::CallMade call{};
  nc::Path path{};
  std::vector<nc::Variable> variables{};
  std::vector<std::string> messages{};
  std::string waiting{};
};
struct cncsub_machine {
  nc::Machine machine;
  nc::Place next;
  std::vector<nc::Call> stack;
};

namespace cncsub::c_face {

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

inline std::string& last_error() {
  thread_local std::string text;
  return text;
}

/// Keep why a call was refused. Where there is no memory for the text, it is empty.
inline void keep_error(const char* why) noexcept {
  try {
    last_error() = why;
  } catch (...) {
    last_error().clear();
  }
}

template <class Value>
Value refused(const std::string& why, Value value) {
  keep_error(why.c_str());
  return value;
}

/// Do what may throw (memory is missing, a text is too long); return `otherwise` where it does.
template <class Value, class Work>
Value guarded(Value otherwise, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    keep_error("there is no memory left");
  } catch (const std::exception& error) {
    keep_error(error.what());
  } catch (...) {
    keep_error("an unknown exception");
  }
  return otherwise;
}

/// Return whether an argument is NULL that may not be, and say so.
template <class... Pointers>
bool missing(const Pointers*... pointers) {
  if (((pointers != nullptr) && ...)) return false;
  keep_error("an argument is NULL");
  return true;
}

inline std::string text_of(const char* text) { return text == nullptr ? std::string() : text; }

inline cncsub_place place_of(const nc::Place& from) {
  return {from.program.c_str(), from.file.c_str(), from.n.value_or(-1), from.line};
}
inline cncsub_call call_of(const nc::Call& from) {
  return {place_of(from.at), from.kind.c_str(), from.called.c_str(), from.repeat, from.repeats};
}
inline std::optional<double> value_of(double value) {
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

inline nc::Options options_of(const cncsub_options* options) {
  return options == nullptr ? nc::Options() : options->options;
}

}  // namespace cncsub::c_face
