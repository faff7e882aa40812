// Words, assignments and messages.
#include "cncsub/dialect/sinumerik/block.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "cncsub/code/operand_of.hpp"
#include "cncsub/control/g_codes.hpp"
#include "cncsub/dialect/sinumerik/frames.hpp"
#include "cncsub/dialect/sinumerik/iso_mode.hpp"
#include "cncsub/dialect/sinumerik/keywords.hpp"
#include "cncsub/text/look_alikes.hpp"

namespace cncsub::sinumerik {

namespace {

constexpr double kLargestM = 2147483647;   // the largest INT [general knowledge]
constexpr std::size_t kLongestLabel = 32;  // [NCI labels: manual 4.1.5.2]
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

}  // namespace

bool OpenBlock::refuse(Block& block, Cause cause, std::string detail, std::uint32_t at) {
  to.refuse(block, {cause, at, line.width_from(at), std::move(detail)});
  return false;
}

bool OpenBlock::refuse(Block& block) {
  if (auto fault = std::exchange(expression.fault, std::nullopt))
    to.refuse(block, std::move(*fault));
  return false;
}

bool OpenBlock::not_computed(Block& block, std::string_view what, std::uint32_t at) {
  return refuse(block, Cause::CodeNotComputed, "cncsub does not compute " + std::string(what), at);
}

bool OpenBlock::end_of_statement(Block& block) {
  if (line.at_end()) return true;
  const std::uint32_t at = line.offset();
  const bool equals = line.take('=');
  if (!equals) line.pass(first_character(line.rest()).size());
  return refuse(block, Cause::StatementFormat,
                equals ? "= assigns: values are compared by =="
                       : "nothing can follow the statement in its block",
                at);
}

namespace {

bool item(OpenBlock& open, Block& block, Words& words);
bool address(OpenBlock& open, Block& block, Words& words);
bool word(OpenBlock& open, Block& block, Words& words, char letter, std::uint32_t at);
bool g_code(OpenBlock& open, Block& block, Words& words, const Value& value);
bool assignment(OpenBlock& open, Block& block, Words& words);
bool named(OpenBlock& open, Block& block, Words& words);
bool message(OpenBlock& open, Block& block, Words& words, std::uint32_t at);
void name_machine_axes(Words& words);
bool write(OpenBlock& open, Block& block, Words& words);
bool write_return(OpenBlock& open, Block& block, const Words& words, std::uint32_t at);
void write_beside(OpenBlock& open, Block& block, const Words& words);

bool item(OpenBlock& open, Block& block, Words& words) {
  const std::uint32_t at = open.line.offset();
  if (open.line.begins_word()) return named(open, block, words);
  if (is_letter(open.line.peek())) return address(open, block, words);
  const bool system = open.line.peek() == '$';
  if (system && system_assignment(open, block, words, at)) return block.op != Op::Fault;
  const std::string_view character = first_character(open.line.rest());
  open.line.pass(character.size());
  if (system) {
    const std::string named = capitals(open.line.name());
    open.line.pass(named.size());
    if (is_frame_variable(named)) {
      Statement statement;
      if (!open.expression.control_frame(named, at, statement)) return open.refuse(block);
      words.statements.push_back(statement);
      return true;
    }
    return open.refuse(block, Cause::CodeNotComputed,
                       "a run does not know what $" + named + " changes", at);
  }
  return open.refuse(block, Cause::IllegalCharacter,
                     "no word begins with this character" + full_width_of(character), at);
}

/// Read X10, X=R1, G1, M30, L100 or R1=5.
bool address(OpenBlock& open, Block& block, Words& words) {
  const std::uint32_t at = open.line.offset();
  const char letter = open.line.peek();
  if (letter == 'R') return assignment(open, block, words);
  if (letter == 'L') return call(open, block, words, open.line.name());
  open.line.pass(1);
  if (open.line.ahead(0) == '[') return indexed(open, block, words, letter, at);
  std::size_t digits = 0;
  while (is_digit(open.line.ahead(digits))) ++digits;
  const std::size_t after = open.line.past_blanks(digits);
  if (digits > 0 && open.line.ahead(after) == '=' && open.line.ahead(after + 1) != '=') {
    const std::string name = letter + std::string(open.line.take_digits());
    if (place_of(name) >= 0) return long_address(open, block, words, name, at);
    open.line.take('=');
    return numbered(open, block, words, name, at);
  }
  return word(open, block, words, letter, at);
}

/// Read the number of an address; where it is missing, the address is what is wrong.
bool number_of(OpenBlock& open, Block& block, std::uint32_t at, Value& value) {
  if (open.expression.number(value)) return true;
  if (auto& fault = open.expression.fault;
      fault.has_value() && fault->cause == Cause::AddressWithoutValue) {
    fault->at = at;
    fault->width = open.line.width_from(at);
  }
  return open.refuse(block);
}

/// Refuse a written number of a tool, an edge or an M code that is not whole, and
/// that of an M code that is none.
bool is_countable(OpenBlock& open, Block& block, char letter, const Value& value) {
  constexpr std::uint32_t kCounted = bit('T') | bit('D') | bit('M');
  if ((kCounted & bit(letter)) == 0 || value.computed) return true;
  if (value.number != std::floor(value.number))
    return open.refuse(block, Cause::WholeNumberExpected, "its number is whole", value.at);
  if (letter == 'M' && (value.number < 0 || value.number > kLargestM))
    return open.refuse(block, Cause::ValueOutOfRange, "the code is out of range", value.at);
  return true;
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one case after the other
bool word(OpenBlock& open, Block& block, Words& words, char letter, std::uint32_t at) {
  if ((letter == 'E' || letter == 'Q') && open.line.take('='))
    return axis_beyond(open, block, words, at);
  const bool code = letter == 'G' || letter == 'M';
  const bool known = code || kAddresses.find(letter) != std::string_view::npos;
  if (!known && kDropped.find(letter) == std::string_view::npos)
    return open.refuse(block, Cause::AddressNotUsable,
                       std::string(1, letter) + " cannot be an address of a block", at);
  const bool equals = open.line.take('=');
  if (equals && open.definitions.find(std::string(1, letter)) != nullptr)
    return open.not_computed(block, "an address that is a parameter of the program too", at);
  Value value;
  Type type = Type::Real;
  const bool read =
      !equals                 ? number_of(open, block, at, value)
      : letter == 'T'         ? open.expression.value_of_any(value, type) || open.refuse(block)
      : code || letter == 'S' ? value_of_code(open, block, at, value)
                              : form(open, block, at, letter - 'A', words.list.forms, value);
  if (!read) return false;
  value.at = at;
  value.width = open.line.width_from(at);
  words.any = true;
  if (letter == 'G') return g_code(open, block, words, value);
  if (!is_countable(open, block, letter, value)) return false;
  if (letter == 'M') return m_code(open, block, words, value);
  if (type == Type::String) return tool_by_name(open, block, words, value, at);
  if (!known) return reported(open, words, at);
  return put(open, block, words, letter - 'A', value);
}

bool g_code(OpenBlock& open, Block& block, Words& words, const Value& value) {
  if (value.computed) {  // which group it has is not known before it runs
    words.list.add_g(word_of(value));
    return true;
  }
  const auto code = to_whole<int>(std::round(value.number * 10));
  const bool whole = code % 10 == 0;  // tenths are those of codes that are written as words
  if (value.number < 0 || !whole || !open.to.control().reading.g_codes.value.has(code))
    return open.refuse(block, Cause::GCodeNotAvailable, "the control has no such G code", value.at);
  if (code == kIsoModeOff || code == kIsoModeOn) return mode_code(open, block, words, code, value);
  return add_code(open, block, words, group_of(code / 10), code, value.at);
}

bool assignment(OpenBlock& open, Block& block, Words& words) {
  const std::uint32_t at = open.line.offset();
  if (!is_digit(open.line.ahead(1)) && open.line.ahead(1) != '[') {
    open.line.pass(1);
    return open.refuse(block, Cause::StatementFormat, "R without the number of a parameter", at);
  }
  Statement statement;
  if (!open.expression.assignment(statement)) return open.refuse(block);
  words.statements.push_back(statement);
  return true;
}

/// Read a word of two letters or more: CR=5, MSG("..."), BRISK, or the name of a program.
// A line for each case: shorter would be harder to read.
// NOLINTNEXTLINE(readability-function-size,readability-function-cognitive-complexity)
bool named(OpenBlock& open, Block& block, Words& words) {
  const std::uint32_t at = open.line.offset();
  const std::string_view written = open.line.name();
  const std::string name = capitals(written);
  if (name == "MSG") return message(open, block, words, at);
  if (name == "MCALL") return modal_call(open, block, words, at);
  if (const Definition* const of = open.definitions.find(name)) {
    if (of->macro) return open.not_computed(block, "the macro " + name, at);
    return open.expression.assignments(*of, words.statements) || open.refuse(block);
  }
  if (is_jump(name))
    return open.refuse(block, Cause::StatementFormat,
                       "a jump stands in a block of its own, or behind IF", at);
  if (name == "AX") return axis_by_index(open, block, words, at);
  if (name == "POS") return position(open, block, words, at);
  if (name == "MEAS") return measure(open, block, words, at);
  if (place_of(name) >= 0 && open.line.ahead(name.size()) != '[') {
    open.line.pass(name.size());
    return long_address(open, block, words, name, at);
  }
  if (const int code = code_of_word(name); code >= 0)
    return code_word(open, block, words, code, name, at);
  if (is_reported(name)) return report(open, block, words, name, at);
  if (is_reported_call(name)) return report_call(open, block, words, name, at);
  if (is_off_at_zero(name)) return off_at_zero(open, block, words, name, at);
  if (is_axis_end(name)) return axis_end(open, block, words, name, at);
  if (is_neutral(name) && open.line.ahead(open.line.past_blanks(name.size())) == '(')
    return report_call(open, block, words, name, at);
  if (is_neutral(name)) {
    open.line.pass(name.size());
    if (!words.take_group(group_of(name)))
      return open.refuse(block, Cause::GroupGivenTwice, "a second word of its G group", at);
    return reported(open, words, at);
  }
  if (name == "RET") {
    open.line.pass(name.size());
    if (open.line.peek() == '(') return open.not_computed(block, "RET with values", at);
    words.back = at;
    return true;
  }
  const char behind = open.line.ahead(open.line.past_blanks(written.size()));
  if (!is_not_computed(name) && behind != '=' && behind != '[')
    return call(open, block, words, written);
  open.line.pass(name.size());
  if (is_not_computed(name)) return open.not_computed(block, what_it_needs(name), at);
  return open.refuse(block, Cause::CodeNotComputed,
                     name + " is not defined in this program, nor in a file of definitions", at);
}

/// Read MSG("text" << R1), or MSG(), which takes the message away. A second value says when it
/// shows.
bool message(OpenBlock& open, Block& block, Words& words, std::uint32_t at) {
  open.line.pass(3);
  if (!open.line.take('(')) return open.refuse(block, Cause::BracketNotOpened, "( is missing", at);
  PrintField field;
  if (open.line.peek() != ')') {
    Value when;
    if (!text_field(open, block, field)) return false;
    if (open.line.take(',') && !open.expression.value(when)) return open.refuse(block);
  }
  if (!open.line.take(')')) return open.refuse(block, Cause::BracketNotClosed, ") is missing", at);
  words.print.emplace();
  words.print->fields.push_back(std::move(field));
  words.print->at = at;
  return true;
}

/// Let X1=0 name the axis X where its block goes to a reference or a fixed point.
void name_machine_axes(Words& words) {
  for (int i = 0; i < words.list.g_count; ++i) {
    const double code = words.list.g[static_cast<std::size_t>(i)].value;
    if (code != 740 && code != 750) continue;
    for (const auto& [letter, value] : words.machine_axes)
      words.list.set(letter - 'A', value, false);
    words.drops.clear();
  }
}

bool write(OpenBlock& open, Block& block, Words& words) {
  if (!switch_mode(open, block, words, false)) return false;
  if (!words.indexed.empty() && !put_indexed(open, block, words)) return false;
  name_machine_axes(words);
  if (!move_beside_path(open, block, words)) return true;
  if (words.modal) return write_modal_call(open, block, words);
  if (words.call) return write_call(open, block, words, std::move(*words.call));
  for (const Drop& drop : words.drops) open.to.drop(drop.at, drop.width);
  if (words.back) return write_return(open, block, words, *words.back);
  if (words.statements.empty() && !words.print) {
    open.to.words(block, words.list);
    if (words.ends) block.op = Op::EndProgram;
    return true;
  }
  write_beside(open, block, words);
  return true;
}

bool write_return(OpenBlock& open, Block& block, const Words& words, std::uint32_t at) {
  if (words.ends) return open.not_computed(block, "M30 beside the return", at);
  Block own = block;
  open.to.words(own, words.list);
  CallRecord back;
  back.at = at;
  back.width = open.line.width_from(at);
  open.to.become(own, Op::Return, std::move(back));
  if (words.statements.empty() && !words.print)
    block = own;
  else
    open.to.parallel_assign(block, words.statements, words.print ? &*words.print : nullptr, &own);
  return true;
}

/// Write assignments and a message, perhaps with words beside them.
void write_beside(OpenBlock& open, Block& block, const Words& words) {
  if (!words.any && words.statements.size() == 1 && !words.print) {
    assign(open.to, block, words.statements.front());
  } else if (!words.any && words.statements.empty() && words.print) {
    open.to.become(block, Op::Print, *words.print);
  } else {
    Block own = block;
    if (words.any) {
      open.to.words(own, words.list);
      own.op = words.ends ? Op::EndProgram : Op::Words;  // no plain move: more stands beside it
    }
    open.to.parallel_assign(block, words.statements, words.print ? &*words.print : nullptr,
                            words.any ? &own : nullptr);
  }
}

}  // namespace

bool text_field(OpenBlock& open, Block& block, PrintField& field) {
  Value text;
  if (!open.expression.text(text)) return open.refuse(block);
  field.is_variable = field.is_text = text.computed;
  field.expression = text.expression;
  if (!text.computed) field.text = open.to.code().texts.at(to_whole<std::size_t>(text.number));
  return true;
}

bool BlockReader::read(std::string_view text, Block& block, std::string& label, Link& link) {
  if (!open_.iso_mode && plain(text, block)) return true;
  open_.line.set(text, block.text);
  open_.expression.begin_block();
  if (open_.line.at_end()) return false;
  skip_level(block);
  if (!number(block)) return true;
  if (open_.iso_mode)
    read_iso_block(open_, block);
  else
    read_own(block, label, link);
  hold_mode(block);
  return true;
}

/// Refuse a return from a program in another mode than it began in: no source says in which mode
/// its caller goes on. M30 returns where another program has called this one.
void BlockReader::hold_mode(Block& block) {
  const bool returns = block.op == Op::Return, ends = block.op == Op::EndProgram;
  if ((!returns && !ends) || open_.iso_mode == began_in_iso_mode_) return;
  if (!ends || began_in_iso_mode_) return refuse_mode(block);
  Block called = block;
  refuse_mode(called);
  Select variant;
  variant.of_called = true;
  variant.first = open_.to.keep(block);
  variant.second = open_.to.keep(called);
  open_.to.become(block, Op::Select, variant);
}

void BlockReader::refuse_mode(Block& block) {
  const bool returns = block.op == Op::Return;
  std::uint32_t at = block.text, width = 1;
  if (returns) {
    const CallRecord& back = open_.to.record<CallRecord>(block.aux);
    at = back.at;
    width = back.width;
  }
  open_.to.refuse(block, {Cause::CodeNotComputed, at, width,
                          "cncsub does not compute a return in another mode than the program "
                          "began in: write G290 or G291 before it"});
}

void BlockReader::read_own(Block& block, std::string& label, Link& link) {
  take_label(label);
  const bool is_word = open_.line.begins_word();  // DEF and IF; not X10
  if (is_word && declarations_.read(block)) return;
  if (!open_.line.at_end()) declarations_.end_definitions();
  bool read_it = true;
  if (is_word && statement(open_, block, link, read_it)) {
    if (const bool o_word = !label.empty(); is_marked_structure(block, link, o_word))
      refuse_mark(open_.to, block, o_word, marked_at_, marked_width_);
    return;
  }
  Words words;
  while (!open_.line.at_end())
    if (!item(open_, block, words)) return;
  write(open_, block, words);
}

/// Read the skip levels: `/` and `/0` are the first of ten, `/9` is the tenth. [general knowledge]
void BlockReader::skip_level(Block& block) {
  marked_at_ = open_.line.offset();
  while (open_.line.take('/')) {
    const char level = open_.line.ahead(0);
    if (is_digit(level)) open_.line.pass(1);
    block.skip |= 1u << (is_digit(level) ? level - '0' + 1 : 1);
    marked_width_ = open_.line.width_from(marked_at_);
  }
}

/// Read N10, or :10 of a main block. [802D p.133]
bool BlockReader::number(Block& block) {
  const std::uint32_t at = open_.line.offset();
  const char c = open_.line.peek();
  if ((c != 'N' && c != ':') || !is_digit(open_.line.ahead(1))) return true;
  open_.line.pass(1);
  const std::string_view digits = open_.line.take_digits();
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), block.n);
  if (read.ec == std::errc() && block.n <= open_.to.control().reading.max_sequence_number.value)
    return true;
  block.n = -1;
  return open_.refuse(block, Cause::IllegalSequenceNumber, "a block number that is too large", at);
}

/// Read the label that begins the block: two letters or _, perhaps more, and a colon. [NCI labels]
void BlockReader::take_label(std::string& label) {
  if (!open_.line.begins_word()) return;
  const std::string_view name = open_.line.name();
  if (name.size() > kLongestLabel) return;
  if (open_.line.ahead(name.size()) != ':') return;
  label = capitals(name);
  marked_at_ = open_.line.offset();
  open_.line.pass(name.size() + 1);
  marked_width_ = open_.line.width_from(marked_at_);
}

bool Words::take_group(int group) {
  if (group == 0) return true;
  const auto place = static_cast<std::size_t>(group);
  if (groups.test(place)) return false;
  groups.set(place);
  return true;
}

}  // namespace cncsub::sinumerik
