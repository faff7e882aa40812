#include "cncsub/flat/other.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/state/facts.hpp"
#include "cncsub/motion/state/values.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

// The words of a block in the order that most programs have.
constexpr std::string_view kOrder = "XYZABCUVWIJKRQPLEFSTHDNO";
constexpr std::string_view kLengths = "ABCIJKQRUVWXYZ";

bool is_in(std::string_view letters, char letter) {
  return letters.find(letter) != std::string_view::npos;
}

/// Return whether the code calls, returns or ends: the run decides what becomes of such a code.
bool is_own(Role role) {
  return role != Role::None && role < Role::SpindleForward && role != Role::Stop &&
         role != Role::OptionalStop && role != Role::End;
}

/// Return whether P of G04 counts seconds on a control.
bool counts_seconds(const Control& control) {
  return control.motion.dwell_unit.value == DwellUnit::PSeconds ||
         control.motion.dwell_point.value == DwellPoint::Seconds ||
         control.motion.dwell_point.value == DwellPoint::CyclesToo;
}

/// Return ten times the G code of a plain move, which no list holds; -1 where the block has none.
int path_code(const Block& block) {
  const bool line = block.op == Op::Linear;
  if ((!line && block.op != Op::Arc) || (block.flags & Block::kNoG) != 0) return -1;
  const int first = line ? 0 : 20;
  return (block.flags & Block::kSecondG) != 0 ? first + 10 : first;
}

}  // namespace

NcWords constant_words(const Machine& machine, const Block& block) {
  const Code& code = machine.code();
  const CodeMeanings& meanings = *facts_of(machine).meanings;
  NcWords words;
  const Cell* cell = code.cells.data() + block.data;
  if ((block.flags & Block::kHasExtra) != 0) words.whole = (cell++)->extra.whole;
  if ((block.flags & Block::kListed) != 0) words.codes = &meanings.blocks[block.list];
  cell += block.code_cells();
  words.mask = block.mask;
  for (std::uint32_t left = block.mask; left != 0; left &= left - 1, ++cell)
    words.value[static_cast<std::size_t>(std::countr_zero(left))] = cell->value;
  if ((block.flags & Block::kHasForms) != 0)
    words.forms = {cell[0].extra.expressions, cell[0].extra.whole, cell[1].extra.expressions};
  return words;
}

namespace {

/// Return the number of a program there: that of its name, or 1 where the name has none that the
/// control takes.
std::string number_there(const std::string& number, const Control& control) {
  constexpr std::size_t kMostDigits = 9;
  const std::size_t first = number.find_first_not_of('0');
  if (first == std::string::npos || number.size() - first > kMostDigits) return "1";
  const bool taken = std::stoi(number) <= control.reading.max_program_number.value;
  return taken ? number : "1";
}

}  // namespace

OtherWriter::OtherWriter(const Machine& from, const Machine& to)
    : from_(from), to_(to), words_(from, to), at_power_on_(from.motion().state().modal) {}

bool OtherWriter::refuse(std::string reason) {
  refused_ = std::move(reason);
  return false;
}

std::string OtherWriter::refusal() const {
  const MachineType own = facts_of(from_).machine, other = facts_of(to_).machine;
  if (own == other) return "";
  const auto name = [](MachineType type) {
    return std::string(options<MachineType>()[static_cast<std::size_t>(type)].slug);
  };
  return "the program is one of a " + name(own) + ", and " + control_of(to_).name +
         " is a control of a " + name(other);
}

std::string OtherWriter::head(const std::string& name) const {
  const Spelling::Around& around = to_.code().spelling->head;
  const Control& control = control_of(to_);
  if (around.before.empty() || control.calls.program_word.value == ProgramWord::SequenceNumber)
    return "";
  const std::size_t first = name.find_first_of("0123456789");
  std::string number = first == std::string::npos ? "" : name.substr(first);
  if (number.find_first_not_of("0123456789") != std::string::npos) number.clear();
  if (!around.behind.empty()) {  // a name, that begins with two letters
    const bool letters = name.size() > 1 && is_letter(name[0]) && is_letter(name[1]);
    std::string written(around.before);
    for (const char c : letters ? name : "PROG" + number) {
      if ((static_cast<unsigned char>(c) & 0xc0) == 0x80) continue;  // inside a character
      // A name holds no blanks, points and letters of other scripts: they are written as _.
      written += is_letter(c) || is_digit(c) ? c : '_';
    }
    return written + std::string(around.behind) + "\n";
  }
  const bool percent = control.reading.program_heads.value.has(ProgramHead::Percent);
  return (percent ? "%" : std::string(around.before)) + number_there(number, control) + "\n";
}

// ---- codes ----

/// Return the code there of what a code means here; -1 where there is none. `idle`: nothing else
/// can be in force there.
int OtherWriter::code_of(const GCode& own, bool& idle) const {
  const MotionFacts& facts = facts_of(to_);
  const auto same = [&own](const GCode& there) {
    return there.code >= 0 && there.meaning == own.meaning && there.variant == own.variant;
  };
  if (const GCode there = facts.codes.find(own.code); same(there)) return there.code;
  if (is_neutral(own.meaning)) return -1;
  if (const GCode there = facts.codes.of(own.meaning, own.variant); there.code >= 0)
    return there.code;
  // F is written in the units that it has there.
  if (const GCode there = facts.codes.of(own.meaning); own.group == Group::Units && there.code >= 0)
    return there.code;
  const std::size_t group = at(own.group);
  idle = own.group != Group::OneShot && to_.motion().state().modal[group].code < 0 &&
         at_power_on_[group].meaning == own.meaning;
  return -1;
}

namespace {

bool bare_line_needs_feed(const Machine& machine) {
  return facts_of(machine).refuses(Cause::NoFeed);
}

}  // namespace

std::string OtherWriter::modes() {
  std::string units, others;
  for (std::size_t group = 0; group < kGroups; ++group) {
    const GCode own = at_power_on_[group];
    const GCode there = to_.motion().state().modal[group];
    if (own.code < 0 || own.meaning == there.meaning || group == at(Group::Stroke)) continue;
    bool idle = false;
    const int code = code_of(own, idle);
    if (code < 0) continue;
    if (own.meaning == Meaning::Line && bare_line_needs_feed(to_) &&
        from_.motion().state().feed == 0) {
      line_is_owed_ = true;
      continue;
    }
    std::string& to = group == at(Group::Units) ? units : others;
    to += (to.empty() ? "" : " ") + code_name(code);
  }
  if (!units.empty()) units += '\n';
  return others.empty() ? units : units + others + '\n';
}

bool OtherWriter::put_codes(std::string& to, std::span<const int> codes, bool leaves_line) {
  std::string units, others;
  for (const int own : codes) {
    const GCode meant = facts_of(from_).codes.find(own);
    if (leaves_line && meant.meaning == Meaning::Line) continue;
    bool idle = false;
    const int code = code_of(meant, idle);
    if (code < 0 && !idle)
      return refuse(control_of(to_).name + " has no code that does what " + code_name(own) +
                    " does here");
    if (code < 0) continue;
    (meant.group == Group::Units ? units : others) += code_name(code) + " ";
  }
  const bool alone = control_of(to_).motion.unit_change.value != UnitChange::Anywhere;
  if (alone && !units.empty()) units.back() = '\n';
  to += units + others;
  return true;
}

/// Return whether a block says G01 without an axis while no feed is in force, and the control
/// refuses that. The block that moves by the code then gets it.
bool OtherWriter::leaves_line(const NcWords& words) const {
  return bare_line_needs_feed(to_) && words.codes->meaning(Group::Motion) == Meaning::Line &&
         (words.mask & kAxisWords) == 0 && from_.motion().state().feed == 0;
}

/// Return whether a block moves by the motion code in force and writes none.
bool OtherWriter::moves_by_line(const NcWords& words) const {
  constexpr std::uint32_t kOthers = bit(Group::Motion) | bit(Group::Cycle) | bit(Group::OneShot);
  return (words.mask & kAxisWords) != 0 && (words.codes->groups & kOthers) == 0 &&
         !in_cycle(from_.motion().state());
}

bool OtherWriter::put_m(std::string& to, const NcWords& words, bool ends) {
  const Roles &here = control_of(from_).calls.roles.value,
              &there = control_of(to_).calls.roles.value;
  bool ended = false;
  for (const int m : words.codes->m()) {
    const Role role = here.of_m(m);
    if (role == there.of_m(m)) {
      if (is_own(role)) continue;
      if (role == Role::End)
        to += "M" + std::to_string(m);
      else if (!words_.code(to, 'M', m * 10))
        return refuse("M" + std::to_string(m) + " calls a program there");
    } else if (const auto code = there.code_of(role); role != Role::None && code) {
      to += code->text();
    } else if (!is_own(there.of_m(m)) && there.of_m(m) == Role::None) {
      to += "M" + std::to_string(m);
    } else {
      return refuse("M" + std::to_string(m) + " is another code of " + control_of(to_).name);
    }
    ended = ended || role == Role::End;
    to += ' ';
  }
  if (ends && !ended) to += end() + " ";
  return true;
}

std::string OtherWriter::end() const {
  const Roles& roles = control_of(to_).calls.roles.value;
  if (roles.of_m(30) == Role::End) return "M30";
  const auto code = roles.code_of(Role::End);
  return code ? code->text() : "";
}

// ---- values ----

/// Return whether the words of a block are those of a drilling cycle, and of no other code.
bool OtherWriter::drills(const NcWords& words) const {
  constexpr std::uint32_t kBeside = bit(Group::Motion) | bit(Group::Plane) | bit(Group::Distance) |
                                    bit(Group::Return) | bit(Group::Feed) | bit(Group::Cycle);
  return in_cycle(from_.motion().state()) && (words.codes->groups & ~kBeside) == 0;
}

void OtherWriter::put_repeats(std::string& to, char letter, double count) const {
  const Letters& there = control_of(to_).motion.cycle_repeats.value;
  to += there.has(letter) || there.empty() ? letter : there.front();
  to += NumberText(count).text();
  to += ' ';
}

/// Return the value of a word in units of the program.
double OtherWriter::value_of(const NcWords& words, int place) const {
  const double value = words.value[static_cast<std::size_t>(place)];
  if (place >= kCommaC) return value;
  const char letter = static_cast<char>('A' + place);
  const MotionView view = from_.motion().view();
  const bool whole = (words.whole >> place & 1) != 0;
  const bool increments = control_of(from_).reading.whole_numbers.value == WholeNumbers::Increments;
  if (letter == 'F')
    return feed_there(whole && increments ? value * feed_increment(view.state) : value);
  if (!whole || !is_in(kLengths, letter)) return value;
  return in_units(view, words, letter);
}

/// Return a feed in the units that F has there, where the code of units changes it on one of the
/// two controls and not on the other.
double OtherWriter::feed_there(double feed) const {
  const MotionState& state = from_.motion().state();
  const GCode own = state.modal[at(Group::Units)];
  bool idle = false;
  const int code = code_of(own, idle);
  const GCode there =
      code < 0 ? to_.motion().state().modal[at(Group::Units)] : facts_of(to_).codes.find(code);
  if (state.modal[at(Group::Feed)].meaning == Meaning::InverseTime || own.variant == there.variant)
    return feed;
  return feed * state.feed_unit / feed_unit_of(facts_of(to_), there);
}

bool OtherWriter::put_word(std::string& to, int place, double value) {
  if (!words_.computed(to, place, value))
    return refuse("the value of " + from_.code().spelling->address_of(place) +
                  " cannot be written for " + control_of(to_).name);
  to += ' ';
  return true;
}

bool OtherWriter::put_dwell(std::string& to, double seconds) {
  const Control& control = control_of(to_);
  const auto& letters = control.motion.dwell_words.value;
  const double thousandths = std::round(seconds * 1e6) / 1e3;
  char letter = 0;
  if (letters.has('P'))
    letter = 'P';
  else if (!letters.empty())
    letter = letters.front();
  if (letter == 'P' && !counts_seconds(control) && thousandths == std::floor(thousandths))
    return put_word(to, 'P' - 'A', thousandths);
  if (letter == 'P' && !counts_seconds(control))
    for (const char each : letters)
      if (each != 'P') letter = each;
  if (letter == 0) return refuse(control.name + " has no word for the time of a dwell");
  std::string text(NumberText(seconds).text());
  if (text.find('.') == std::string::npos) text += '.';
  to += letter + text + " ";
  return true;
}

/// Write the dwell of a drilling cycle, which has one letter and may take no point.
bool OtherWriter::put_hole_dwell(std::string& to, double seconds) {
  const MotionRules& rules = control_of(to_).motion;
  if (rules.dwell_unit.value == DwellUnit::PSeconds) return put_word(to, 'P' - 'A', seconds);
  const double thousandths = std::round(seconds * 1e6) / 1e3;
  if (thousandths != std::floor(thousandths))
    return refuse("the dwell of a cycle counts thousandths of a second there");
  return put_word(to, 'P' - 'A', thousandths);
}

bool OtherWriter::put_letter(std::string& to, const NcWords& words, char letter) {
  if (drills(words)) {
    if (control_of(from_).motion.cycle_repeats.value.has(letter)) {
      put_repeats(to, letter, words[letter]);
      return true;
    }
    // A word that repeats nothing here may do so there, or be refused.
    if (letter == 'K' || letter == 'L') return true;
    if (letter == 'P') return put_hole_dwell(to, dwell_in_hole(from_.motion().view(), words));
  }
  return put_word(to, letter - 'A', value_of(words, letter - 'A'));
}

/// Write a word whose place is that of a letter and whose address is another one, OFFN: where the
/// other control has the same.
bool OtherWriter::put_lent(std::string& to, int place, const NcWords& words) {
  const std::string address = from_.code().spelling->address_of(place);
  const MotionFacts& there = facts_of(to_);
  const std::uint32_t corners = there.chamfers.mask | there.rounds.mask | there.angles.mask;
  const bool is_corner = place >= kCommaC && (corners >> place & 1) != 0;
  if (to_.code().spelling->address_of(place) != address && !is_corner)
    return refuse(control_of(to_).name + " has no word that says what " + address + " says here");
  return put_word(to, place, value_of(words, place));
}

bool OtherWriter::put_values(std::string& to, const NcWords& words) {
  std::uint32_t left = words.mask;
  const bool waits = words.codes->meaning(Group::OneShot) == Meaning::Dwell;
  words_.begin(*words.codes);
  if (waits) {
    if (const double seconds = dwell_seconds(from_.motion().view(), words);
        seconds > 0 && !put_dwell(to, seconds))
      return false;
    const MotionRules& rules = control_of(from_).motion;
    for (const char letter : rules.dwell_words.value) left &= ~bit(letter);
    for (const char letter : rules.dwell_turn_words.value) left &= ~bit(letter);
  }
  for (const char letter : kOrder) {
    const int place = letter - 'A';
    if ((left >> place & 1) == 0 || letter == 'N' || letter == 'O') continue;
    if (from_.code().spelling->lends(place)) continue;
    if (!put_letter(to, words, letter)) return false;
  }
  return put_others(to, words, left);
}

/// Write the words that have no letter of their own.
bool OtherWriter::put_others(std::string& to, const NcWords& words, std::uint32_t left) {
  for (int place = 0; place < kAddresses; ++place) {
    if ((left >> place & 1) == 0) continue;
    const bool lent = from_.code().spelling->lends(place);
    if (lent ? !put_lent(to, place, words)
             : place >= kCommaC && !put_word(to, place, value_of(words, place)))
      return false;
  }
  return true;
}

namespace {

/// Take away the blank, or the end of a line, behind what was written from `before` on.
void cut_end(std::string& to, std::size_t before) {
  if (to.size() > before && (to.back() == ' ' || to.back() == '\n')) to.pop_back();
}

}  // namespace

bool OtherWriter::write(std::string& to, const Block& block, const NcWords& words) {
  if (words.codes->all.test(at(Meaning::PositionAxes))) {
    if (!put_beside_path(to, words)) return false;
    cut_end(to, 0);
    return true;
  }
  if (words.forms.any())
    return refuse("a word counts by a form of its own, which the other control has no word for");
  if (words.has('D') &&
      control_of(from_).motion.tool_edges.value != control_of(to_).motion.tool_edges.value)
    return refuse("D names an edge of a tool on one of the controls alone");
  const std::size_t before = to.size();
  std::array<int, 1> of_move{path_code(block)};
  const bool plain = of_move[0] >= 0;
  const std::span<const int> codes = plain ? std::span<const int>(of_move) : words.codes->g();
  const bool leaves = leaves_line(words), moves = !plain && moves_by_line(words);
  if (line_is_owed_ && moves) to += code_name(facts_of(to_).codes.of(Meaning::Line).code) + " ";
  if (leaves || moves || plain || words.codes->has(Group::Motion)) line_is_owed_ = leaves;
  if (!put_codes(to, codes, leaves)) return false;
  if (!put_values(to, words) || !put_m(to, words, block.op == Op::EndProgram)) return false;
  cut_end(to, before);
  return true;
}

}  // namespace cncsub
