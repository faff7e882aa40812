// Lines of words, assignments and comments.
#include "cncsub/dialect/grblhal/block.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cncsub/code/operand_of.hpp"
#include "cncsub/dialect/grblhal/codes.hpp"
#include "cncsub/dialect/ngc_lines.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub::grblhal {

namespace {

constexpr std::size_t kLongestLine = 256;  // characters [gHpr, LINE_BUFFER_SIZE]
constexpr std::size_t kMostAssignments =
    10;  // numbered ones [gHc, NGC_N_ASSIGN_PARAMETERS_PER_BLOCK]
constexpr double kLastProgram = 65535;

/// Return the hundredths of a code, as the control has them.
int hundredths(double value) {
  return to_whole<int>(std::round(100 * (value - std::trunc(value))));
}

}  // namespace

bool BlockReader::refuse(Block& block, Cause cause, std::string detail, std::uint32_t at,
                         Kind kind) {
  to_.refuse(block, Fault{.cause = cause,
                          .at = at,
                          .width = line_.width_from(at),
                          .detail = std::move(detail),
                          .kind = kind});
  return false;
}

bool BlockReader::refuse(Block& block) {
  if (auto fault = std::exchange(expression_.fault, std::nullopt))
    to_.refuse(block, std::move(*fault));
  return false;
}

bool BlockReader::read(std::string_view text, Block& block, Flow& flow) {
  line_.set(text, block.text);
  expression_.begin_line();
  expression_.fault.reset();
  if (text.size() > kLongestLine) {
    flow.wall = true;
    refuse(block, Cause::BlockTooLong, "the line has more than 256 characters", block.text);
    return true;
  }
  if (line_.peek() == '$') {  // [gHpr, protocol_main_loop]
    flow.wall = true;
    while (!line_.at_end()) line_.take();
    refuse(block, Cause::CodeNotComputed, "a command of the system", block.text);
    return true;
  }
  if (line_.take('/')) block.skip = 1u << 1;
  Words words;
  return this->words(block, words, flow) || flow_word(block, flow);
}

/// Read the words of a line. Return false where a flow word begins. Where a line is passed over,
/// its first word is read all the same.
bool BlockReader::words(Block& block, Words& words, Flow& flow) {
  while (!line_.at_end()) {
    const bool first = !words.any && words.statements.empty();
    const char c = line_.peek();
    if (first && c == 'o') return false;
    words.bad_value = false;
    if (!item(block, words)) {
      flow.wall = first && c != '#' && words.bad_value;
      return true;
    }
  }
  if (!words.any && words.statements.empty() && !words.print && block.n < 0) return true;
  if (words.macro >= 0) return call_65(block, words), true;
  if (!refuse_wrong(block, words.line)) write(block, words);
  return true;
}

bool BlockReader::refuse_wrong(Block& block, const LineWords& line) {
  const auto wrong = wrong_word(line);
  if (!wrong) return false;
  const auto letter = static_cast<std::size_t>(wrong->letter - 'a');
  to_.refuse(block, Fault{.cause = wrong->cause,
                          .at = line.at[letter],
                          .width = line.width[letter],
                          .detail = wrong->detail,
                          .kind = wrong->kind});
  return true;
}

bool BlockReader::item(Block& block, Words& words) {
  const std::uint32_t at = line_.offset();
  const std::string_view character = first_character(line_.rest());
  const char c = line_.take();
  if (c == ';') {
    while (!line_.at_end()) line_.take();
    return true;
  }
  if (c == '(') return comment(block, words);
  if (c == ')') return true;  // the control leaves it out
  if (c == '#') return assignment(block, words);
  if (c >= 'a' && c <= 'z') return word(block, words, c);
  line_.take(character.substr(1));
  words.bad_value = true;
  return refuse(block, Cause::IllegalCharacter, "a word begins with a letter", at);
}

bool BlockReader::word(Block& block, Words& words, char letter) {
  const std::uint32_t at = line_.offset(line_.place() - 1);
  const auto place = static_cast<std::size_t>(letter - 'a');
  Value value;
  words.any = words.any || letter != 'n';
  words.bad_value = !(letter == 'l' ? expression_.eight_bits(value) : expression_.value(value));
  if (words.bad_value) return refuse(block);
  value.at = at;
  value.width = line_.width_from(at);
  words.line.at[place] = at;
  words.line.width[place] = value.width;
  if (letter == 'g') return g_code(block, words, value);
  if (letter == 'm') return m_code(block, words, value);
  if ((letter == 'l' || letter == 'o') && !value.computed && hundredths(value.number) > 0)
    return refuse(block, Cause::WholeNumberExpected, "the value is not whole", at);
  if (!words.line.letters.insert(letter).second)
    return refuse(block, Cause::AddressGivenTwice, "a word of this letter stands before it", at);
  if ((letter == 'l' || letter == 'n' || letter == 'o') && !value.computed && value.number < 0)
    return refuse(block, Cause::IllegalMinusSign, "the value is below zero", at);
  words.values[place] = value;
  if (letter == 'l' && !value.computed)  // eight bits are kept
    value.number = static_cast<double>(to_whole<std::int64_t>(std::min(value.number, 1e9)) & 255);
  words.line.values[place] = value.computed ? std::nullopt : std::optional(value.number);
  if (letter == 'n') {
    if (!value.computed && value.number < 1e9) block.n = to_whole<std::int32_t>(value.number);
    return true;
  }
  if (letter == 'o') return refuse(block, Cause::AddressNotUsable, "nothing uses the O", at);
  words.values[place] = value;
  words.list.set(letter - 'a', word_of(value), false);
  return true;
}

/// Record a code of a group. One code of each group may stand in a line.
bool BlockReader::group(Block& block, Words& words, int group, const Value& value) {
  if (group == 0 || words.groups.insert(group).second) return true;
  return refuse(block, Cause::GroupGivenTwice, "another code of its group stands before it",
                value.at);
}

/// Return the code of a G word, ten times its number; nothing where the control refuses it.
std::optional<int> BlockReader::known_g(Block& block, const Value& value) {
  constexpr const char* kNone = "the control has no such G code";
  if (value.number < 0 || value.number > 999) {
    refuse(block, Cause::GCodeNotAvailable, kNone, value.at);
    return std::nullopt;
  }
  const int number = to_whole<int>(value.number);
  const int rest = hundredths(value.number);
  const int code = number * 10 + rest / 10;
  const bool has = to_.control().reading.g_codes.value.has(code) && group_of_g(code) >= 0;
  if (rest % 10 == 0 && has) return code;
  const bool fraction = rest != 0 && group_of_g(number * 10) >= 0 && !has_fractions(number);
  refuse(block, Cause::GCodeNotAvailable, kNone, value.at, fraction ? kNotWhole : Kind{});
  return std::nullopt;
}

bool BlockReader::g_code(Block& block, Words& words, const Value& value) {
  words.line.computed = words.line.computed || value.computed;
  if (value.computed) {
    if (words.list.g_count < static_cast<int>(kGCodesOfBlock)) words.list.add_g(word_of(value));
    return true;
  }
  const std::optional<int> known = known_g(block, value);
  if (!known) return false;
  const int code = *known;
  if (claims_axes(code) && std::exchange(words.claimed, true))
    return refuse(block, Cause::OneShotWithMotion, "another code of the line takes its axis words",
                  value.at);
  if (code == 500 || code == 510) words.claimed = true;
  words.machine = words.machine || code == 530;
  if (code == 660 || code == 661)
    return refuse(block, Cause::CodeNotComputed,
                  "cncsub does not compute the calls of G66 and G66.1", value.at);
  const Role role = to_.control().calls.roles.value.of_g(code);
  const bool calls = role == Role::MacroCall;
  if (calls) words.macro = code;
  if (!group(block, words, group_of_g(code), value)) return false;
  words.line.g.push_back(code);
  if (calls || role == Role::CancelModal) return true;
  if (words.list.g_count == static_cast<int>(kGCodesOfBlock))
    return refuse(block, Cause::TooManyWords, "too many G codes", value.at);
  words.list.add_g({false, 0, static_cast<double>(code)});
  return true;
}

bool BlockReader::m_code(Block& block, Words& words, const Value& value) {
  words.values['m' - 'a'] = value;
  if (words.macro >= 0) {  // an argument
    if (words.line.letters.insert('m').second) return true;
    return refuse(block, Cause::AddressGivenTwice, "a word of this letter stands before it",
                  value.at);
  }
  words.line.computed = words.line.computed || value.computed;
  if (value.computed) {
    if (words.list.m_count < static_cast<int>(kMCodesOfBlock)) words.list.add_m(word_of(value));
    return true;
  }
  const int code = to_whole<int>(std::clamp(value.number, -1.0, 1e6));
  if (code <= 99 && hundredths(value.number) > 0)
    return refuse(block, Cause::WholeNumberExpected, "the control has no such M code", value.at);
  const int group_of = group_of_m(code);
  if (group_of < 0)
    return refuse(block, Cause::MCodeNotAvailable, "the control has no such M code", value.at);
  if (!group(block, words, group_of, value)) return false;
  words.line.m.push_back(code);
  if (words.list.m_count == static_cast<int>(kMCodesOfBlock))
    return refuse(block, Cause::TooManyWords, "too many M codes", value.at);
  const Role role = to_.control().calls.roles.value.of_m(code);
  words.ends = words.ends || role == Role::End;
  if (role == Role::Call || role == Role::Return)
    words.role = role;
  else
    words.list.add_m({false, 0, static_cast<double>(code)});
  return true;
}

/// Read an assignment. A named variable takes its value at once, a numbered one when its line has
/// run; of several of one number the first counts. [gHg, gc_execute_block]
bool BlockReader::assignment(Block& block, Words& words) {
  Place place;
  Value value;
  Statement statement;
  statement.variable_at = line_.offset(line_.place() - 1);
  if (!expression_.place(place)) return refuse(block);
  statement.variable_width = line_.width_from(statement.variable_at);
  if (!line_.take('='))
    return refuse(block, Cause::MissingEquals, "an equals sign must stand here", line_.offset());
  if (!expression_.value(value)) return refuse(block);
  const std::uint32_t width = line_.width_from(statement.variable_at);
  if (place.target == Statement::Target::None) {  // it keeps the value that the control gives it
    to_.drop(statement.variable_at, width);
    words.any = true;
    return true;
  }
  ngc_assign(to_, statement, place, value);
  if (!place.name.empty()) {
    expression_.set_here(place.name, value);
    words.named.push_back(statement);
    words.statements.push_back(statement);
    return true;
  }
  if (words.lost.size() == kMostAssignments)
    return refuse(block, Cause::TooManyWords, "a line has at most ten assignments",
                  statement.variable_at);
  words.lost.push_back(statement.variable_at);
  words.lost_width.push_back(width);
  words.statements.insert(words.statements.begin(), statement);
  return true;
}

void BlockReader::write(Block& block, Words& words) {
  if (words.role == Role::Call) return call_98(block, words);
  if (words.role == Role::Return) return back_99(block, words);
  if (words.machine) words.list.forms.absolute = kEndWords;  // G53 takes machine coordinates always
  ngc_write(to_, block, words);
}

// ---- M98, M99, G65 ----

/// Read P and L, the program that a line calls and how often.
bool BlockReader::program_of_call(Block& block, Words& words, CallRecord& call) {
  if (!words.line.has('p'))
    return refuse(block, Cause::ProgramNumberMissing, "the call has no P", call.at);
  const Value& p = words.values['p' - 'a'];
  const auto refuse_p = [&](Cause cause, const char* detail) {
    to_.refuse(block, Fault{.cause = cause, .at = p.at, .width = p.width, .detail = detail});
    return false;
  };
  if (!p.computed && p.number > kLastProgram)
    return refuse_p(Cause::IllegalProgramNumber, "P is at most 65535");
  if (!p.computed && p.number >= 1 && p.number < 8)
    return refuse_p(Cause::CodeNotComputed, "the macros 1 to 7 are the control's own");
  if (!p.computed && p.number < 100)
    return refuse_p(Cause::IllegalProgramNumber, "the macros of files begin at 100");
  call.p = operand_of(p);
  if (!p.computed) call.p.value = std::trunc(p.number);
  if (words.line.has('l')) call.l = operand_of(words.values['l' - 'a']);
  for (std::size_t i = 0; i < words.lost.size(); ++i) to_.drop(words.lost[i], words.lost_width[i]);
  return true;
}

/// Write M98 after the other words of its line. The line's assignments to numbers are lost.
void BlockReader::call_98(Block& block, Words& words) {
  CallRecord call;
  call.kind = CallKind::Subprogram;
  call.at = words.line.at['m' - 'a'];
  call.width = words.line.width['m' - 'a'];
  if (!program_of_call(block, words, call)) return;
  words.list.mask &= ~(bit('P') | bit('L'));
  Block own = block;
  to_.words(own, words.list);
  const Flow at{.at = call.at, .width = call.width};
  to_.become(own, Op::Call, std::move(call));
  forget_and(block, at, own, words.named);
}

void BlockReader::back_99(Block& block, Words& words) {
  CallRecord back;
  back.at = words.line.at['m' - 'a'];
  back.width = words.line.width['m' - 'a'];
  to_.words(block, words.list);
  to_.become(block, Op::Return, std::move(back));
}

/// Write G65, whose line has arguments and nothing else. [gHg, macro_arguments_push]
void BlockReader::call_65(Block& block, Words& words) {
  struct Letter {
    char letter;
    std::int16_t variable;
  };
  constexpr Letter kArguments[] = {{'a', 1},  {'b', 2},  {'c', 3},  {'i', 4},  {'j', 5},  {'k', 6},
                                   {'d', 7},  {'e', 8},  {'f', 9},  {'h', 11}, {'m', 13}, {'q', 17},
                                   {'r', 18}, {'s', 19}, {'t', 20}, {'u', 21}, {'v', 22}, {'w', 23},
                                   {'x', 24}, {'y', 25}, {'z', 26}};
  CallRecord call;
  call.kind = CallKind::Macro;
  call.macro = true;
  call.locals = CallRecord::Locals::Own;
  call.at = words.line.at['g' - 'a'];
  call.width = words.line.width['g' - 'a'];
  if (!program_of_call(block, words, call)) return;
  if (!words.line.m.empty()) words.line.letters.insert('m');
  std::vector<Argument> arguments;
  for (const Letter& of : kArguments) {
    if (!words.line.has(of.letter)) continue;
    const auto letter = static_cast<char>(of.letter - 'a' + 'A');
    const auto place = static_cast<std::size_t>(of.letter - 'a');
    arguments.push_back({of.variable, letter, operand_of(words.values[place])});
  }
  const Flow at{.at = call.at, .width = call.width};
  hand_on_locals(arguments, at, kLastLocal + 1);
  call.first_argument = to_.next_argument();
  call.arguments = static_cast<std::uint32_t>(arguments.size());
  for (const Argument& argument : arguments) to_.keep(argument);
  for (int i = 0; i < words.list.g_count; ++i) to_.drop(call.at, call.width);
  Block own = block;
  to_.words(own, {});
  to_.become(own, Op::MacroCall, std::move(call));
  forget_and(block, at, own, words.named);
}

}  // namespace cncsub::grblhal
