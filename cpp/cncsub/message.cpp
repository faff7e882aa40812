// The alarm as people read it.
#include <string>

#include "cncsub/alarm.hpp"

namespace cncsub {

namespace {

std::string place(const std::string& program, std::int64_t n) {
  return n < 0 ? program : program + " N" + std::to_string(n);
}

std::string without_controls(const std::string& text) {
  std::string clean;
  for (const char c : text)
    if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f)
      clean += c;
    else if (c == '\t' || c == '\0')
      clean += ' ';
  return clean;
}

constexpr std::size_t kLongestLine = 160;  // of the source, as shown

}  // namespace

std::string message(const Alarm& alarm) {
  const std::string slug(info(alarm.cause).slug);
  std::string text = alarm.number.empty() ? slug : alarm.number + " " + slug;
  text += ": " + (alarm.detail.empty() ? std::string(info(alarm.cause).meaning)
                                       : without_controls(alarm.detail));
  text += "\n  --> " + place(alarm.program, alarm.n) + ", " + alarm.file + ":" +
          std::to_string(alarm.line) + ":" + std::to_string(alarm.column);
  std::string line = without_controls(alarm.source_line);
  if (!line.empty() && line.size() <= kLongestLine) {
    text += "\n   | " + line;
    text += "\n   | " + std::string(alarm.column - 1, ' ') + std::string(alarm.width, '^');
  }
  for (const Frame& frame : alarm.frames) {
    text += "\ncalled from " + place(frame.program, frame.n) + " (" + frame.kind;
    if (frame.repeats > 1)
      text += ", pass " + std::to_string(frame.repeat) + " of " + std::to_string(frame.repeats);
    text += "), " + frame.file + ":" + std::to_string(frame.line);
  }
  return text;
}

}  // namespace cncsub
