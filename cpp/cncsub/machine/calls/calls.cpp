#include "cncsub/machine/calls/calls.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "cncsub/code/own_locals.hpp"
#include "cncsub/code/target.hpp"
#include "cncsub/machine/calls/modal.hpp"
#include "cncsub/machine/calls/returns.hpp"
#include "cncsub/machine/calls/words.hpp"
#include "cncsub/machine/state/limits.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/statements/statements.hpp"
#include "cncsub/machine/values/expressions.hpp"
#include "cncsub/machine/values/variables.hpp"
#include "cncsub/system/compiler.hpp"

namespace cncsub {

namespace {

constexpr std::uint32_t kManyArguments = 1 << 16;  // work for a millisecond

Fault fault(const CallRecord& record, Cause cause, std::string detail) {
  return {cause, record.at, record.width, std::move(detail)};
}

/// Return whether the block itself says that it calls, and not a code.
bool by_name(CallKind kind) {
  switch (kind) {
    case CallKind::Subprogram:
    case CallKind::External:
    case CallKind::Local:
    case CallKind::OWord:
    case CallKind::Named:
    case CallKind::Repeat:
    case CallKind::CallBlock:
    case CallKind::Macro:
    case CallKind::Modal:
    case CallKind::ModalEveryBlock:
      return true;
    default:
      return false;
  }
}

/// Return the fault of a program that calls itself, or one that has called it.
std::optional<Fault> refused_again(const Run& run, const CallRecord& record, const Target& target) {
  const CallRules& rules = run.control().calls;
  const bool started = target.start_n >= 0;
  if (target.program == run.frame().program) {
    const bool bad = rules.self_call.value == SelfCall::Refused ||
                     (rules.self_call.value == SelfCall::WithStart && !started);
    if (bad) return fault(record, Cause::ProgramCallsItself, "the program calls itself");
    return std::nullopt;
  }
  const CallerCall rule = rules.caller_call.value;
  if (rule == CallerCall::Allowed || (rule == CallerCall::WithStart && started))
    return std::nullopt;
  const std::vector<OpenFrame>& frames = run.state.frames;
  const std::size_t asked = rule == CallerCall::MainRefused ? 1 : frames.size();
  for (std::size_t i = 0; i + 1 < frames.size() && i < asked; ++i)
    if (frames[i].program == target.program)
      return fault(record, Cause::ProgramCallsCaller,
                   run.code->name_of(target.program) + " is already open");
  return std::nullopt;
}

/// Return the fault of one call more than the control allows.
std::optional<Fault> refused_deeper(const Run& run, const CallRecord& record) {
  const CallRules& rules = run.control().calls;
  const int macros = run.state.macros + (record.macro ? 1 : 0);
  const int subprograms = run.state.subprograms + (record.macro ? 0 : 1);
  const int both = macros + subprograms;
  const int counted = rules.nesting_counts_macros.value ? both : subprograms;
  const auto deep = [&](Cause cause, int most, const char* what) {
    return fault(record, cause, "the control allows " + std::to_string(most) + " " + what);
  };
  const int most_macros = rules.max_macro_nesting.value;
  if (record.macro && macros > most_macros)
    return deep(Cause::MacroNestingTooDeep, most_macros, "levels of macro calls");
  const int most = rules.max_nesting.value, most_of_both = rules.max_total_nesting.value;
  if (counted > most) return deep(Cause::NestingTooDeep, most, "levels of calls");
  if (most_of_both > 0 && both > most_of_both)
    return deep(Cause::NestingTooDeep, most_of_both, "levels of calls of both kinds");
  return std::nullopt;
}

/// Call after the block's words are executed: at once, or after the macro of a modal call.
bool call_or_wait(Run& run, std::uint32_t aux, Target& target, bool passes) {
  if (modal_after(run) < 0) return call_now(run, aux, target);
  WaitingBlock waiting = waiting_block(run, Op::Call, aux);
  waiting.target = target;
  if (passes) {
    waiting.arguments = run.block.arguments;
    waiting.programmed = run.block.programmed;
  }
  return do_behind_modal(run, std::move(waiting));
}

/// Return what a frame keeps of codes that call: a code in it may not call then.
char code_letter(CallKind kind, char of_caller) {
  switch (kind) {
    case CallKind::GCode:
      return 'G';
    case CallKind::MCode:
    case CallKind::TCode:
    case CallKind::SCode:
    case CallKind::BCode:
    case CallKind::Ascii:
      return 'M';
    default:
      return of_caller;
  }
}

/// Open a level of locals with the arguments in it.
void open_level(Run& run, const CallRecord& record) {
  State& s = run.state;
  ++s.level;
  const std::size_t first = run.local_at(s.level, 0);
  const std::size_t end = run.local_at(s.level + 1, 0);
  if (s.locals.size() < end) {
    s.locals.resize(end, kVacant);
    if (!s.programmed.empty()) s.programmed.resize(end, 0);
  }
  if (run.code->elements > 0) {
    s.elements.resize(run.element_at(0));
    s.elements.resize(run.element_at(static_cast<std::size_t>(run.code->elements)), 0);
  }
  const RunningBlock& block = run.block;
  std::copy(block.arguments.begin(), block.arguments.end(), s.locals.data() + first);
  if (run.control().macros.call_passes_words.value)
    std::copy(block.programmed.begin(), block.programmed.end(), s.programmed.data() + first);
  if (!record.references().empty()) copy_arrays(run, record);
}

/// Return whether an argument is one of those that a program does not see: references.
bool is_hidden(const Code& code, std::size_t local) {
  const auto index = static_cast<std::int32_t>(local);
  return index > code.locals_per_level && code.named(false, index) == nullptr;
}

/// Write the call into the trace, with its arguments where it opened a level for them.
void record_call(Run& run, std::uint32_t index, const Target& target, OpenFrame& open,
                 std::int64_t caller_step) {
  const State& s = run.state;
  Trace& trace = run.trace;
  CallRow row;
  row.parent = run.frame().call;
  row.program = target.program;
  row.start_n = target.start_n;
  row.repeats = target.repeats;
  row.level = s.level;
  row.depth = static_cast<std::int32_t>(s.frames.size());
  row.record = index;
  row.kind = open.kind;
  row.caller_step = caller_step;
  row.first_step = s.executed;
  row.last_step = -1;  // until it ends
  row.first_argument = static_cast<std::uint32_t>(trace.arguments.size());
  const std::vector<double>& arguments = run.block.arguments;
  if (open.own_locals && !open.shares_locals)
    for (std::size_t i = 0; i < arguments.size(); ++i)
      if (!is_vacant(arguments[i]) && !is_hidden(*run.code, i))
        trace.arguments.push({static_cast<std::int32_t>(i), arguments[i]});
  row.arguments = static_cast<std::uint32_t>(trace.arguments.size()) - row.first_argument;
  open.call = trace.call_number(trace.calls.size());
  trace.calls.push(row);
  if (open.call == std::numeric_limits<std::int32_t>::max() - 1) end_run(run, Stop::Limit);
}

}  // namespace

bool decode_target(Run& run, const CallRecord& record, Target& target) {
  if (record.constant) {
    target = record.target;
    return true;
  }
  CallOperands values;
  if (!value_of(run, record.p, values.p) || !value_of(run, record.l, values.l) ||
      !value_of(run, record.start(), values.start) ||
      !value_of(run, record.device(), values.device))
    return false;
  if (auto fault = decode_call(*run.code, record, values, run.frame().program, target))
    return alarm(run, *fault);
  return !record.name_text().present() || find_by_text(run, record, target);
}

bool evaluate_arguments(Run& run, const CallRecord& record) {
  RunningBlock& block = run.block;
  block.arguments.assign(static_cast<std::size_t>(run.code->locals), kVacant);
  const bool reported = run.control().macros.call_passes_words.value;
  if (reported) block.programmed.assign(block.arguments.size(), 0);
  const Argument* argument = run.code->arguments.data() + record.first_argument;
  for (std::uint32_t i = 0; i < record.arguments; ++i, ++argument) {
    double value = 0;
    if (i % kManyArguments == kManyArguments - 1 && breaks_off(run)) return false;
    if (!value_of(run, argument->operand, value)) return false;
    if (argument->operand.whole && argument->operand.kind == Operand::Kind::Constant)
      value = scaled(run.motion.view(), argument->address, value);
    const auto place = static_cast<std::size_t>(argument->variable);
    block.arguments[place] = value;
    if (reported) block.programmed[place] = modal_code(run.motion.view(), 3) == 91 ? 91 : 90;
  }
  return record.references().empty() || evaluate_references(run, record);
}

std::optional<Fault> refused_here(const Run& run, const CallRecord& record) {
  const CallRules& rules = run.control().calls;
  const std::vector<ModalCall>& modals = run.state.modals;
  const bool inside = !run.frame().typed;
  const MdiCalls typed = rules.mdi_calls.value;
  const bool refuses = typed == MdiCalls::Refused || (typed == MdiCalls::OneLevel && inside);
  if (refuses && run.in_mdi())
    return fault(record, Cause::CallInMdi,
                 inside ? "a call inside a program called from MDI" : "a call from MDI");
  if (modals.empty() || !by_name(record.kind)) return std::nullopt;
  switch (rules.calls_in_modal.value) {
    case CallsInModal::Allowed:
      break;
    case CallsInModal::EndModal:
      if (!record.macro)
        return fault(record, Cause::CallInModalCall, "M98 while a modal macro call is active");
      break;
    case CallsInModal::Refused:
      if (modals.back().program == run.frame().program)
        return fault(record, Cause::CallInModalCall,
                     "a call while a modal macro call of this program is active");
      break;
  }
  return std::nullopt;
}

std::optional<Fault> refused(const Run& run, const CallRecord& record, const Target& target) {
  if (auto again = refused_again(run, record, target)) return again;
  return refused_deeper(run, record);
}

bool call(Run& run, const Block& block) {
  const std::optional<std::uint32_t> number = record_of(run, block);
  if (!number) return false;
  const CallRecord& record = run.code->calls[*number];
  if (auto fault = refused_here(run, record)) return alarm(run, *fault);
  Target target;
  if (!decode_target(run, record, target)) return false;
  const bool passes = record.arguments > 0 || record.locals != CallRecord::Locals::ByKind ||
                      run.control().macros.call_passes_words.value;
  if (passes && !evaluate_arguments(run, record)) return false;
  if (passes && record.name_text().present() && !take_own_values(run, record, target)) return false;
  if (has_words(block) && in_cycle(run.motion.state()) && run.refuses(Cause::CallWithWordsInCycle))
    return alarm(run, fault(record, Cause::CallWithWordsInCycle,
                            "M98 has other words in its block while a canned cycle is active"));
  if (!execute_words(run, block)) return false;
  return target.skipped ? after_words(run) : call_or_wait(run, *number, target, passes);
}

bool call_now(Run& run, std::uint32_t aux, Target& target) {
  const CallRecord& record = run.code->calls[aux];
  if (target.external && run.frame().external)
    return alarm(run, fault(record, Cause::ExternalCallNested,
                            "a program of the external device calls another one"));
  if (!record.constant)
    if (auto fault = find_target(*run.code, record, target, search_of(run)))
      return alarm(run, *fault);
  if (!target.jump) return enter(run, aux, target, -1);
  const Program& program = run.code->programs[static_cast<std::size_t>(target.program)];
  record_block(run);
  if (run.state.frames.size() == 1 && target.start == program.first) return restart_main(run);
  run.state.pc = target.start;
  return true;
}

bool macro_call(Run& run, const Block& block) {
  const CallRecord& record = run.code->calls[block.aux];
  if (auto fault = refused_here(run, record)) return alarm(run, *fault);
  Target target;
  if (!decode_target(run, record, target) || !evaluate_arguments(run, record)) return false;
  if (!execute_words(run, block)) return false;
  const bool ends_modal = record.kind == CallKind::Macro &&
                          run.control().calls.calls_in_modal.value == CallsInModal::EndModal;
  if (!ends_modal)
    return target.skipped ? after_words(run) : call_or_wait(run, block.aux, target, true);
  if (target.skipped) {
    run.state.modals.clear();
    return after_words(run);
  }
  if (!call_now(run, block.aux, target)) return false;
  run.state.modals.clear();
  return true;
}

namespace {

CNCSUB_ALWAYS_INLINE inline OpenFrame frame_of(const Run& run, const CallRecord& record,
                                               const Target& target, std::int32_t modal) {
  OpenFrame open;
  open.program = target.program;
  open.repeats = target.repeats;
  open.restart = target.start;
  open.kind = record.kind;
  open.macro = record.macro;
  open.own_locals = has_own_locals(record, run.control());
  open.shares_locals = record.locals == CallRecord::Locals::OwnByName;
  open.external = run.frame().external || target.external;
  open.code_letter = code_letter(record.kind, run.frame().code_letter);
  open.modal = modal;
  open.modal_limit = modal >= 0 ? modal : run.frame().modal_limit;
  open.loops = static_cast<std::uint32_t>(run.state.loops.size());
  open.copies = run.state.copies.size();
  return open;
}

}  // namespace

bool enter(Run& run, std::uint32_t index, const Target& target, std::int32_t modal) {
  State& s = run.state;
  const CallRecord& record = run.code->calls[index];
  if (auto fault = refused(run, record, target)) return alarm(run, *fault);
  if (record.variable > 0)
    if (auto fault = write_variable(run, record.variable, record.code)) {
      fault->at = record.at;
      fault->width = record.width;
      return alarm(run, *fault);
    }
  const bool by_move = modal >= 0 && follows_moves(run, modal);  // of a block that is a step
  OpenFrame open = frame_of(run, record, target, modal);
  open.called_at = by_move ? s.moved_at : s.pc;
  open.return_to = by_move ? s.pc : run.block.next;
  if (!by_move) {
    record_block(run);
    s.moved_at = s.pc;
  }
  ++s.changes;
  if (open.own_locals) open_level(run, record);
  (record.macro ? s.macros : s.subprograms) += 1;
  if (run.trace.depth != Trace::Depth::None)
    record_call(run, index, target, open,
                run.block.is_step && !by_move ? run.block.step : s.executed - 1);
  s.frames.push_back(open);
  run.frame().part_end = record.extras.get().part_end;
  const bool part = run.frame().part_end != kNowhere;
  if (!part && run.code->programs[static_cast<std::size_t>(target.program)].keeps_modes)
    keep_modes_of_caller(run);
  if (s.frames.size() > kLongText) look_soon(run);  // each call looks at all of them
  s.pc = target.start;
  return true;
}

bool leave(Run& run, Address to, bool goes_on) {
  State& s = run.state;
  const OpenFrame& open = run.frame();
  const bool interrupts = open.interrupts;
  if (open.modal >= 0 && run.control().macros.modal_locals.value == ModalLocals::Kept &&
      open.modal < static_cast<std::int32_t>(s.modals.size())) {
    const double* first = s.locals.data() + run.local_at(s.level, 0);
    s.modals[static_cast<std::size_t>(open.modal)].locals.assign(first, first + run.code->locals);
  }
  if (open.call >= 0) run.trace.calls.at(run.trace.call_row(open.call)).last_step = s.executed - 1;
  if (open.shares_locals) {
    const double* own = s.locals.data() + run.local_at(s.level, 0);
    std::copy_n(own, run.code->locals_per_level + 1,
                s.locals.data() + run.local_at(s.level - 1, 0));
  }
  if (open.own_locals) {
    --s.level;
    s.elements.resize(run.element_at(static_cast<std::size_t>(run.code->elements)));
    s.copies.resize(open.copies);
  }
  if (!open.typed) (open.macro ? s.macros : s.subprograms) -= 1;
  s.loops.resize(open.loops);
  s.frames.pop_back();
  if (interrupts) {
    run.block.waiting_is_due = goes_on;
    if (!goes_on) s.waiting.pop_back();
  }
  if (!s.modal_stack.empty() && !come_back_to_modes(run)) return false;
  return proceed(run, to);
}

}  // namespace cncsub
