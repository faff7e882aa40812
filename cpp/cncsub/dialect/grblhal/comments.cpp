// Comments: messages, and what a program prints.
#include <algorithm>
#include <utility>

#include "cncsub/dialect/grblhal/block.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub::grblhal {

namespace {

constexpr std::int32_t kMessageSwitch = 5599;  // (DEBUG,...) shows nothing while it is 0
constexpr int kDecimals = 3;                   // of a value that is shown

/// Take %d, %f or %.3f, and return how many decimals the values after it have. Any other text
/// stays. [gHx, get_format]
int take_format(std::string_view& text, std::string& plain, int decimals) {
  const auto at = [&text](std::size_t place) { return place < text.size() ? text[place] : '\0'; };
  if (at(1) == 'd' || at(1) == 'f') {
    decimals = at(1) == 'd' ? 0 : kDecimals;
    text.remove_prefix(2);
  } else if (at(1) == '.' && is_digit(at(2)) && at(3) == 'f') {
    decimals = at(2) - '0';
    text.remove_prefix(4);
  } else {
    plain += '%';
    text.remove_prefix(1);
  }
  return decimals;
}

/// Take a word in capitals or not from the head of a text.
bool take_word(std::string_view& text, std::string_view word) {
  const bool same =
      text.size() >= word.size() && std::equal(word.begin(), word.end(), text.begin(),
                                               [](char a, char b) { return a == upper(b); });
  if (same) text.remove_prefix(word.size());
  return same;
}

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
  if (take_word(said, "MSG,")) {
    while (!said.empty() && said.front() == ' ') said.remove_prefix(1);
    words.print.emplace();
    words.print->fields.push_back({.text = std::string(said)});
  } else if (take_word(said, "DEBUG,")) {
    message(said, at, words.print.emplace());
    words.print->shown_if = kMessageSwitch;
  } else if (take_word(said, "PRINT,")) {
    message(said, at, words.print.emplace());
  } else if (take_word(said, "ABORT,")) {
    message(said, at, words.print.emplace());
    words.print->alarms = true;
  }
  if (words.print) words.print->at = at;
  return true;
}

/// Write a message into `print`: `#5` and `#<name>` in it stand for their values.
void BlockReader::message(std::string_view text, std::uint32_t at, Print& print) {
  std::string plain;
  int decimals = kDecimals;
  const BareLine kept = line_;
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty()) {
    if (text.front() == '%') {
      decimals = take_format(text, plain, decimals);
      continue;
    }
    const bool names = text.size() > 1 && (text[1] == '<' || is_digit(text[1]));
    Value value;
    if (text.front() == '#' && names) line_.set(text.substr(1), at);
    if (text.front() != '#' || !names || !expression_.shown(value)) {
      plain += text.front();
      text.remove_prefix(1);
      continue;
    }
    if (!plain.empty()) print.fields.push_back({.text = std::exchange(plain, {})});
    print.fields.push_back({.is_variable = true,
                            .text = {},
                            .expression = to_.expressions().expression_of(value),
                            .whole_digits = PrintField::kPlain,
                            .decimals = decimals});
    text.remove_prefix(std::min<std::size_t>(1 + line_.width_from(at), text.size()));
  }
  if (!plain.empty()) print.fields.push_back({.text = plain});
  line_ = kept;
  expression_.fault.reset();
}

}  // namespace cncsub::grblhal
