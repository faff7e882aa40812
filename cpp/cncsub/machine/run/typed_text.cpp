#include "cncsub/machine/run/typed_text.hpp"

#include <algorithm>

#include "cncsub/machine/calls/calls.hpp"
#include "cncsub/machine/calls/parts.hpp"
#include "cncsub/machine/run/next_block.hpp"
#include "cncsub/machine/state/layout.hpp"
#include "cncsub/machine/state/stop.hpp"

namespace cncsub {

namespace {

/// Return whether a library has variables that stand for those of the caller: they are found by
/// where these lie, which a larger level would move.
bool has_references(const Code& code) {
  return std::any_of(code.formal_parameters.begin(), code.formal_parameters.end(),
                     [](const FormalParameter& of) { return of.by_reference || of.is_array(); });
}

bool begins_with_arc_of_before(const CodeMeanings& meanings, std::size_t from) {
  const auto& blocks = meanings.blocks;
  return std::any_of(blocks.begin() + static_cast<std::ptrdiff_t>(std::min(from, blocks.size())),
                     blocks.end(), [](const BlockCodes& of) {
                       return of.all.test(static_cast<std::size_t>(Meaning::TangentArc));
                     });
}

void record_call(Run& run, OpenFrame& open) {
  const State& s = run.state;
  CallRow row;
  row.parent = run.frame().call;
  row.program = open.program;
  row.level = s.level;
  row.depth = static_cast<std::int32_t>(s.frames.size());
  row.kind = open.kind;
  row.caller_step = s.executed - 1;
  row.first_step = s.executed;
  row.last_step = -1;  // until it ends
  row.first_argument = static_cast<std::uint32_t>(run.trace.arguments.size());
  open.call = run.trace.call_number(run.trace.calls.size());
  run.trace.calls.push(row);
}

}  // namespace

std::optional<std::string> refused_text(const Run& run, const Code& with) {
  const Program& typed = with.programs.back();
  if (auto why = over(run.state.stop)) return why;
  if (typed.first == typed.last) return "no block was typed";
  const Program& before = with.programs[with.programs.size() - 2];
  const bool has_head = typed.name_length != Program::kOfFile || typed.parameters > 0;
  if (has_head || before.file == typed.file)
    return "type blocks: a program with a head of its own is a file";
  if (run.state.labels.defining || run.state.labels.searching)
    return "the program passes over a subprogram here: step on to its end first";
  if (typed.defined > 0) return "a variable cannot be defined here: write one that is there";
  const VariableLayout own = variable_layout(*run.code), its = variable_layout(with);
  if ((own.locals != its.locals || own.elements != its.elements) && has_references(with))
    return "it uses variables that the programs do not have, and these hand some over by reference";
  if (!run.motion.view().facts.keeps_heading &&
      begins_with_arc_of_before(*with.meanings, run.code->meanings->blocks.size()))
    return "an arc that goes on from the move before is computed where a program has one";
  return std::nullopt;
}

void enter_typed(Run& run, std::int32_t program, bool drops) {
  State& s = run.state;
  if (drops) leave(run, run.frame().return_to, false);
  reopen_calls(run);
  s.stop = Stop::Running;
  s.alarm.reset();
  s.waiting_for.clear();
  const Program& typed = run.code->programs[static_cast<std::size_t>(program)];
  OpenFrame open;
  open.program = program;
  open.kind = CallKind::Typed;
  open.typed = true;
  open.return_to = open.called_at = s.pc;
  open.restart = typed.first;
  open.part_end = typed.last;
  open.modal_limit = run.frame().modal_limit;
  open.loops = static_cast<std::uint32_t>(s.loops.size());
  open.copies = s.copies.size();
  if (run.trace.depth != Trace::Depth::None) record_call(run, open);
  s.frames.push_back(open);
  s.pc = typed.first;
  ++s.changes;
}

void leave_typed(Run& run) {
  const OpenFrame& open = run.frame();
  if (open.typed && open.part_end == run.state.pc && run.state.stop == Stop::Running) end_pass(run);
}

}  // namespace cncsub
