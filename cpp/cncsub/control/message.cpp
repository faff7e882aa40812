// Writes the alarm as people read it.
#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control/alarm.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

/// Return how many bytes of UTF-8 here are a character that a terminal obeys instead of showing it:
/// a control character (U+0000 to U+001F, U+007F to U+009F) or one that turns the line's direction.
std::size_t obeyed(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  if (byte(0) < 0x20 || byte(0) == 0x7f) return 1;
  if (byte(0) == 0xc2 && byte(1) >= 0x80 && byte(1) <= 0x9f) return 2;
  const unsigned pair = byte(1) << 8 | byte(2);
  const bool turns = (pair >= 0x808e && pair <= 0x808f) || (pair >= 0x80a8 && pair <= 0x80ae) ||
                     (pair >= 0x81a6 && pair <= 0x81a9);
  return byte(0) == 0xe2 && turns ? 3 : 0;
}

std::string without_controls(const std::string& text) {
  std::string clean;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t bytes = obeyed(std::string_view(text).substr(i));
    if (bytes == 0)
      clean += text[i];
    else if (text[i] == '\t' || text[i] == '\0')
      clean += ' ';
    i += std::max<std::size_t>(bytes, 1);
  }
  return clean;
}

std::string place(const std::string& program, std::int64_t n) {
  const std::string name = without_controls(program);
  return n < 0 ? name : name + " N" + std::to_string(n);
}

constexpr std::size_t kLongestLine = 160;  // characters of the source that are shown
constexpr std::size_t kBefore = 80;        // of them before the word, where the line is longer

/// Return the line with the word marked below it; of a long line the part around the word.
std::string marked(const Alarm& alarm) {
  std::vector<std::string> characters;
  const std::string_view line = alarm.source_line;
  for (std::size_t i = 0; i < line.size();) {
    const std::size_t control = obeyed(line.substr(i));
    const std::string_view character = first_character(line.substr(i));
    characters.emplace_back(control == 0 ? character : " ");
    i += character.size();
  }
  const std::size_t at = alarm.column - 1;
  if (characters.empty() || at > characters.size()) return "";
  const bool cut = characters.size() > kLongestLine;
  const std::size_t from = cut && at > kBefore ? at - kBefore : 0;
  const std::size_t to = cut ? std::min(from + kLongestLine, characters.size()) : characters.size();
  std::string shown = from > 0 ? "..." : "";
  const std::size_t mark = shown.size() + at - from;
  for (std::size_t i = from; i < to; ++i) shown += characters[i];
  if (to < characters.size()) shown += "...";
  const std::size_t width = std::clamp<std::size_t>(to - at, 1, alarm.width);
  return "\n   | " + shown + "\n   | " + std::string(mark, ' ') + std::string(width, '^');
}

}  // namespace

std::string message(const Alarm& alarm) {
  const std::string slug(info(alarm.cause).slug);
  std::string text = alarm.number.empty() ? slug : alarm.number + " " + slug;
  text += ": " + (alarm.detail.empty() ? std::string(info(alarm.cause).meaning)
                                       : without_controls(alarm.detail));
  text += "\n  --> " + place(alarm.program, alarm.n) + ", " + without_controls(alarm.file) + ":" +
          std::to_string(alarm.line) + ":" + std::to_string(alarm.column);
  text += marked(alarm);
  for (const Frame& frame : alarm.frames) {
    text += "\ncalled from " + place(frame.program, frame.n) + " (" + frame.kind;
    if (frame.repeats > 1)
      text += ", pass " + std::to_string(frame.repeat) + " of " + std::to_string(frame.repeats);
    text += "), " + without_controls(frame.file) + ":" + std::to_string(frame.line);
  }
  return text;
}

}  // namespace cncsub
