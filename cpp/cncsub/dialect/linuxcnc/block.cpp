// Lines of words, assignments and comments.
#include "cncsub/dialect/linuxcnc/block.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>

#include "cncsub/code/operand_of.hpp"
#include "cncsub/dialect/linuxcnc/codes.hpp"
#include "cncsub/dialect/ngc_lines.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub::linuxcnc {

namespace {

constexpr std::size_t kLongestLine = 253;  // characters [rs274 2.9: 254 are too many]

constexpr std::int32_t kMessageSwitch = 5599;  // (DEBUG,...) shows nothing while it is 0 or below

constexpr int kCycleOff = 800;  // in tenths

/// Return how a character is shown: a byte beyond ASCII is shown by its number. [rs274 2.9]
std::string shown(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte < 0x80) return {c};
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "\\%03o", byte);
  return text.data();
}

/// Let another motion code of the line replace its G80, wherever that stands. Return false if the
/// line has no G80. [rs274 2.9]
bool replace_cycle_off(LineWords& line, WordList& list, int code) {
  const auto found = std::find(line.g.begin(), line.g.end(), kCycleOff);
  if (found == line.g.end()) return false;
  *found = code;
  for (int i = 0; i < list.g_count; ++i)
    if (WordValue& of = list.g[static_cast<std::size_t>(i)]; !of.computed && of.value == kCycleOff)
      of.value = code;
  return true;
}

/// Return the number of the M code that stands here, if it is written as a number.
std::optional<int> plain_m(const Line& line) {
  std::string_view rest = line.rest();
  if (!rest.starts_with('m')) return std::nullopt;
  rest.remove_prefix(1);
  int number = 0;
  const char* const first = rest.begin();
  const char* const end = rest.end();
  const auto read = std::from_chars(first, first + std::min<std::size_t>(rest.size(), 5), number);
  const bool whole = read.ec == std::errc() && (read.ptr == end || *read.ptr != '.');
  return whole ? std::optional<int>(number) : std::nullopt;
}

}  // namespace

bool BlockReader::refuse(Block& block, Cause cause, std::string text, std::uint32_t at) {
  Fault fault{.cause = cause, .at = at, .width = line_.width_from(at), .detail = text};
  fault.text = std::move(text);
  to_.refuse(block, std::move(fault));
  return false;
}

bool BlockReader::refuse(Block& block) {
  if (auto fault = std::exchange(expression_.fault, std::nullopt))
    to_.refuse(block, std::move(*fault));
  return false;
}

bool BlockReader::read(std::string_view text, Block& block, Label& label) {
  line_.set(text, block.text);
  expression_.begin_line();
  expression_.fault.reset();
  const bool unreadable = text.size() > kLongestLine || line_.unclosed() || line_.nested();
  if (unreadable) {
    label.unreadable = true;
    if (text.size() > kLongestLine)
      refuse(block, Cause::BlockTooLong, "Command too long", block.text);
    else if (line_.nested())
      refuse(block, Cause::CommentInComment, "Nested comment found", block.text);
    else
      refuse(block, Cause::CommentNotClosed, "Unclosed comment found", block.text);
    return true;
  }
  if (line_.take('/')) block.skip = 1u << 1;
  if (line_.peek() == 'n' && !number(block)) return true;
  if (line_.at_end()) return block.n >= 0;
  const std::optional<int> m = plain_m(line_);
  const Role role = m ? to_.control().calls.roles.value.of_m(*m) : Role::None;
  if (line_.peek() == 'o')
    o_word(block, label);
  else if (role == Role::Call)
    label.unreadable = !call_98(block, m.value_or(0), label);
  else if (role == Role::Return)
    back_99(block, m.value_or(0), label);
  else
    return words(block);
  return true;
}

bool BlockReader::number(Block& block) {
  const std::uint32_t at = line_.offset();
  line_.take();
  const std::string_view digits = line_.take_digits();
  if (digits.empty())
    return refuse(block, Cause::AddressWithoutValue, "Bad format unsigned integer", at);
  if (digits.size() <= 9) std::from_chars(digits.data(), digits.data() + digits.size(), block.n);
  if (line_.take('.')) line_.take_digits();  // a fraction is read and ignored
  return true;
}

bool BlockReader::words(Block& block) {
  Words words;
  while (!line_.at_end())
    if (!item(block, words)) return true;
  if (!words.any && words.statements.empty() && !words.print && block.n < 0) return false;
  if (!refuse_wrong(block, words.line)) write(block, words);
  return true;
}

/// Refuse a word of the line that is wrong beside the others; return whether there is one.
bool BlockReader::refuse_wrong(Block& block, const LineWords& line) {
  const auto wrong = wrong_word(line);
  if (!wrong) return false;
  const bool named = wrong->letter >= 'a' && wrong->letter <= 'z';
  const auto letter = static_cast<std::size_t>((named ? wrong->letter : 'g') - 'a');
  to_.refuse(block, Fault{.cause = wrong->cause,
                          .at = line.at[letter],
                          .width = line.width[letter],
                          .detail = wrong->text,
                          .text = wrong->text});
  return true;
}

bool BlockReader::item(Block& block, Words& words) {
  const std::uint32_t at = line_.offset();
  const std::string_view character = first_character(line_.rest());
  const char c = line_.take();
  if (c == '(') return comment(block, words);
  if (c == '#') return assignment(block, words);
  if (c == ';') {
    while (!line_.at_end()) line_.take();
    return true;
  }
  if (c >= 'a' && c <= 'z' && c != 'n' && c != 'o') return word(block, words, c);
  if (c == '@' || c == '^') return polar_word(block, words, c);
  if (c == '$') {  // the number of a spindle
    Value value;
    if (!expression_.value(value)) return refuse(block);
    return refuse(block, Cause::CodeNotComputed, std::string(1, c) + " is not computed by cncsub",
                  at);
  }
  line_.take(character.substr(1));
  return refuse(block, Cause::IllegalCharacter, "Bad character '" + shown(c) + "' used", at);
}

/// Read @ or ^: the radius or the angle of a point.
bool BlockReader::polar_word(Block& block, Words& words, char sign) {
  const std::uint32_t at = line_.offset(line_.place() - 1);
  Value value;
  words.any = true;
  if (!words.line.add(sign))
    return refuse(block, Cause::AddressGivenTwice,
                  std::string("Multiple ") + sign + " words on one line", at);
  if (!expression_.value(value)) return refuse(block);
  words.list.set(sign == '@' ? kRadius : kAngle, word_of(value), false);
  return true;
}

bool BlockReader::word(Block& block, Words& words, char letter) {
  const std::uint32_t at = line_.offset(line_.place() - 1);
  Value value;
  words.any = true;
  const bool code = letter == 'g' || letter == 'm';
  if (!code && !words.line.add(letter))
    return refuse(block, Cause::AddressGivenTwice,
                  std::string("Multiple ") + letter + " words on one line", at);
  constexpr std::string_view kWhole = "hlmt";
  const bool whole = kWhole.find(letter) != std::string_view::npos;
  if (!(whole ? expression_.whole(value) : expression_.value(value))) return refuse(block);
  value.at = at;
  value.width = line_.width_from(at);
  if (letter == 'g') return g_code(block, words, value);
  if (letter == 'm') return m_code(block, words, value);
  words.line.at[static_cast<std::size_t>(letter - 'a')] = at;
  words.line.width[static_cast<std::size_t>(letter - 'a')] = value.width;
  words.line.values[static_cast<std::size_t>(letter - 'a')] =
      value.computed ? std::nullopt : std::optional(value.number);
  words.list.set(letter - 'a', word_of(value), false);
  return true;
}

bool BlockReader::g_code(Block& block, Words& words, const Value& value) {
  words.line.computed = words.line.computed || value.computed;
  words.line.at['g' - 'a'] = value.at;
  words.line.width['g' - 'a'] = value.width;
  if (value.computed) {
    if (words.list.g_count < static_cast<int>(kGCodesOfBlock)) words.list.add_g(word_of(value));
    return true;
  }
  const double tens = value.number * 10;
  const double low = std::floor(tens);
  if (tens < 0) return refuse(block, Cause::GCodeNotAvailable, "Negative g code used", value.at);
  if ((tens - low > 0.001 && tens - low <= 0.999) || low > 999)
    return refuse(block, Cause::GCodeNotAvailable, "G-code out of range", value.at);
  const int code = to_whole<int>(tens - low > 0.999 ? low + 1 : low);
  const int group = group_of_g(code);
  if (group < 0) return refuse(block, Cause::GCodeNotAvailable, "Unknown g code used", value.at);
  if (words.g_groups[static_cast<std::size_t>(group)]) {
    const bool motion = group == group_of_g(kCycleOff);
    if (motion && code == kCycleOff) return true;
    if (!motion || !replace_cycle_off(words.line, words.list, code))
      return refuse(block, Cause::AddressGivenTwice, "Two g codes used from same modal group",
                    value.at);
    return true;
  }
  words.g_groups.set(static_cast<std::size_t>(group));
  words.line.g.push_back(code);
  words.list.add_g({false, 0, static_cast<double>(code)});
  return true;
}

bool BlockReader::m_code(Block& block, Words& words, const Value& value) {
  words.line.computed = words.line.computed || value.computed;
  if (value.computed) {
    if (words.list.m_count < static_cast<int>(kMCodesOfBlock)) words.list.add_m(word_of(value));
    return true;
  }
  if (value.number < 0)
    return refuse(block, Cause::MCodeNotAvailable, "Negative m code used", value.at);
  const int code = to_whole<int>(std::min(value.number, 1e6));
  const std::string text = std::to_string(code);
  words.line.at['m' - 'a'] = value.at;
  words.line.width['m' - 'a'] = value.width;
  if (code > 199)
    return refuse(block, Cause::MCodeNotAvailable, "M-code greater than 199: M" + text, value.at);
  const int group = group_of_m(code);
  if (group < 0)
    return refuse(block, Cause::MCodeNotAvailable, "Unknown m code used: M" + text, value.at);
  if (words.m_groups[static_cast<std::size_t>(group)])
    return refuse(block, Cause::AddressGivenTwice, "Two m codes used from same modal group",
                  value.at);
  words.m_groups.set(static_cast<std::size_t>(group));
  const Role role = to_.control().calls.roles.value.of_m(code);
  words.ends = words.ends || role == Role::End || role == Role::Return;
  words.line.m.push_back(code);
  if (words.list.m_count < static_cast<int>(kMCodesOfBlock))
    words.list.add_m({false, 0, static_cast<double>(code)});
  return true;
}

bool BlockReader::assignment(Block& block, Words& words) {
  Place place;
  Value value;
  Statement statement;
  statement.variable_at = line_.offset(line_.place() - 1);
  if (!expression_.place(place)) return refuse(block);
  statement.variable_width = line_.width_from(statement.variable_at);
  if (!line_.take('='))
    return refuse(block, Cause::MissingEquals, "Equal sign missing in parameter setting",
                  statement.variable_at);
  if (!expression_.value(value)) return refuse(block);
  ngc_assign(to_, statement, place, value);
  words.statements.push_back(statement);
  return true;
}

namespace {

constexpr NgcFormat kFormat{.decimals = 6, .of_f = 4, .loses_percent = true};  // [rs274 2.9]

/// Return the word with which a comment begins that prints or writes to a log; else nothing.
template <class Begins>
std::string_view printing(const Begins& begins) {
  for (const std::string_view command : {"PRINT,", "LOG,", "LOGOPEN,", "LOGAPPEND,", "LOGCLOSE"})
    if (begins(command)) return command;
  return {};
}

}  // namespace

/// Read a comment. Of several comments of a line the last one counts.
bool BlockReader::comment(Block& block, Words& words) {
  const std::uint32_t at = line_.offset();
  std::string text;
  if (!line_.take_up_to(')', text))
    return refuse(block, Cause::CommentNotClosed, "Unclosed comment found", at);
  words.print.reset();
  std::string_view said = text;
  const auto begins = [&](std::string_view word) {
    while (!said.empty() && (said.front() == ' ' || said.front() == '\t')) said.remove_prefix(1);
    return ngc_take_word(said, word);
  };
  if (begins("MSG,")) {
    words.print.emplace();
    words.print->fields.push_back({.text = std::string(said)});
  } else if (begins("DEBUG,")) {
    message(said, at, words.print.emplace());
    words.print->shown_if = kMessageSwitch;
  } else if (const std::string_view command = printing(begins); !command.empty()) {
    message(said, at, words.print.emplace());
    words.print->command = command;
  } else if (begins("ABORT,")) {
    message(said, at, words.print.emplace());
    words.print->alarms = true;
  }
  if (words.print) words.print->at = at;
  return true;
}

/// Write a message into `print`: `#5` and `#<name>` in it stand for their values.
void BlockReader::message(std::string_view text, std::uint32_t at, Print& print) {
  ngc_message(to_, line_, expression_, kFormat, text, at, print);
}

void BlockReader::write(Block& block, Words& words) { ngc_write(to_, block, words); }

}  // namespace cncsub::linuxcnc
