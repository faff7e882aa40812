#include "cncsub/machine/run/next_block.hpp"

#include "cncsub/machine/calls/o_word_nesting.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/statements/statements.hpp"

namespace cncsub {

std::optional<std::string> over(Stop stop) {
  switch (stop) {
    case Stop::End:
    case Stop::Cycles:
      return "the program has ended: go back, or reset the machine";
    case Stop::Limit:
      return "the run has reached a limit of blocks, time or memory";
    case Stop::Running:
    case Stop::Alarm:
    case Stop::Waiting:
    case Stop::Interrupted:
      break;
  }
  return std::nullopt;
}

namespace {

std::string line_of(const Run& run, Address at) {
  return "line " + std::to_string(run.code->blocks[at].line);
}

/// Return why the program that runs cannot go on at a block, by where the two stand.
std::optional<std::string> out_of_reach(const Run& run, Address to) {
  const Code& code = *run.code;
  const OpenFrame& open = run.frame();
  const Address pc = run.state.pc;
  const std::int32_t of = code.program_at(to);
  // A program may run on into another one that stands inside it; before its head it has not yet.
  const bool inside =
      of == code.program_at(pc) && pc != code.programs[static_cast<std::size_t>(of)].first;
  if (of != open.program && !inside)
    return line_of(run, to) + " is a block of " + code.name_of(of) + "; the program that runs is " +
           code.name_of(open.program);
  if (open.part_end != kNowhere && (to < open.restart || to >= open.part_end))
    return line_of(run, to) + " is outside the part that is repeated, which begins on " +
           line_of(run, open.restart);
  if (code.leads_inside(pc, to))
    return line_of(run, to) + " is inside a control structure that the program does not stand in";
  if (const Address head = entered_by_jump(code, pc, to); head != kNowhere)
    return line_of(run, to) + " is inside the branch or the loop that begins on " +
           line_of(run, head) + ", and the program does not stand in it";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> set_next_block(Run& run, Address to) {
  State& s = run.state;
  if (auto reason = over(s.stop)) return reason;
  if (auto reason = out_of_reach(run, to)) return reason;
  if (compensating(run.motion.state()) && run.refuses(Cause::JumpInCompensation))
    return "the control refuses a jump while the radius offset is on";
  leave_loops(run, to);
  leave_o_words(run, to);
  reopen_calls(run);
  run.frame().passes_left = -1;
  s.stop = Stop::Running;
  s.alarm.reset();
  s.waiting_for.clear();
  s.pc = to;
  ++s.changes;
  return std::nullopt;
}

}  // namespace cncsub
