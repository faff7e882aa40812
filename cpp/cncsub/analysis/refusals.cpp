// Finds what the control refuses in a block whenever it is reached: faults, codes, calls,
// variables.
#include <algorithm>
#include <string>
#include <utility>

#include "cncsub/analysis/checker.hpp"
#include "cncsub/code/target.hpp"
#include "cncsub/code/variable_faults.hpp"
#include "cncsub/code/variables_used.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

bool is_computed(const Control& control, Meaning meaning) {
  if (meaning == Meaning::MeasureTool) return control.motion.measuring.value != Measuring::None;
  return meaning != Meaning::Uncomputed && meaning != Meaning::None && meaning != Meaning::Unknown;
}

void check_code(Checker& c, Address at, int g) {
  const bool listed = g <= 10000 && c.code.g_codes.test(static_cast<std::size_t>(g));
  const Meaning meaning = listed ? c.g_codes.find(g).meaning : Meaning::None;
  if (is_computed(*c.code.control, meaning)) return;
  Fault fault{.cause = Cause::GCodeNotAvailable,
              .detail = "the control has no " + code_name(g),
              .word = {.code = g}};
  if (meaning == Meaning::Unknown) {
    fault.cause = Cause::CodeNotKnown;
    fault.detail = "no source says whether the control has " + code_name(g);
  }
  const bool refused = meaning == Meaning::None || meaning == Meaning::Unknown;
  if (!refused) {
    fault.cause = Cause::CodeNotComputed;
    fault.detail = "cncsub does not compute the moves of " + code_name(g);
  }
  c.refused(refused ? Check::CodeMissing : Check::NotComputed, at, std::move(fault));
}

/// Return where the calls of a program begin their search, in a check of one main program.
SearchFrom search_of(const Checker& c, std::int32_t program) {
  SearchFrom from = known_search(c.code, program);
  if (c.main != kNoProgram && !is_main(c.code, c.program(program))) from.main = c.main;
  return from;
}

/// Check a call whose words are all numbers and that still has no target.
void check_call(Checker& c, Address at, std::int32_t program, const CallRecord& record) {
  if (record.constant || is_computed(record)) return;
  Target target;
  const CallOperands values{record.p.value, record.l.value, record.start().value,
                            record.device().value};
  if (auto fault = decode_call(c.code, record, values, program, target)) {
    c.refused(Check::Refused, at, std::move(*fault));
    c.unsure.push_back({program, at});
    return;
  }
  if (target.program != kNoProgram) c.unsure.push_back({target.program, at});
  if (record.kind == CallKind::Local) c.unsure.push_back({program, at});
  if (auto fault = find_target(c.code, record, target, search_of(c, program)))
    c.refused(Check::ProgramMissing, at, std::move(*fault));
  const CallChoice* const choice = chosen(c.code, record, search_of(c, program));
  if (choice != nullptr && choice->fault != CallChoice::kNone)
    c.refused(Check::Refused, at, c.code.faults[choice->fault]);
  if (target.program != kNoProgram) c.named[static_cast<std::size_t>(target.program)] = true;
  for (const CallChoice& of :
       record.extras.get().choices)  // the folder of the main program decides
    c.named[static_cast<std::size_t>(of.program)] = true;
}

/// Check the call of a part whose program and blocks are written, and found as it runs.
void check_part(Checker& c, Address at, std::int32_t program, const CallRecord& record) {
  const CallExtras& part = record.extras.get();
  if (!part.first_text.present() || record.name_text().present()) return;
  Target target;
  target.program = record.target.program;
  if (auto fault = find_target(c.code, record, target, search_of(c, program))) {
    c.refused(Check::ProgramMissing, at, std::move(*fault));
    return;
  }
  const Program& in = c.program(target.program);
  if (target.program != program) c.named[static_cast<std::size_t>(target.program)] = true;
  for (const Operand& text : {part.first_text, part.last_text}) {
    if (text.kind != Operand::Kind::Constant) continue;
    const std::string& name = c.code.texts.at(to_whole<std::size_t>(text.value));
    if (c.code.named_return_target(in, name, in.first - 1) != kNowhere) continue;
    c.refused(Check::TargetMissing, at,
              {Cause::PartIncomplete, text.at, text.width,
               "no block of " + c.code.name_of(in) + " has this label"});
  }
}

/// Report calls by a label that no file and no block has.
void check_labelled(Checker& c, Address at, std::int32_t program, const Block& block) {
  for (const CallReference& call : references_of(c.code, block, program).calls)
    if (call.found == kNoProgram && !call.computed_program && !call.program.empty())
      c.found(Check::ProgramMissing, at, call.place,
              "there is no subprogram o<" + call.program + ">");
}

void check_variable(Checker& c, Address at, const VariableReference& of, bool written) {
  if (of.number < 0 || of.computed) return;
  auto fault = written ? unwritable(c.code, of.number) : unreadable(c.code, of.number);
  const VariablePlace place = c.code.place(of.number);
  const bool statement =
      written && place.range != nullptr && place.range->access == Access::WriteOnly;
  if (!fault || statement) return;  // statements write #3000 and #3006
  fault->at = of.place.at;
  fault->width = of.place.width;
  c.refused(Check::VariableMissing, at, std::move(*fault));
}

bool has_expressions(const Code& code, const Block& block) {
  const bool extra =
      (block.flags & Block::kHasExtra) != 0 && code.cells[block.data].extra.expressions != 0;
  return extra || (block.flags & Block::kCodeExpression) != 0 || block.op > Op::Arc;
}

void check_uses(Checker& c, Address at, std::int32_t program, const Block& block) {
  const References uses = references_of(c.code, block, program);
  for (const VariableReference& of : uses.reads) check_variable(c, at, of, false);
  for (const VariableReference& of : uses.writes) check_variable(c, at, of, true);
}

bool is_of_loops(Cause cause) {
  return cause == Cause::MissingEnd || cause == Cause::MissingDo || cause == Cause::IfWithoutEnd;
}

/// Return whether a text begins with the name of a logic operation.
bool is_logic(std::string_view text) {
  std::string name;
  for (const char letter : text.substr(0, 4))
    if (is_letter(letter)) name += upper(letter);
  return name.starts_with("AND") || name.starts_with("OR") || name.starts_with("XOR");
}

/// Return whether an IF is refused because a statement or a word follows its condition directly.
bool lacks_then(const Code& code, const Program& program, const Fault& fault) {
  const IfForm form = code.control->macros.if_form.value;
  if (fault.cause != Cause::IfFormat || form == IfForm::GotoOnly || form == IfForm::Blocks)
    return false;
  const std::string_view text = code.files[program.file].text.view();
  std::size_t behind = std::min<std::size_t>(fault.at, text.size());
  std::size_t before = behind;
  while (behind < text.size() && is_blank(text[behind])) ++behind;
  if (behind == text.size() || (text[behind] != '#' && !is_letter(text[behind]))) return false;
  while (before > 0 && is_blank(text[before - 1])) --before;
  return before > 0 && text[before - 1] == ']' && !is_logic(text.substr(behind));
}

/// Return whether a refused block would have called or jumped.
bool leads_on(const Checker& c, Address at, const Program& program) {
  const Roles& roles = c.code.control->calls.roles.value;
  const std::vector<WrittenWord> words = c.code.words_of(c.code.blocks[at], program);
  return std::any_of(words.begin(), words.end(), [&](const WrittenWord& word) {
    if (word.address.empty()) return true;  // a macro statement
    if (word.address != "M" || !word.known) return false;
    const auto m = to_whole<int>(word.value);
    return roles.of_m(m) != Role::None || calls_elsewhere(roles, m);
  });
}

/// Return the letters that a block begins with after its slash and its sequence number, as
/// capitals.
std::string first_letters(std::string_view text) {
  std::size_t at = 0;
  const auto pass = [&](auto passes) {
    while (at < text.size() && passes(text[at])) ++at;
  };
  pass([](char c) { return is_blank(c) || c == '/' || is_digit(c); });
  if (at < text.size() && upper(text[at]) == 'N' && at + 1 < text.size() &&
      !is_letter(text[at + 1])) {
    ++at;
    pass([](char c) { return is_blank(c) || is_digit(c); });
  }
  std::string letters;
  for (; at < text.size() && is_letter(text[at]); ++at) letters += upper(text[at]);
  return letters;
}

/// Return whether a refused block would have begun or ended a loop or a branch. Its alarm then also
/// explains what the other blocks of the loop lack.
bool is_of_structure(const Code& code, const Program& program, const Block& block) {
  if (block.op != Op::Fault || is_of_loops(code.faults[block.aux].cause)) return false;
  const std::string_view text =
      std::string_view(code.files[program.file].text.view()).substr(block.text, block.length);
  const std::string first = first_letters(text);
  for (const std::string_view word : {"WH", "DO", "EN", "EL"})
    if (first.starts_with(word)) return true;
  const IfForm form = code.control->macros.if_form.value;
  const bool jumps = text.find("GO") != std::string_view::npos;
  return first.starts_with("IF") &&
         (form == IfForm::Blocks || (form == IfForm::ThenBlocks && !jumps));
}

bool is_of_variable(Cause cause) {
  return cause == Cause::IllegalVariable || cause == Cause::VariableNotKnown ||
         cause == Cause::VariableWriteProtected || cause == Cause::VariableReadProtected ||
         cause == Cause::VacantAssigned;
}

void check_fault(Checker& c, Address at, const Program& program, const Fault& fault,
                 bool structure_refused) {
  if (structure_refused && is_of_loops(fault.cause)) return;
  Check check = Check::Refused;
  if (leads_on(c, at, program)) c.unsure.push_back({c.code.program_at(at), at});
  if (fault.cause == Cause::JumpTargetNotFound) check = Check::TargetMissing;
  if (is_of_loops(fault.cause)) check = Check::LoopUnclosed;
  if (fault.cause == Cause::CodeNotComputed) check = Check::NotComputed;
  if (fault.cause == Cause::GCodeNotAvailable || fault.cause == Cause::CodeNotKnown)
    check = Check::CodeMissing;
  if (is_of_variable(fault.cause)) check = Check::VariableMissing;
  if (lacks_then(c.code, program, fault)) check = Check::IfWithoutThen;
  c.refused(check, at, fault);
}

/// Check an arc to a point that has neither a centre nor a radius, where the control refuses one.
void check_arc(Checker& c, Address at, const Block& block) {
  constexpr std::uint32_t kAxes = bit('X') | bit('Y') | bit('Z') | bit('U') | bit('V') | bit('W');
  constexpr std::uint32_t kPlain = kAxes | bit('F') | bit('S') | bit('T') | bit('D') | bit('H');
  if (block.op != Op::Words || (block.mask & kAxes) == 0 || (block.mask & ~kPlain) != 0) return;
  if (c.code.control->motion.no_radius.value != NoRadius::Alarm) return;
  int arc = -1;
  bool alone = true;
  each_g(c.code, block, [&](int g) {
    const GCode code = c.g_codes.find(g);
    const bool turns = code.meaning == Meaning::Cw || code.meaning == Meaning::Ccw;
    if (turns) arc = g;
    alone = alone && (turns || (code.group != Group::Motion && code.group != Group::OneShot &&
                                code.group != Group::Cycle));
  });
  if (arc >= 0 && alone)
    c.refused(Check::Refused, at, {.cause = Cause::NoRadius, .detail = {}, .word = {.code = arc}});
}

/// Mark a program as unsure: the words that a call drops may have said where it begins.
void mark_dropped(Checker& c, Address at, std::int32_t program, const CallRecord& record) {
  const bool known = record.constant && record.target.program != kNoProgram;
  c.unsure.push_back({known ? record.target.program : program, at});
}

void check_block(Checker& c, Address at, std::int32_t program, bool structure_refused) {
  const Block& block = c.code.blocks[at];
  const auto look = [&](const Block& of) {
    each_g(c.code, of, [&](int g) { check_code(c, at, g); });
    if (of.op == Op::Fault)
      check_fault(c, at, c.program(program), c.code.faults[of.aux], structure_refused);
    if (is_call(of.op)) check_call(c, at, program, c.code.calls[of.aux]);
    if (of.op == Op::RepeatPart) check_part(c, at, program, c.code.calls[of.aux]);
    if (is_call(of.op) && (of.flags & Block::kDrops) != 0)
      mark_dropped(c, at, program, c.code.calls[of.aux]);
    if (of.op == Op::Words && of.g_count != 0) check_arc(c, at, of);
    if (plain_code(c, of) >= 0) c.unsure.push_back({program, at});
  };
  each_variant(c.code, block, look);
  if (block.op == Op::Select && c.code.selects[block.aux].of_called && c.is_called(program))
    each_variant(c.code, c.code.variants[c.code.selects[block.aux].second], look);
  if (block.op == Op::OWord) check_labelled(c, at, program, block);
  if (has_expressions(c.code, block) && block.op != Op::Fault) check_uses(c, at, program, block);
}

}  // namespace

void check_refusals(Checker& c) {
  for (const ProgramFlow& flow : c.flows) {
    if (c.inside(flow)) continue;
    bool refused = false;
    for (Address at = flow.first(); at < flow.last() && !refused; ++at)
      refused = is_of_structure(c.code, c.program(flow.program()), c.code.blocks[at]);
    for (Address at = flow.first(); at < flow.last() && !c.over(4); ++at)
      check_block(c, at, flow.program(), refused);
  }
}

}  // namespace cncsub
