// Finds values that people trip over.
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/analysis/checker.hpp"
#include "cncsub/analysis/points.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

/// Report a length without a point. One finding of a program has them all, and names the first.
void tell_no_point(Checker& c, Address at, TextPlace place) {
  const std::int32_t program = c.code.program_at(at);
  if (c.known(Check::NoPoint, std::to_string(program), at, place)) return;
  const std::string_view text = c.code.files[c.program(program).file].text.view();
  c.found(Check::NoPoint, at, place,
          std::string(text.substr(place.at, place.width)) +
              " is counted in increments of the control, a thousandth of a millimetre or less");
}

/// Return whether an argument of a macro is a small whole number that the control takes as
/// increments.
bool counts_increments(const Argument& argument) {
  const Operand& value = argument.operand;
  constexpr std::string_view kScaled = "ABCIJKQRUVWXYZ";
  return value.whole && value.kind == Operand::Kind::Constant && value.value != 0 &&
         std::fabs(value.value) < kFewIncrements &&
         kScaled.find(argument.address) != std::string_view::npos;
}

void check_arguments(Checker& c, Address at) {
  each_variant(c.code, c.code.blocks[at], [&](const Block& block) {
    if (!is_call(block.op)) return;
    const CallRecord& record = c.code.calls[block.aux];
    for (std::uint32_t i = 0; i < record.arguments; ++i) {
      const Argument& argument = c.code.arguments[record.first_argument + i];
      if (counts_increments(argument))
        tell_no_point(c, at, {argument.operand.at, argument.operand.width});
    }
  });
}

Points points_of(const Checker& c, const Block& block) {
  return points_of(c.code, block, c.g_codes, c.machine);
}

/// Return the programs that write points, and those that call one or are called by one, directly or
/// not: programs that belong together are written alike.
std::vector<bool> writing_points(const Checker& c) {
  std::vector<bool> found(c.flows.size(), false);
  if (!counts_increments(c.code)) return found;
  std::vector<std::int32_t> waiting;
  for (const ProgramFlow& flow : c.flows)
    for (Address at = flow.first(); at < flow.last() && !c.over(); ++at)
      if (points_of(c, c.code.blocks[at]).with != 0) {
        waiting.push_back(flow.program());
        break;
      }
  while (!waiting.empty() && !c.over()) {
    const std::int32_t program = waiting.back();
    waiting.pop_back();
    if (found[static_cast<std::size_t>(program)]) continue;
    found[static_cast<std::size_t>(program)] = true;
    for (const CallEdge& edge : c.flow(program).calls()) waiting.push_back(edge.called);
    for (const CallEdge* edge : c.callers_of(program)) waiting.push_back(edge->caller);
  }
  return found;
}

void check_points(Checker& c, const ProgramFlow& flow) {
  std::vector<Address> without;
  for (Address at = flow.first(); at < flow.last() && !c.over(); ++at)
    if (points_of(c, c.code.blocks[at]).without != 0) without.push_back(at);
  const Program& program = c.program(flow.program());
  for (const Address at : without) {
    const Block& block = c.code.blocks[at];
    const std::uint32_t addresses = points_of(c, block).without;
    for (const WrittenWord& word : c.code.words_of(block, program)) {
      const bool meant = word.address.size() == 1 && word.address[0] >= 'A' &&
                         word.address[0] <= 'Z' && (addresses & bit(word.address[0])) != 0;
      if (meant)
        tell_no_point(c, at,
                      {static_cast<std::uint32_t>(block.text + word.at),
                       static_cast<std::uint32_t>(word.width)});
    }
  }
  for (Address at = flow.first(); at < flow.last(); ++at)
    if (may_call(c.code.blocks[at].op)) check_arguments(c, at);
}

void check_call(Checker& c, Address at, const CallRecord& record) {
  const auto constant = [](const Operand& of) { return of.kind == Operand::Kind::Constant; };
  if (constant(record.l) && record.l.value == 0 &&
      c.code.control->calls.zero_repeats.value != ZeroRepeats::Alarm)
    c.found(Check::NoRepeats, at, {record.l.at, record.l.width},
            c.code.control->calls.zero_repeats.value == ZeroRepeats::Skip
                ? "the control skips the call"
                : "the control calls once");
  if (!record.constant || record.kind != CallKind::Subprogram || !constant(record.p)) return;
  const auto whole = to_whole<std::int64_t>(record.p.value);
  if (record.target.program_number < 0 || record.target.program_number == whole) return;
  if (c.code.find(whole) == kNoProgram) return;
  c.found(
      Check::CountInP, at, {record.p.at, record.p.width},
      "it calls O" + std::to_string(record.target.program_number) + ", " +
          (record.target.repeats == 1 ? "once" : std::to_string(record.target.repeats) + " times") +
          ", while O" + std::to_string(whole) + " exists");
}

/// Return the code that this control has instead.
std::string instead_of(const Checker& c, int m) {
  const CallRules& calls = c.code.control->calls;
  const auto code = [&calls](Role role) {
    const auto found = calls.roles.value.code_of(role);
    return found ? found->text() : "";
  };
  const auto or_else = [](const std::string& first, const std::string& other) {
    return first.empty() ? other : first;
  };
  std::string call = or_else(code(Role::Call), code(Role::MacroCall));
  if (m == 99) return or_else(code(Role::Return), "");
  if (m == 198) return or_else(code(Role::ExternalCall), call);
  if (m == 98) return call;
  std::string own = or_else(code(Role::LocalCall), code(Role::Jump));
  if (!own.empty()) return own;
  if (calls.start_word.value == StartWord::Q) return call + " with Q";
  if (calls.start_word.value == StartWord::H) return call + " with H";
  return c.code.lacks(StatementKind::Goto, 0) ? call : "GOTO, or " + call;
}

void check_plain_code(Checker& c, Address at, const Block& block) {
  const int m = plain_code(c, block);
  if (m < 0) return;
  const std::string name = "M" + std::to_string(m), near = instead_of(c, m);
  c.found(Check::PlainCode, at, {block.text, block.length},
          name + " is only sent to the machine" +
              (near.empty() ? "" : "; the nearest on this control is " + near));
}

/// Return the parameter that sets a rule, in words; empty where none does.
std::string parameter_of(const Checker& c, std::string_view rule) {
  for (const Parameter& parameter : c.code.control->parameters)
    for (const Setting& setting : parameter.sets)
      if (setting.rule == rule)
        return " (parameter " + parameter.name + ", " + parameter.meaning + ")";
  return "";
}

/// Return why the control does not obey a word, as far as its address shows.
std::string dropped(const Checker& c, const Block& block, std::string_view text, const Drop& drop) {
  const char letter = drop.at < text.size() ? upper(text[drop.at]) : '\0';
  const int most = c.code.control->reading.m_codes_per_block.value;
  if (letter == 'M')
    return "of several M codes in a block the control executes only " +
           (most == 1 ? std::string("the last") : "the last " + std::to_string(most)) +
           parameter_of(c, "m_codes_per_block");
  if (is_call(block.op) && (letter == 'Q' || letter == 'H'))
    return std::string("calls on this control have no word ") + letter +
           parameter_of(c, "start_word");
  if (!is_call(block.op))
    return std::string(1, letter) + " is in the block twice: the control uses the last one";
  return "the control ignores it";
}

/// Return what this control takes in place of a word that it does not obey; empty where there is
/// nothing to suggest.
std::string instead_of(const Checker& c, const Block& block, std::string_view text,
                       const Drop& drop) {
  if (drop.at >= text.size()) return "";
  const char letter = upper(text[drop.at]);
  if (!is_call(block.op)) return letter == 'M' ? "" : "keep one of the two words";
  const StartWord start = c.code.control->calls.start_word.value;
  const std::string value(text.substr(drop.at + 1, drop.width - 1));
  if (letter == 'L' && block.op == Op::Call)
    return "write the count before the number: `M98 P30002`";
  if (letter != 'Q' && letter != 'H') return "";
  if (start == StartWord::None)
    return std::string("remove ") + letter +
           ": a call starts at the head; to start at that block, make it the head of a program of "
           "its own";
  const char own = start == StartWord::Q ? 'Q' : 'H';
  return std::string("write ") + own + value + " for " + letter + value + ": " + own +
         " names the block at which a call starts";
}

/// Report a word of an offset, such as D1, that the control obeys and a run leaves out. A word that
/// is a name, such as BRISK, changes no path.
void tell_left_out(Checker& c, Address at, std::string_view text, const Drop& drop) {
  const std::string_view word = text.substr(std::min<std::size_t>(drop.at, text.size()), 2);
  if (word.empty() || !is_letter(upper(word[0]))) return;
  if (word.size() == 2 && is_letter(word[1])) return;
  Finding& found = c.found(
      Check::NotComputed, at, {drop.at, drop.width},
      std::string(1, upper(word[0])) + " is not computed by cncsub: a run goes on without it");
  found.hint =
      "leave the program as it is, and check these moves yourself: a run makes them without this "
      "word";
}

void check_drops(Checker& c, Address at, const Block& block) {
  if ((block.flags & Block::kDrops) == 0 || plain_code(c, block) >= 0) return;
  if (block.op == Op::Fault) return;  // its alarm reports it
  auto drop = std::lower_bound(c.code.drops.begin(), c.code.drops.end(), block.data,
                               [](const Drop& of, std::uint32_t data) { return of.data < data; });
  const std::string_view text = c.code.files[c.program(c.code.program_at(at)).file].text.view();
  for (; drop != c.code.drops.end() && drop->data == block.data; ++drop) {
    if (c.code.spelling->ignores_words)
      c.found(Check::Dropped, at, {drop->at, drop->width}, dropped(c, block, text, *drop)).hint =
          instead_of(c, block, text, *drop);
    else
      tell_left_out(c, at, text, *drop);
  }
}

/// Report G99 as the last block of a program that nothing else ends.
void check_last(Checker& c, const ProgramFlow& flow) {
  if (!means_m99(c, flow)) return;
  const Block& block = c.code.blocks[flow.last() - 1];
  Finding& found = c.found(Check::G99ForM99, flow.last() - 1, {block.text, block.length},
                           "G99 does not return: the program runs to the end of its text");
  if (c.code.control->reading.missing_end.value != MissingEnd::Alarm) return;
  found.alarm = Fault{Cause::EndOfRecord, c.program(flow.program()).text_end, 1, found.detail};
  found.alarm_block = flow.last();
}

}  // namespace

int plain_code(const Checker& c, const Block& block) {
  const Control& control = *c.code.control;
  if (block.op != Op::Words || block.m_count == 0 || block.g_count != 0) return -1;
  const bool p = (block.mask & bit('P')) != 0;
  const CodeList codes = c.code.codes_of(block);
  for (const int m : codes.m()) {
    const Spelling::Codes& own = c.code.spelling->own_m_codes;
    const bool of_machine = m >= own.first && m <= own.last;
    if (calls_elsewhere(control.calls.roles.value, m) && !of_machine && (p || m == 98 || m == 99))
      return m;
  }
  return -1;
}

bool means_m99(const Checker& c, const ProgramFlow& flow) {
  constexpr int kG99 = 990;
  const bool returns = c.code.control->calls.roles.value.of_m(99) == Role::Return;
  if (flow.last() == flow.first() || !returns) return false;
  if (flow.ever_returns() || flow.program() == c.main) return false;
  const Block& block = c.code.blocks[flow.last() - 1];
  if (block.op != Op::Words || (block.mask & ~bit('P')) != 0 || block.m_count != 0) return false;
  bool g99 = false;
  each_g(c.code, block, [&](int g) { g99 = block.g_count == 1 && g == kG99; });
  return g99;
}

void check_values(Checker& c) {
  const std::vector<bool> points = writing_points(c);
  for (const ProgramFlow& flow : c.flows) {
    if (c.inside(flow)) continue;
    if (c.over(flow.size())) return;
    if (points[static_cast<std::size_t>(flow.program())]) check_points(c, flow);
    check_last(c, flow);
    for (Address at = flow.first(); at < flow.last() && !c.over(); ++at)
      each_variant(c.code, c.code.blocks[at], [&](const Block& block) {
        check_drops(c, at, block);
        check_plain_code(c, at, block);
        if (is_call(block.op)) check_call(c, at, c.code.calls[block.aux]);
      });
  }
}

}  // namespace cncsub
