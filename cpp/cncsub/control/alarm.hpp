// What stops a program on a control, as a value.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cncsub {

enum class Cause : std::uint16_t {
#define CAUSE(name, slug, meaning, cure) name,
#include "cncsub/control/causes.def"
#undef CAUSE
};

struct CauseInfo {
  std::string_view name;     // "ProgramNotFound"
  std::string_view slug;     // "program-not-found"
  std::string_view meaning;  // what happened
  std::string_view cure;     // how to mend it
};

/// Return every cause, in the order of the enumeration.
const std::vector<CauseInfo>& all_causes();
inline const CauseInfo& info(Cause cause) { return all_causes()[static_cast<std::size_t>(cause)]; }

/// One open call, seen from where it was made.
struct Frame {
  std::string program;  // the calling program
  std::int64_t n = -1;  // its block, -1 where it has no sequence number
  std::uint32_t line = 0;
  std::string file;
  std::string kind;    // "M98", "G65", "M-code" ...
  std::string called;  // the called program
  std::int64_t repeat = 1;
  std::int64_t repeats = 1;

  bool operator==(const Frame&) const = default;
};

constexpr std::size_t kLongestSource = 4096;  // bytes of a line that an alarm shows

struct Alarm {
  Cause cause{};
  std::string number;  // the control's number; empty where no source gives one
  std::string text;    // the control's text; empty where no source gives one
  std::string program;
  std::int64_t n = -1;
  std::uint32_t line = 0;
  std::uint32_t column = 0;  // 1-based, in characters of the line
  std::uint32_t width = 1;   // characters under the caret
  std::string word;
  std::string file;
  std::string detail;
  std::string source_line;    // the text of the line
  std::vector<Frame> frames;  // innermost first

  bool operator==(const Alarm&) const = default;
};

/// Return the message for people: what, where, the line with a caret, and the callers.
std::string message(const Alarm& alarm);

}  // namespace cncsub
