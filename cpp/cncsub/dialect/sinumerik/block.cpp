// Words, assignments and messages.
#include "cncsub/dialect/sinumerik/block.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "cncsub/control/g_codes.hpp"
#include "cncsub/dialect/sinumerik/keywords.hpp"
#include "cncsub/text/look_alikes.hpp"

namespace cncsub::sinumerik {

namespace {

constexpr int kMostM = 5;  // of a block [NCI groups; general knowledge]
constexpr std::size_t kLongestLabel = 32, kShortestLabel = 2;  // [NCI labels: manual 4.1.5.2]
constexpr std::string_view kAddresses = "ABCDFIJKSTUVWXYZ";
constexpr std::string_view kDropped = "H";  // reported, and without effect here

/// Return whether a block of a control structure has a label or may be skipped. [840Dsl p.107]
bool is_marked_structure(const Block& block, const Link& link, bool o_word) {
  return link.is_structure() && (block.skip != 0 || o_word);
}

void refuse_mark(Builder& to, Block& block, bool o_word, std::uint32_t at, std::uint32_t width) {
  block.skip = 0;
  to.refuse(block, {Cause::StructureMarked, at, width,
                    o_word ? "a block of a control structure cannot have a label"
                           : "a block of a control structure cannot be skipped"});
}

WordValue word_of(const Value& value, double factor = 1) {
  return {value.computed, value.expression, value.number * factor};
}

}  // namespace

bool BlockReader::refuse(Block& block, Cause cause, std::string detail, std::uint32_t at) {
  to_.refuse(block, {cause, at, line_.width_from(at), std::move(detail)});
  return false;
}

bool BlockReader::refuse(Block& block) {
  if (auto fault = std::exchange(expression_.fault, std::nullopt))
    to_.refuse(block, std::move(*fault));
  return false;
}

bool BlockReader::not_computed(Block& block, std::string_view what, std::uint32_t at) {
  return refuse(block, Cause::CodeNotComputed, "cncsub does not compute " + std::string(what), at);
}

bool BlockReader::read(std::string_view text, Block& block, std::string& label, Link& link) {
  line_.set(text, block.text);
  expression_.begin_block();
  if (line_.at_end()) return false;
  skip_level(block);
  if (!number(block)) return true;
  take_label(label);
  if (declarations_.read(block)) return true;
  bool read_it = true;
  if (statement(block, link, read_it)) {
    if (const bool o_word = !label.empty(); is_marked_structure(block, link, o_word))
      refuse_mark(to_, block, o_word, marked_at_, marked_width_);
    return true;
  }
  Words words;
  while (!line_.at_end())
    if (!item(block, words)) return true;
  write(block, words);
  return true;
}

/// Read the skip levels: `/` and `/0` are the first of ten, `/9` is the tenth. [general knowledge]
void BlockReader::skip_level(Block& block) {
  marked_at_ = line_.offset();
  while (line_.take('/')) {
    const char level = line_.ahead(0);
    if (is_digit(level)) line_.pass(1);
    block.skip |= 1u << (is_digit(level) ? level - '0' + 1 : 1);
    marked_width_ = line_.width_from(marked_at_);
  }
}

/// Read N10, or :10 of a main block. [802D p.133]
bool BlockReader::number(Block& block) {
  const std::uint32_t at = line_.offset();
  const char c = line_.peek();
  if ((c != 'N' && c != ':') || !is_digit(line_.ahead(1))) return true;
  line_.pass(1);
  const std::string_view digits = line_.take_digits();
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), block.n);
  if (read.ec == std::errc() && block.n <= to_.control().reading.max_sequence_number.value)
    return true;
  block.n = -1;
  return refuse(block, Cause::IllegalSequenceNumber, "a block number that is too large", at);
}

/// Read the label that begins the block: two letters or _, perhaps more, and a colon. [NCI labels]
void BlockReader::take_label(std::string& label) {
  const std::string_view name = line_.name();
  if (name.size() < kShortestLabel || name.size() > kLongestLabel || is_digit(name[1])) return;
  if (line_.ahead(name.size()) != ':') return;
  label = capitals(name);
  marked_at_ = line_.offset();
  line_.pass(name.size() + 1);
  marked_width_ = line_.width_from(marked_at_);
}

bool BlockReader::item(Block& block, Words& words) {
  const std::uint32_t at = line_.offset();
  const std::string_view name = line_.name();
  if (name.size() > 1 && !is_digit(name[1])) return named(block, words);
  if (!name.empty() && is_letter(name[0])) return address(block, words);
  const bool system = line_.peek() == '$';
  const std::string_view character = first_character(line_.rest());
  line_.pass(character.size());
  if (system) {
    const std::string named = capitals(line_.name());
    line_.pass(named.size());
    return refuse(block, Cause::CodeNotComputed, "a run does not know what $" + named + " changes",
                  at);
  }
  return refuse(block, Cause::IllegalCharacter,
                "no word begins with this character" + full_width_of(character), at);
}

/// Read X10, X=R1, G1, M30, L100 or R1=5.
bool BlockReader::address(Block& block, Words& words) {
  const std::uint32_t at = line_.offset();
  const char letter = line_.peek();
  if (letter == 'R') return assignment(block, words);
  if (letter == 'L') return call(block, words, line_.name());
  line_.pass(1);
  if (line_.ahead(0) == '[') {  // M[1]=5 of a spindle, G[8]=2 of a group
    while (line_.peek() != '\0' && !line_.take(']')) line_.pass(1);
    return not_computed(block, "an address with an index", at);
  }
  std::size_t digits = 0;
  while (is_digit(line_.ahead(digits))) ++digits;
  if (digits > 0 && line_.ahead(digits) == '=' && line_.ahead(digits + 1) != '=') {
    const std::string name = letter + std::string(line_.take_digits());
    if (place_of(name) >= 0) return long_address(block, words, name, at);
    line_.take('=');
    return numbered(block, words, name, at);
  }
  return word(block, words, letter, at);
}

bool BlockReader::word(Block& block, Words& words, char letter, std::uint32_t at) {
  if ((letter == 'E' || letter == 'Q') && line_.take('=')) return axis_beyond(block, words, at);
  const bool code = letter == 'G' || letter == 'M';
  const bool known = code || kAddresses.find(letter) != std::string_view::npos;
  if (!known && kDropped.find(letter) == std::string_view::npos)
    return refuse(block, Cause::AddressNotUsable,
                  std::string(1, letter) + " cannot be an address of a block", at);
  const bool equals = line_.take('=');
  if (equals && letter == 'T' && line_.peek() == '"') return tool_by_name(words, at);
  if (equals && definitions_.find(std::string(1, letter)) != nullptr)
    return not_computed(block, "an address that is a parameter of the program too", at);
  Value value;
  bool is_text = false;
  const bool read = !equals         ? expression_.number(value) || refuse(block)
                    : letter == 'T' ? expression_.value_or_text(value, is_text) || refuse(block)
                                    : form(block, at, letter - 'A', words.list.forms, value);
  if (!read) return false;
  value.at = at;
  value.width = line_.width_from(at);
  words.any = true;
  if (letter == 'G')
    return equals ? refuse(block, Cause::StatementFormat, "G cannot have =", at)
                  : g_code(block, words, value);
  if (letter == 'M') return m_code(block, words, value);
  if (!known || is_text) {  // the number of a tool's name is the machine's affair
    words.drops.push_back({0, value.at, value.width});
    return true;
  }
  return put(block, words, letter - 'A', value);
}

bool BlockReader::Words::take_group(int group) {
  if (group == 0) return true;
  const auto place = static_cast<std::size_t>(group);
  if (groups.test(place)) return false;
  groups.set(place);
  return true;
}

bool BlockReader::g_code(Block& block, Words& words, const Value& value) {
  const auto code = to_whole<int>(std::round(value.number * 10));
  const bool whole = code % 10 == 0;  // tenths are those of codes that are written as words
  if (value.number < 0 || !whole || !to_.control().reading.g_codes.value.has(code))
    return refuse(block, Cause::GCodeNotAvailable, "the control has no such G code", value.at);
  if (!words.take_group(group_of(code / 10)))
    return refuse(block, Cause::AddressGivenTwice, "a second code of its G group", value.at);
  if (words.list.g_count == static_cast<int>(words.list.g.size()))
    return refuse(block, Cause::TooManyWords, "more G codes than cncsub reads in one block",
                  value.at);
  words.list.add_g({false, 0, static_cast<double>(code)});
  return true;
}

bool BlockReader::m_code(Block& block, Words& words, const Value& value) {
  if (words.list.m_count == kMostM)
    return refuse(block, Cause::TooManyWords, "more than five M codes", value.at);
  const int code = to_whole<int>(std::clamp(std::round(value.number), -1.0, kLargestCode));
  const Role role = value.computed ? Role::None : to_.control().calls.roles.value.of_m(code);
  if (role == Role::Return) {
    words.back = value.at;
    return true;
  }
  words.ends = words.ends || role == Role::End;
  words.list.add_m(word_of(value));
  return true;
}

bool BlockReader::assignment(Block& block, Words& words) {
  const std::uint32_t at = line_.offset();
  if (!is_digit(line_.ahead(1)) && line_.ahead(1) != '[') {
    line_.pass(1);
    return refuse(block, Cause::StatementFormat, "R without the number of a parameter", at);
  }
  Statement statement;
  if (!expression_.assignment(statement)) return refuse(block);
  words.statements.push_back(statement);
  return true;
}

/// Read a word of two letters or more: CR=5, MSG("..."), BRISK, or the name of a program.
bool BlockReader::named(Block& block, Words& words) {
  const std::uint32_t at = line_.offset();
  const std::string_view written = line_.name();
  const std::string name = capitals(written);
  if (name == "MSG") return message(block, words, at);
  if (name == "MCALL") return modal_call(block, words, at);
  if (const Definition* const of = definitions_.find(name)) {
    return expression_.assignments(*of, words.statements) || refuse(block);
  }
  if (name == "AX") return axis_by_index(block, words, at);
  if (place_of(name) >= 0) {
    line_.pass(name.size());
    return long_address(block, words, name, at);
  }
  if (const int code = code_of_word(name); code >= 0)
    return code_word(block, words, code, name, at);
  if (is_reported(name)) return report(block, words, name, at);
  if (is_reported_call(name)) return report_call(block, words, name, at);
  if (is_off_at_zero(name)) return off_at_zero(block, words, name, at);
  if (is_neutral(name)) {
    line_.pass(name.size());
    if (!words.take_group(group_of(name)))
      return refuse(block, Cause::AddressGivenTwice, "a second word of its G group", at);
    words.drops.push_back({0, at, line_.width_from(at)});
    words.any = true;
    return true;
  }
  if (name == "RET") {
    line_.pass(name.size());
    if (line_.peek() == '(') return not_computed(block, "RET with values", at);
    words.back = at;
    return true;
  }
  std::size_t behind = written.size();
  while (behind < line_.rest().size() && is_blank(line_.ahead(behind))) ++behind;
  if (!is_not_computed(name) && line_.ahead(behind) != '=' && line_.ahead(behind) != '[')
    return call(block, words, written);
  line_.pass(name.size());
  if (is_not_computed(name)) return not_computed(block, what_it_needs(name), at);
  return refuse(block, Cause::CodeNotComputed,
                name + " is not defined in this program, nor in a file of definitions", at);
}

/// Read MSG("text" << R1), or MSG(), which takes the message away. A second value says when it
/// shows.
bool BlockReader::message(Block& block, Words& words, std::uint32_t at) {
  line_.pass(3);
  if (!line_.take('(')) return refuse(block, Cause::BracketNotOpened, "( is missing", at);
  PrintField field;
  if (line_.peek() != ')') {
    Value text, when;
    if (!expression_.text(text)) return refuse(block);
    if (line_.take(',') && !expression_.value(when)) return refuse(block);
    field.is_variable = field.is_text = text.computed;
    field.expression = text.expression;
    if (!text.computed) field.text = to_.code().texts.at(to_whole<std::size_t>(text.number));
  }
  if (!line_.take(')')) return refuse(block, Cause::BracketNotClosed, ") is missing", at);
  words.print.emplace();
  words.print->fields.push_back(std::move(field));
  words.print->at = at;
  return true;
}

/// Let X1=0 name the axis X where its block goes to a reference or a fixed point.
void BlockReader::name_machine_axes(Words& words) const {
  for (int i = 0; i < words.list.g_count; ++i) {
    const double code = words.list.g[static_cast<std::size_t>(i)].value;
    if (code != 740 && code != 750) continue;
    for (const auto& [letter, value] : words.machine_axes)
      words.list.set(letter - 'A', value, false);
    words.drops.clear();
  }
}

bool BlockReader::write(Block& block, Words& words) {
  name_machine_axes(words);
  if (words.modal) return write_modal_call(block, words);
  if (words.call) return write_call(block, words, std::move(*words.call));
  for (const Drop& drop : words.drops) to_.drop(drop.at, drop.width);
  if (words.back) return write_return(block, words, *words.back);
  if (words.statements.empty() && !words.print) {
    to_.words(block, words.list);
    if (words.ends) block.op = Op::EndProgram;
    return true;
  }
  write_beside(block, words);
  return true;
}

bool BlockReader::write_return(Block& block, const Words& words, std::uint32_t at) {
  if (!words.statements.empty() || words.print || words.ends)
    return not_computed(block, "an assignment, a message or M30 beside the return", at);
  to_.words(block, words.list);
  CallRecord back;
  back.at = at;
  back.width = line_.width_from(at);
  to_.become(block, Op::Return, std::move(back));
  return true;
}

/// Write assignments and a message, perhaps with words beside them.
void BlockReader::write_beside(Block& block, const Words& words) {
  if (!words.any && words.statements.size() == 1 && !words.print) {
    assign(to_, block, words.statements.front());
  } else if (!words.any && words.statements.empty() && words.print) {
    to_.become(block, Op::Print, *words.print);
  } else {
    Block own = block;
    if (words.any) {
      to_.words(own, words.list);
      own.op = words.ends ? Op::EndProgram : Op::Words;  // no plain move: more stands beside it
    }
    to_.parallel_assign(block, words.statements, words.print ? &*words.print : nullptr,
                        words.any ? &own : nullptr);
  }
}

}  // namespace cncsub::sinumerik
