// Comments: messages, and what a program prints.
#include "cncsub/dialect/grblhal/block.hpp"
#include "cncsub/dialect/ngc_lines.hpp"

namespace cncsub::grblhal {

namespace {

constexpr std::int32_t kMessageSwitch = 5599;           // (DEBUG,...) shows nothing while it is 0
constexpr NgcFormat kFormat{.decimals = 3, .of_f = 3};  // [gHx, get_format]

}  // namespace

/// Read a comment. Of several comments of a line the first that says something counts.
bool BlockReader::comment(Block& /*block*/, Words& words) {
  const std::uint32_t at = line_.offset();
  std::string text;
  if (!line_.take_up_to(')', text)) {  // it ends with the line
    while (!line_.at_end()) line_.take();
    return true;
  }
  std::string_view said = text;
  if (words.print) return true;
  if (ngc_take_word(said, "MSG,")) {
    while (!said.empty() && said.front() == ' ') said.remove_prefix(1);
    words.print.emplace();
    words.print->fields.push_back({.text = std::string(said)});
  } else if (ngc_take_word(said, "DEBUG,")) {
    message(said, at, words.print.emplace());
    words.print->shown_if = kMessageSwitch;
  } else if (ngc_take_word(said, "PRINT,")) {
    message(said, at, words.print.emplace());
  } else if (ngc_take_word(said, "ABORT,")) {
    message(said, at, words.print.emplace());
    words.print->alarms = true;
  }
  if (words.print) words.print->at = at;
  return true;
}

/// Write a message into `print`: `#5` and `#<name>` in it stand for their values.
void BlockReader::message(std::string_view text, std::uint32_t at, Print& print) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  ngc_message(to_, line_, expression_, kFormat, text, at, print);
  expression_.fault.reset();
}

}  // namespace cncsub::grblhal
