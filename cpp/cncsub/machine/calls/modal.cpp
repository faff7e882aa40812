#include "cncsub/machine/calls/modal.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "cncsub/code/target.hpp"
#include "cncsub/machine/calls/calls.hpp"
#include "cncsub/machine/calls/returns.hpp"
#include "cncsub/machine/calls/words.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/values/decode.hpp"

namespace cncsub {

namespace {

/// Take the words of a block as the arguments of G66.1. G and M are the last of their codes.
void arguments_of(Run& run, const NcWords& words) {
  static constexpr int kVariables[26] = {1,  2,  3,  7,  8,  9,  10, 11, 4,  5,  6,  12, 13,
                                         14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  std::vector<double>& arguments = run.block.arguments;
  arguments.assign(static_cast<std::size_t>(run.code->locals), kVacant);
  for (int i = 0; i < 26; ++i) {
    if ((words.mask & (1u << i)) == 0) continue;
    const double value = words.value[static_cast<std::size_t>(i)];
    const bool whole = (words.whole & (1u << i)) != 0;
    arguments[static_cast<std::size_t>(kVariables[i])] =
        whole ? scaled(run.motion.view(), static_cast<char>('A' + i), value) : value;
  }
  if (!words.codes->g().empty()) arguments[10] = words.codes->g().back() / 10.0;
  if (!words.codes->m().empty()) arguments[13] = words.codes->m().back();
}

/// Enter the macro of a modal call after a block that moved. The block is a step already.
bool enter_modal(Run& run, std::int32_t index) {
  State& s = run.state;
  ModalCall& modal = s.modals[static_cast<std::size_t>(index)];
  const CallRecord& record = run.code->calls[modal.record];
  run.block.words_done = false;
  if (modal.target.skipped) return true;
  std::optional<Fault> fault;
  if (modal.target.start == kNowhere && !record.constant)
    fault = find_target(*run.code, record, modal.target, search_of(run));
  if (!fault) fault = refused(run, record, modal.target);
  if (fault) {
    // The call stands in another block: what the alarm points at is the move.
    fault->at = s.pc = s.moved_at;
    return alarm_of_motion(run, std::move(*fault));
  }
  run.block.arguments = modal.locals;
  if (run.control().macros.call_passes_words.value)
    run.block.programmed.assign(run.block.arguments.size(), 0);
  const Target target = modal.target;
  return enter(run, modal.record, target, index);
}

}  // namespace

bool modal_call(Run& run, const Block& block) {
  State& s = run.state;
  const std::optional<std::uint32_t> number = record_of(run, block);
  if (!number) return false;
  const CallRecord& record = run.code->calls[*number];
  if (auto fault = refused_here(run, record)) return alarm(run, *fault);
  ModalCall modal;
  if (!decode_target(run, record, modal.target) || !evaluate_arguments(run, record)) return false;
  const bool stacks = run.control().macros.second_modal_call.value == SecondModal::Stacks;
  const int most = run.control().macros.max_modal_calls.value;
  if ((stacks ? s.modals.size() : 0) >= static_cast<std::size_t>(most))
    return alarm(run, {Cause::ModalCallsTooMany, record.at, record.width,
                       "the control allows " + std::to_string(most) + " modal calls"});
  if (!execute_words(run, block)) return false;
  if (!stacks) s.modals.clear();
  modal.record = *number;
  modal.locals = run.block.arguments;
  modal.program = run.frame().program;
  modal.every_block = record.code_kind == CodeCallKind::ModalEveryBlock;
  s.modals.push_back(std::move(modal));
  ++s.changes;
  record_step(run);
  return proceed(run, run.block.next);
}

bool cancel_modal(Run& run, const Block& block) {
  State& s = run.state;
  if (s.modals.empty() && run.control().macros.cancel_alone.value == CancelAlone::Alarm)
    return alarm(run, {.cause = Cause::ModalCallMissing,
                       .detail = "no modal macro call is active",
                       .word = {.code = 670}});
  if (!execute_words(run, block)) return false;
  if (!s.modals.empty() && run.frame().modal < 0) s.modals.pop_back();
  ++s.changes;
  record_step(run);
  return proceed(run, run.block.next);
}

bool every_block(Run& run, const Block& block) {
  NcWords words;
  if (!decode(run, block, run.state.pc, words)) return false;
  arguments_of(run, words);
  ModalCall& modal = run.state.modals.back();
  const CallRecord& record = run.code->calls[modal.record];
  if (modal.target.start == kNowhere && !record.constant)
    if (auto fault = find_target(*run.code, record, modal.target, search_of(run)))
      return alarm(run, *fault);
  const Target target = modal.target;
  return enter(run, modal.record, target, static_cast<std::int32_t>(run.state.modals.size()) - 1);
}

namespace {

/// Return whether a modal call follows every block: it is one of G66.1, and takes no block's words.
bool follows_blocks(const Run& run, const ModalCall& modal) {
  return !modal.every_block && run.code->calls[modal.record].kind == CallKind::ModalEveryBlock;
}

}  // namespace

bool follows_statements(const Run& run) {
  const std::int32_t modal = modal_after(run);
  return modal >= 0 && follows_blocks(run, run.state.modals[static_cast<std::size_t>(modal)]);
}

std::int32_t modal_of_move(const Run& run) {
  const State& s = run.state;
  const Motion::Outcome& outcome = run.block.outcome;
  const bool triggers = run.control().macros.modal_trigger.value == ModalTrigger::Move
                            ? outcome.moved
                            : outcome.axis_word;
  const std::int32_t top =
      std::min(static_cast<std::int32_t>(s.modals.size()), run.frame().modal_limit);
  if (top <= 0 || !follows_moves(run, top - 1)) return -1;
  if (!triggers && !follows_blocks(run, s.modals[static_cast<std::size_t>(top - 1)])) return -1;
  return s.modals[static_cast<std::size_t>(top - 1)].target.skipped ? -1 : top - 1;
}

bool call_after_move(Run& run) {
  const std::int32_t modal = modal_after(run);
  return modal < 0 || enter_modal(run, modal);
}

bool do_behind_modal(Run& run, WaitingBlock waiting) {
  record_step(run);
  run.state.moved_at = run.state.pc;
  if (!enter_modal(run, modal_after(run))) return false;
  run.frame().interrupts = true;
  run.state.waiting.push_back(std::move(waiting));
  return true;
}

bool resume_waiting(Run& run) {
  RunningBlock& block = run.block;
  bool runs = true;
  while (block.waiting_is_due && runs) {
    block.waiting_is_due = false;
    WaitingBlock waiting = std::move(run.state.waiting.back());
    run.state.waiting.pop_back();
    run.state.pc = waiting.at;
    block.next = waiting.at + 1;
    block.step = waiting.step;
    block.words_done = false;
    block.arguments = std::move(waiting.arguments);
    block.programmed = std::move(waiting.programmed);
    block.is_step = true;
    if (waiting.op == Op::Return)
      runs = return_now(run, run.code->calls[waiting.aux], waiting.p, waiting.l);
    else if (waiting.op == Op::Jump)
      runs = jump_now(run, run.code->jumps[waiting.aux], waiting.p);
    else
      runs = call_now(run, waiting.aux, waiting.target);
    block.is_step = false;
  }
  return runs;
}

}  // namespace cncsub
