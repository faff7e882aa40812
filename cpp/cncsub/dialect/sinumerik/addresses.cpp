// Addresses and their values: X=IC(5), CR=10, X1=5, AX[X]=5, TRANS, FA[X]=500.
#include <array>
#include <optional>
#include <utility>

#include "cncsub/control/g_codes.hpp"
#include "cncsub/dialect/sinumerik/open_block.hpp"
#include "cncsub/text/axis_names.hpp"

namespace cncsub::sinumerik {

namespace {

constexpr int kPositionAxes = 9016, kMeasure = 9017;  // of word_codes.def
constexpr std::string_view kRotary = "ABC";

/// The form of a value that does not follow G90 and G91. [NCI grammar; 840Dsl]
struct Form {
  std::string_view name;
  bool incremental;
  unsigned rotary;  // the first bit of its axes in WordForms::rotary; 32: it is no form of them
};
constexpr std::array<Form, 5> kForms = {
    {{"AC", false, 32}, {"IC", true, 32}, {"DC", false, 0}, {"ACP", false, 8}, {"ACN", false, 16}}};

const Form* form_named(std::string_view name) {
  for (const Form& of : kForms)
    if (of.name == name) return &of;
  return nullptr;
}

}  // namespace

/// Read a value after =, perhaps in one of the forms; `place`: of its address in the mask.
bool form(OpenBlock& open, Block& block, std::uint32_t at, int place, WordForms& forms,
          Value& value) {
  const std::string_view name = open.line.name();
  const Form* const of = form_named(capitals(name));
  if (of == nullptr || open.definitions.find(capitals(name)) != nullptr)
    return open.expression.value(value) || open.refuse(block);
  open.line.pass(name.size());
  if (!open.line.take('(')) return open.refuse(block, Cause::BracketNotOpened, "( is missing", at);
  if (!open.expression.value(value)) return open.refuse(block);
  if (!open.line.take(')')) return open.refuse(block, Cause::BracketNotClosed, ") is missing", at);
  const std::uint32_t address = 1u << place;
  (of->incremental ? forms.incremental : forms.absolute) |= address;
  if (of->rotary == 32) return true;
  const std::size_t axis =
      place < 26 ? kRotary.find(static_cast<char>('A' + place)) : std::string_view::npos;
  if (axis == std::string_view::npos)
    return open.refuse(block, Cause::StatementFormat,
                       std::string(of->name) + " is a form of rotary axes", at);
  forms.rotary |= 1u << (of->rotary + axis);
  return true;
}

/// Return the cause of an address that stands in a block for the second time: axes and centres,
/// functions that go to the machine, and others have their own.
static Cause cause_of_second(int place) {
  const std::uint32_t address = 1u << place;
  constexpr std::uint32_t kOfMachine = bit('F') | bit('S') | bit('T') | bit('D');
  if ((address & kOfMachine) != 0) return Cause::TooManyWords;
  const bool axis = (address & (kAxisWords | kCentreWords) & ~kPolarWords) != 0;
  return axis ? Cause::AxisGivenTwice : Cause::AddressGivenTwice;
}

/// Give an address its value, which stands once in a block.
bool put(OpenBlock& open, Block& block, Words& words, int place, const Value& value) {
  if ((words.list.mask >> place & 1) != 0)
    return open.refuse(block, cause_of_second(place), "the address is in the block twice",
                       value.at);
  words.list.set(place, {value.computed, value.expression, value.number}, false);
  words.any = true;
  return true;
}

bool acts_alone(int group, int code) {
  constexpr int kMovements = 2, kFrames = 3, kSuppression = 9;
  return group == kMovements || group == kFrames || group == kSuppression ||
         code == kPositionAxes || code == kMeasure;
}

bool add_code(OpenBlock& open, Block& block, Words& words, int group, int code, std::uint32_t at) {
  if (!words.take_group(group))
    return open.refuse(block, Cause::GroupGivenTwice, "a second code of its G group", at);
  if (acts_alone(group, code) && std::exchange(words.acts, true))
    return open.not_computed(block, "a second code that holds for this block alone", at);
  if (words.list.g_count == static_cast<int>(words.list.g.size()))
    return open.refuse(block, Cause::TooManyWords, "more G codes than cncsub reads in one block",
                       at);
  words.list.add_g({false, 0, static_cast<double>(code)});
  words.any = true;
  return true;
}

bool reported(OpenBlock& open, Words& words, std::uint32_t at) {
  words.drops.push_back({0, at, open.line.width_from(at)});
  words.any = true;
  return true;
}

/// Read CR=5 or I1=IC(5), whose name is passed.
bool long_address(OpenBlock& open, Block& block, Words& words, std::string_view name,
                  std::uint32_t at) {
  if (!open.line.take('='))
    return open.refuse(block, Cause::MissingEquals, std::string(name) + " without =", at);
  const int place = place_of(name);
  Value value;
  if (!form(open, block, at, place, words.list.forms, value)) return false;
  value.at = at;
  value.width = open.line.width_from(at);
  return put(open, block, words, place, value);
}

/// Read X1=5, M2=3, S2=500 or T1=5, whose name is passed with its =. The first spindle is the one
/// of the words without a number; what moves or turns elsewhere is reported.
bool numbered(OpenBlock& open, Block& block, Words& words, std::string_view name,
              std::uint32_t at) {
  const char letter = name.front();
  const bool first = name.substr(1) == "1";
  WordForms none;
  Value value;
  if (letter == 'T') {
    Type type = Type::Real;
    if (!open.expression.value_of_any(value, type)) return open.refuse(block);
    if (first && type == Type::String) return tool_by_name(open, block, words, value, at);
    if (type == Type::String) return reported(open, words, at);
  } else if (letter == 'M' ? !value_of_code(open, block, at, value)
                           : !form(open, block, at, letter - 'A', none, value)) {
    return false;
  }
  value.at = at;
  value.width = open.line.width_from(at);
  words.any = true;
  if (first && letter == 'M') return m_code(open, block, words, value);
  if (first && (letter == 'S' || letter == 'T'))
    return put(open, block, words, letter - 'A', value);
  if (kAxisNames.find(letter) != std::string_view::npos)
    words.machine_axes.push_back({letter, {value.computed, value.expression, value.number}});
  else if (std::string_view("MSTDHEQ").find(letter) == std::string_view::npos)
    return open.not_computed(block, "an address with a number", at);
  return reported(open, words, at);
}

/// Read the value of an axis that no column of the moves holds, E=5, whose = is passed: it is
/// reported.
bool axis_beyond(OpenBlock& open, Block& block, Words& words, std::uint32_t at) {
  WordForms none;
  Value value;
  if (!form(open, block, at, 0, none, value)) return false;
  return reported(open, words, at);
}

namespace {

/// Read AXIS]=5 of AX[AXIS]=5 for one axis. `opens`: it is the first one of its block.
bool indexed(OpenBlock& open, Block& block, Words& words, int axis, bool opens) {
  if (!open.expression.indexing_axis(opens)) return open.refuse(block);
  const std::uint32_t at = open.line.offset();
  if (!open.line.take(']')) return open.refuse(block, Cause::BracketNotClosed, "] is missing", at);
  if (!open.line.take('=')) return open.refuse(block, Cause::MissingEquals, "AX without =", at);
  const std::string name = capitals(open.line.name());
  const Form* const of = open.definitions.find(name) != nullptr ? nullptr : form_named(name);
  if (of != nullptr && of->rotary != 32)
    return open.not_computed(block, "a form of rotary axes at AX", at);
  if (of != nullptr) open.line.pass(name.size());
  if (of != nullptr && !open.line.take('('))
    return open.refuse(block, Cause::BracketNotOpened, "( is missing", at);
  if (!open.expression.value_of_axis(axis, opens)) return open.refuse(block);
  if (of != nullptr && !open.line.take(')'))
    return open.refuse(block, Cause::BracketNotClosed, ") is missing", at);
  WordForms& forms = words.list.forms;
  const std::uint32_t address = 1u << (kAxisNames[static_cast<std::size_t>(axis) - 1] - 'A');
  if (of != nullptr) (of->incremental ? forms.incremental : forms.absolute) |= address;
  return true;
}

/// Return which form the AX that stands here has: '=' for none, 'A' for AC, 'I' for IC.
char form_of(const WordForms& forms) {
  const std::uint32_t address = 1u << (kAxisNames[0] - 'A');
  return (forms.incremental & address) != 0 ? 'I' : (forms.absolute & address) != 0 ? 'A' : '=';
}

}  // namespace

bool axis_by_index(OpenBlock& open, Block& block, Words& words, std::uint32_t at) {
  open.line.pass(2);
  if (!open.line.take('[')) return open.refuse(block, Cause::BracketNotOpened, "[ is missing", at);
  const std::string axis = capitals(open.line.name());
  const bool letter = axis.size() == 1 && kAxisNames.find(axis) != std::string_view::npos;
  if (!letter) {
    words.any = true;
    words.indexed.push_back(open.line);
    WordForms forms;
    std::swap(forms, words.list.forms);
    const bool fine = indexed(open, block, words, 1, true);
    std::swap(forms, words.list.forms);
    if (words.indexed.size() > 1 && form_of(forms) != words.indexed_form)
      return open.not_computed(block, "AX with IC beside AX without it", at);
    words.indexed_form = form_of(forms);
    return fine;
  }
  open.line.pass(axis.size());
  if (!open.line.take(']'))
    return open.refuse(block, Cause::BracketNotClosed, "] is missing", open.line.offset());
  if (!open.line.take('=')) return open.refuse(block, Cause::MissingEquals, "AX without =", at);
  Value value;
  if (!form(open, block, at, axis[0] - 'A', words.list.forms, value)) return false;
  value.at = at;
  value.width = open.line.width_from(at);
  return put(open, block, words, axis[0] - 'A', value);
}

bool put_indexed(OpenBlock& open, Block& block, Words& words) {
  const Line end = open.line;
  for (int axis = 1; axis <= static_cast<int>(kAxisNames.size()); ++axis) {
    const int place = kAxisNames[static_cast<std::size_t>(axis) - 1] - 'A';
    std::uint32_t at = 0;
    bool opens = true;
    for (const Line& from : words.indexed) {
      open.line = from;
      if (opens) at = open.line.offset();
      if (!indexed(open, block, words, axis, opens)) return false;
      opens = false;
    }
    if ((words.list.mask >> place & 1) != 0)
      return open.not_computed(block, "AX beside an axis by its letter", at);
    if (!put(open, block, words, place, open.expression.indexed_value(at))) return false;
  }
  open.line = end;
  return true;
}

/// Read a word with a value that no path depends on: FA[X]=500, LIMS=3000, SPOS=DC(90).
bool report(OpenBlock& open, Block& block, Words& words, std::string_view name, std::uint32_t at) {
  const std::string word = capitals(name);
  open.line.pass(name.size());
  std::string_view index;
  if (open.line.peek() == '[') {
    index = open.line.rest();
    if (!open.line.pass_brackets('[', ']'))
      return open.refuse(block, Cause::BracketNotClosed, "] is missing", at);
    index = trimmed(index.substr(1, index.size() - open.line.rest().size() - 2));
    if (index.empty())
      return open.refuse(block, Cause::ExpressionFormat, "nothing stands in the brackets", at);
  } else if (word == "FA") {
    return open.refuse(block, Cause::BracketNotOpened, "[ is missing: FA[X]=500", at);
  }
  if (!open.line.take('='))
    return open.refuse(block, Cause::MissingEquals, word + " without =", at);
  WordForms none;
  Value value;
  if (!form(open, block, at, 0, none, value)) return false;
  value.at = at;
  value.width = open.line.width_from(at);
  if (word == "LIMS" && index == "1") return put(open, block, words, place_of(word), value);
  if (word == "FA" && !value.computed && value.number < 0)
    return open.refuse(block, Cause::AxisFeedNegative, {}, at);
  if (word != "FA" || index.size() != 1) return reported(open, words, at);
  words.axis_feeds.push_back({upper(index[0]),
                              {value.computed, value.expression, value.number},
                              {0, at, open.line.width_from(at)}});
  words.any = true;
  return true;
}

bool position(OpenBlock& open, Block& block, Words& words, std::uint32_t at) {
  open.line.pass(3);
  if (!open.line.take('['))
    return open.refuse(block, Cause::BracketNotOpened, "[ is missing: POS[X]=10", at);
  const std::string axis = capitals(open.line.name());
  open.line.pass(axis.size());
  const bool known = axis.size() == 1 && axis[0] >= 'X' && axis[0] <= 'Z';
  const bool closed = open.line.take(']');
  if (axis.empty() && closed)
    return open.refuse(block, Cause::ExpressionFormat, "nothing stands in the brackets", at);
  if (!closed && open.line.at_end())
    return open.refuse(block, Cause::BracketNotClosed, "] is missing", at);
  if (!closed || !known) return open.not_computed(block, "POS of another axis than X, Y or Z", at);
  if (!open.line.take('='))
    return open.refuse(block, Cause::MissingEquals, "POS[" + axis + "] without =", at);
  Value value;
  if (!form(open, block, at, axis[0] - 'A', words.list.forms, value)) return false;
  for (const Position& of : words.positions)
    if (of.letter == axis[0])
      return open.refuse(block, Cause::AxisGivenTwice, "the axis is in the block twice", at);
  words.positions.push_back({axis[0], {value.computed, value.expression, value.number}, at});
  words.any = true;
  return true;
}

bool move_beside_path(OpenBlock& open, Block& block, Words& words) {
  const bool moves = !words.positions.empty();
  bool sets = false;
  for (const AxisFeed& feed : words.axis_feeds) {
    if (feed.letter < 'X' || feed.letter > 'Z')
      words.drops.push_back(feed.written);
    else
      sets = true;
  }
  if (!moves && !sets) return true;
  const std::uint32_t at = moves ? words.positions.front().at : words.axis_feeds.front().written.at;
  for (const Position& of : words.positions)
    if ((words.list.mask & bit(of.letter)) != 0)
      return open.refuse(block, Cause::AxisGivenTwice, "the axis is in the block twice", of.at);
  constexpr std::uint32_t kPath = kAxisWords | kCentreWords | kPolarWords;
  if ((words.list.mask & kPath) != 0 || words.call || words.modal)
    return open.not_computed(block,
                             moves ? "axes beside the path in a block that moves along it"
                                   : "FA in a block that moves along the path: write it in its own",
                             at);
  for (const Position& of : words.positions) words.list.set(of.letter - 'A', of.value, false);
  for (const AxisFeed& feed : words.axis_feeds)
    if (feed.letter >= 'X' && feed.letter <= 'Z')
      words.list.set('I' + (feed.letter - 'X') - 'A', feed.value, false);
  return add_code(open, block, words, 0, kPositionAxes, at);
}

/// Read a call that no path depends on: WAITP(X), GROUP_BEGIN(0,"a",0,0).
bool report_call(OpenBlock& open, Block& block, Words& words, std::string_view name,
                 std::uint32_t at) {
  open.line.pass(name.size());
  if (open.line.peek() == '(' && !open.line.pass_brackets('(', ')'))
    return open.refuse(block, Cause::BracketNotClosed, ") is missing", at);
  return reported(open, words, at);
}

bool axis_end(OpenBlock& open, Block& block, Words& words, std::string_view name,
              std::uint32_t at) {
  open.line.pass(name.size());
  if (open.line.peek() == '[') {
    if (!open.line.pass_brackets('[', ']'))
      return open.refuse(block, Cause::BracketNotClosed, "] is missing", at);
    return reported(open, words, at);
  }
  if (!open.line.take('='))
    return open.refuse(block, Cause::MissingEquals, std::string(name) + " without =", at);
  Value value;
  Type type = Type::Axis;
  if (!open.expression.value_of_any(value, type)) return open.refuse(block);
  return reported(open, words, at);
}

/// Read TOFFL=0: what begins with another value is not computed.
bool off_at_zero(OpenBlock& open, Block& block, Words& words, std::string_view name,
                 std::uint32_t at) {
  open.line.pass(name.size());
  if (!open.line.take('='))
    return open.refuse(block, Cause::MissingEquals, std::string(name) + " without =", at);
  Value value;
  if (!open.expression.value(value)) return open.refuse(block);
  if (value.computed || value.number != 0)
    return open.not_computed(block, what_it_needs(capitals(name)), at);
  return reported(open, words, at);
}

/// Read MEAS=1 or MEAS=-1, a move until the first probe switches on or off.
bool measure(OpenBlock& open, Block& block, Words& words, std::uint32_t at) {
  open.line.pass(std::string_view("MEAS").size());
  if (!open.line.take('=')) return open.refuse(block, Cause::MissingEquals, "MEAS without =", at);
  Value probe;
  if (!open.expression.value(probe)) return open.refuse(block);
  if (probe.computed || std::fabs(probe.number) != 1)
    return open.not_computed(block, "MEAS of another probe than the first", at);
  constexpr int kNoGroup = 0;
  return add_code(open, block, words, kNoGroup, kMeasure, at);
}

/// Read a G code that is written as a word.
bool code_word(OpenBlock& open, Block& block, Words& words, int code, std::string_view name,
               std::uint32_t at) {
  open.line.pass(name.size());
  return add_code(open, block, words, group_of(name), code, at);
}

}  // namespace cncsub::sinumerik
