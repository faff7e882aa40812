#include "cncsub/machine/calls/returns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cncsub/control/spelled.hpp"
#include "cncsub/machine/calls/calls.hpp"
#include "cncsub/machine/calls/modal.hpp"
#include "cncsub/machine/calls/words.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/statements/statements.hpp"
#include "cncsub/machine/values/expressions.hpp"
#include "cncsub/machine/values/texts.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

/// A computed sequence number; -1, which no block has, where the value is none.
std::int64_t number_of(double value) {
  const double n = is_vacant(value) ? -1 : std::round(value);
  return to_whole<std::int64_t>(std::clamp(n, -1.0, 2e9));
}

bool no_block(Run& run, Cause cause, const Operand& word, double value, const Program& program) {
  const double n = is_vacant(value) ? -1 : std::clamp(std::round(value), -1e9, 2e9);
  return alarm(
      run, {cause, word.at, word.width, run.code->no_block(to_whole<std::int64_t>(n), program)});
}

/// Go on at the first block N(p) of the running program, which may stand in a loop or not.
bool go_to_own_block(Run& run, Cause otherwise, const Operand& word, double p) {
  const Address to = run.code->first_of(run.program(), number_of(p));
  if (to == kNowhere) return no_block(run, otherwise, word, p, run.program());
  record_block(run);
  leave_loops(run, to);
  run.state.pc = to;
  return true;
}

/// Return why an M99 is refused under a modal macro call or the radius offset, or nothing.
std::optional<Fault> refused(const Run& run, const Block& block, const CallRecord& back, double p) {
  const Control& control = run.control();
  const bool modal_active = !run.state.modals.empty() && run.frame().modal < 0;
  if (modal_active && !is_vacant(p) && control.calls.calls_in_modal.value == CallsInModal::EndModal)
    return Fault{Cause::CallInModalCall, back.at, back.width,
                 "M99 P while a modal macro call is active"};
  if (!is_vacant(p) && compensating(run.motion.state()) && run.refuses(Cause::ReturnInCompensation))
    return Fault{Cause::ReturnInCompensation, back.p.at, back.p.width,
                 "M99 P while the radius offset is on"};
  if (!run.state.modals.empty() && has_words(block) && run.refuses(Cause::IllegalWordWithReturn))
    return Fault{Cause::IllegalWordWithReturn, back.at, back.width,
                 "M99 with other words while a modal macro call is active"};
  return std::nullopt;
}

/// Return the word of a return that names a line of the caller's file. One by values has none: what
/// stands there says something else.
const Operand& line_of(const CallRecord& back) { return back.extras.get().after; }

/// Return the block of a program that stands on a line of its file, or the next one after it;
/// kNowhere where the program has none.
Address block_of_line(const Code& code, const Program& program, double line) {
  const double whole = std::round(line);
  if (whole < program.line || whole >= 4e9) return kNowhere;
  const auto first = code.blocks.begin() + program.first, last = code.blocks.begin() + program.last;
  const auto found =
      std::lower_bound(first, last, to_whole<std::uint32_t>(whole),
                       [](const Block& of, std::uint32_t wanted) { return of.line < wanted; });
  return found == last ? kNowhere : static_cast<Address>(found - code.blocks.begin());
}

bool no_line(Run& run, const Operand& word, double line, const Program& program) {
  return alarm(run, {Cause::ReturnTargetNotFound, word.at, word.width,
                     "there is no block from line " +
                         std::to_string(to_whole<std::int64_t>(std::clamp(line, -1e9, 2e9))) +
                         " on in " + run.code->name_of(program)});
}

bool return_from_main(Run& run, const CallRecord& back, double p) {
  if (run.observer != nullptr) run.observer->returned = true;
  switch (run.control().calls.main_return.value) {
    case MainReturn::Alarm:
      return alarm(run,
                   {Cause::ReturnInMainProgram, back.at, back.width, "M99 is in the main program"});
    case MainReturn::Ends:
      record_block(run);
      return end_run(run, Stop::End);
    case MainReturn::Restarts:
      break;
  }
  if (!is_vacant(p)) return go_to_own_block(run, Cause::ReturnTargetNotFound, back.p, p);
  const Operand& word = line_of(back);
  double line = kVacant;
  if (word.present() && !value_of(run, word, line)) return false;
  if (!is_vacant(line)) {
    const Address to = block_of_line(*run.code, run.program(), line);
    if (to == kNowhere) return no_line(run, word, line, run.program());
    record_block(run);
    leave_loops(run, to);
    run.state.pc = to;
    return true;
  }
  record_block(run);
  return restart_main(run);
}

/// Begin the next pass of the program that M99 stands in.
void repeat(Run& run, std::int32_t repeats) {
  State& s = run.state;
  OpenFrame& open = run.frame();
  record_block(run);
  open.repeats = repeats;
  ++open.repeat;
  ++s.changes;
  s.loops.resize(open.loops);
  s.pc = open.restart;
  const bool rewritten = open.modal >= 0 &&
                         run.control().macros.modal_locals.value == ModalLocals::Rewritten &&
                         open.modal < static_cast<std::int32_t>(s.modals.size());
  if (!rewritten) return;
  const std::vector<double>& again = s.modals[static_cast<std::size_t>(open.modal)].locals;
  std::copy(again.begin(), again.end(), s.locals.data() + run.local_at(s.level, 0));
}

/// Execute a return that names a block, or goes back several levels.
bool return_by_values(Run& run, const CallRecord& back) {
  const CallExtras& extras = back.extras.get();
  double after = 0, levels = 1;
  if (extras.after.present() && !value_of(run, extras.after, after)) return false;
  if (extras.levels.present() && !value_of(run, extras.levels, levels)) return false;
  std::string name = back.name();
  if (extras.name_text.present()) {
    double text = 0;
    if (!value_of(run, extras.name_text, text)) return false;
    name = capitals(trimmed(text_of(run, text)));
  }
  const std::vector<OpenFrame>& frames = run.state.frames;
  std::size_t to = frames.size() - 1;  // the frame that it leaves last
  double left = std::max(1.0, std::round(levels));
  while (to > 1 && (frames[to].part_end != kNowhere || --left > 0)) --to;
  const OpenFrame& last = frames[to];
  Address next = last.return_to;
  if (!name.empty()) {
    const Program& caller = run.code->programs[static_cast<std::size_t>(frames[to - 1].program)];
    next = run.code->named_return_target(caller, name, last.called_at);
    if (next == kNowhere)
      return alarm(run, {Cause::ReturnTargetNotFound, extras.name_at, extras.name_width,
                         run.code->name_of(caller) + " has no such block"});
    if (after > 0 && next + 1 < caller.last) ++next;
  }
  record_block(run);
  while (run.state.frames.size() > to)
    if (!leave(run, next)) return false;
  leave_loops(run, next);
  return true;
}

}  // namespace

bool return_from_call(Run& run, const Block& block) {
  const CallRecord& back = run.code->calls[block.aux];
  double p = kVacant, l = kVacant;
  if (!value_of(run, back.p, p) || !value_of(run, back.l, l)) return false;
  if (auto fault = refused(run, block, back, p)) return alarm(run, *fault);
  if (!execute_words(run, block)) return false;
  if (modal_after(run) >= 0) {
    WaitingBlock waiting = waiting_block(run, Op::Return, block.aux);
    waiting.p = p;
    waiting.l = l;
    return do_behind_modal(run, std::move(waiting));
  }
  return return_now(run, back, p, l) && (!run.block.waiting_is_due || resume_waiting(run));
}

namespace {

/// Find the block of the caller to which a return goes: by its number, or by its line.
bool find_in_caller(Run& run, const CallRecord& back, double p, double line, Address& to) {
  const std::vector<OpenFrame>& frames = run.state.frames;
  const OpenFrame& below = frames[frames.size() - 2];
  const Program& caller = run.code->programs[static_cast<std::size_t>(below.program)];
  to = is_vacant(p) ? block_of_line(*run.code, caller, line)
                    : run.code->return_target(caller, number_of(p), run.frame().called_at);
  if (to != kNowhere) return true;
  return is_vacant(p) ? no_line(run, line_of(back), line, caller)
                      : no_block(run, Cause::ReturnTargetNotFound, back.p, p, caller);
}

}  // namespace

bool return_now(Run& run, const CallRecord& back, double p, double l) {
  const State& s = run.state;
  const CallRules& rules = run.control().calls;
  if (back.extras.get().by_values && s.frames.size() > 1) return return_by_values(run, back);
  if (run.frame().part_end != kNowhere) {  // no pass follows
    record_block(run);
    return leave(run, run.frame().return_to, true);
  }
  if (!is_vacant(p) && rules.return_with_p.value == ReturnWithP::OwnProgram)
    return go_to_own_block(run, Cause::ReturnTargetNotFound, back.p, p);
  if (s.frames.size() == 1) return return_from_main(run, back, p);
  const OpenFrame& open = run.frame();
  const Operand& line_word = line_of(back);
  double line = kVacant;
  if (line_word.present() && !value_of(run, line_word, line)) return false;
  const bool jumps = !is_vacant(p) || !is_vacant(line);
  std::int32_t repeats = open.repeats;
  if (!is_vacant(l) && rules.return_with_l.value == ReturnWithL::ReplacesCount)
    repeats = open.repeat + to_whole<std::int32_t>(std::clamp(std::round(l), 0.0, 1e6));
  const bool leaves = jumps && rules.return_with_p.value == ReturnWithP::AtOnce;
  if (!leaves && open.repeat < repeats) {
    repeat(run, repeats);
    return true;
  }
  Address to = open.return_to;
  if (jumps && !find_in_caller(run, back, p, line, to)) return false;
  record_block(run);
  return leave(run, to, !jumps);
}

bool jump(Run& run, const Block& block) {
  const JumpRecord& record = run.code->jumps[block.aux];
  double p = 0;
  if (!value_of(run, record.p, p)) return false;
  if (!execute_words(run, block)) return false;
  if (modal_after(run) < 0) return jump_now(run, record, p);
  WaitingBlock waiting = waiting_block(run, Op::Jump, block.aux);
  waiting.p = p;
  return do_behind_modal(run, std::move(waiting));
}

bool jump_now(Run& run, const JumpRecord& jump, double p) {
  if (jump.reads_input) {
    double input = 0;
    if (!evaluate(run, jump.input, input)) return false;
    run.state.last_condition = jump.input;
    if (input != 0) {
      record_block(run, true);
      ++run.state.pc;
      return true;
    }
    const Address to = run.code->first_of(run.program(), number_of(p));
    if (to <= run.state.pc && waits(run)) return false;
  }
  return go_to_own_block(run, Cause::JumpTargetNotFound, jump.p, p);
}

bool end_program(Run& run, const Block& block) {
  if (run.observer != nullptr) run.observer->words = &block;
  if (!execute_words(run, block)) return false;
  // Where the block has no words of its own, the moves in the lookahead queue still wait.
  if (auto fault = run.motion.finish(run.moves())) return alarm_of_motion(run, *fault);
  if (!ends_the_run(run)) return return_now(run, CallRecord(), kVacant, kVacant);
  record_step(run);
  return end_run(run, Stop::End);
}

bool ends_the_run(const Run& run) {
  const std::vector<OpenFrame>& frames = run.state.frames;
  std::size_t own = frames.size() - 1;
  while (frames[own].part_end != kNowhere) --own;  // parts belong to the program around them
  return own == 0 || run.control().calls.end_in_subprogram.value == EndInSubprogram::EndsRun;
}

bool end_of_record(Run& run) {
  if (run.frame().typed ||  // MDI needs no end
      run.control().reading.missing_end.value == MissingEnd::Ends)
    return end_run(run, Stop::End);
  const Program& program = run.program();
  return alarm(
      run, {Cause::EndOfRecord, program.text_end, 1,
            run.code->name_of(program) + spelled(" ends without {end-or-return}", run.control())});
}

}  // namespace cncsub
