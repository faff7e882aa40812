#include "cncsub/machine/calls/words.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "cncsub/machine/calls/modal.hpp"
#include "cncsub/machine/calls/returns.hpp"
#include "cncsub/machine/state/limits.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/statements/output.hpp"
#include "cncsub/machine/statements/statements.hpp"
#include "cncsub/machine/values/decode.hpp"
#include "cncsub/machine/values/expressions.hpp"
#include "cncsub/machine/values/machine_inputs.hpp"
#include "cncsub/machine/values/variables.hpp"
#include "cncsub/motion/block/block.hpp"

namespace cncsub {

namespace {

constexpr std::uint32_t role_bit(Role role) { return 1u << static_cast<unsigned>(role); }
constexpr std::uint32_t kSavingRoles = role_bit(Role::SaveModes) | role_bit(Role::ForgetModes) |
                                       role_bit(Role::RestoreModes) | role_bit(Role::KeepModes);

// To copy so many moves of the lookahead queue into a plan takes as long as to make one move.
constexpr std::int64_t kHeldPieces = 8;

/// Return the role of an M code on the control.
Role role_of(const Run& run, int m) { return run.control().calls.roles.value.of_m(m); }

/// Return whether the run waits for the operator at an M code.
bool waits_at(const Run& run, Role role) {
  return role == Role::Stop || (role == Role::OptionalStop && run.options.optional_stop);
}

/// Keep the result of a G31: its position, in the variables of a control that keeps it among the
/// commons (X Z Y and the fourth and the fifth axis of a lathe [TDi p.94]); or that nothing was
/// met.
void keep_skip(Run& run, SkipMove skip) {
  if (skip == SkipMove::Missed) {
    run.trace.missed_skips.push({run.state.executed, run.state.pc});
    return;
  }
  const int first = run.control().motion.skip_variables.value;
  if (first <= 0) return;
  for (int axis = 0; axis < kSkipAxes; ++axis)
    write_variable(run, first + axis, skip_position(run.motion.view(), axis));
}

/// Keep the result of a G31, and note that it came from outside unless a workpiece gave it.
void take_skip(Run& run, SkipMove skip) {
  keep_skip(run, skip);
  if (run.options.inputs.workpiece == nullptr)
    run.state.external_reads.asked = ExternalReads::kSkipSignal;
}

/// Apply the machine's answer to a code it was sent: the signals and variables that it sets.
void answer(Run& run, char address, std::int64_t code) {
  if (run.options.inputs.answers.empty()) return;
  const auto found = run.options.inputs.answers.find({address, code});
  if (found == run.options.inputs.answers.end()) return;
  for (const auto& [number, value] : found->second) set_from_outside(run, number, value);
  ++run.state.changes;
}

/// Send M, T and S codes to the machine; M00 and M01 wait for the operator.
bool send_codes(Run& run, const NcWords& words, const Block& block) {
  const auto record = [&](char kind, double value) {
    if (run.trace.depth == Trace::Depth::None) return;
    run.trace.codes.push({run.state.executed, value, run.state.pc, kind});
  };
  if (words.has('T')) {
    const auto tool = to_whole<std::int64_t>(std::round(words['T']));
    record('T', static_cast<double>(tool));
    answer(run, 'T', tool);
  }
  // With G50 or G92, S is no speed but the highest speed allowed.
  if (words.has('S') && words.codes->meaning(Group::OneShot) != Meaning::SetCoordinate)
    record('S', words['S']);
  for (const int m : words.codes->m()) {
    record('M', m);
    run.state.last_m = m;
    answer(run, 'M', m);
    const Role role = role_of(run, m);
    if (waits_at(run, role) && !wait_for_operator(run, CodeName{'M', m * 10}.text())) return false;
    if (role == Role::StartOver && run.state.frames.size() == 1)
      run.block.next = RunningBlock::kRestart;
    if (role == Role::End && block.op != Op::EndProgram) run.block.next = RunningBlock::kEnd;
  }
  return true;
}

/// Tell the words to the observer.
void observe(Run& run, const Block& block, const NcWords& words) {
  const bool has_extra = (block.flags & Block::kHasExtra) != 0;
  const bool computed = words.codes == &run.codes ||
                        (has_extra && run.code->cells[block.data].extra.expressions != 0);
  if (computed)
    run.observer->keep(block, words, run.codes);
  else
    run.observer->words = &block;
}

/// Count the moves that were made, and those that wait in the lookahead queue.
void count_moves(Run& run) {
  run.watch.moves += run.block.outcome.moves;
  if (const LookaheadQueue& lookahead = run.motion.state().lookahead;
      !lookahead.radius.empty() || !lookahead.corner.empty())
    run.watch.moves += held_pieces(run.motion.state()) / kHeldPieces;
  if (run.watch.moves > run.watch.look_moves) look_soon(run);
}

/// Take over the outcome of a motion that was made.
void follow_up(Run& run, const MachineInputs& inputs) {
  const Motion::Outcome& outcome = run.block.outcome;
  if (inputs.skips.taken) {
    log_read(run);
    run.state.external_reads.skips = *inputs.skips.taken;
  }
  if (outcome.skip != SkipMove::No) take_skip(run, outcome.skip);
  count_moves(run);
}

bool execute(Run& run, const NcWords& words, MachineInputs& inputs) {
  if (auto fault = run.motion.execute(words, run.step(), run.moves(), run.block.outcome, inputs))
    return run.watch.broken_off == Stop::Running && alarm_of_motion(run, *fault);
  run.watch.in_block = 0;
  return true;
}

/// Execute the motion of a block that names a profile.
bool move_along(Run& run, const NcWords& words, const ProfileNumbers& wanted) {
  MachineInputs inputs = machine_inputs(run);
  std::optional<Profile> profile(std::in_place);
  profile->fault = read_profile(run, wanted, *profile);
  if (run.state.stop != Stop::Running) return false;
  inputs.profile = &*profile;
  if (!execute(run, words, inputs)) return false;
  if (run.observer != nullptr) run.observer->profile = std::move(profile);
  follow_up(run, inputs);
  return true;
}

/// Execute the motion of a block: moves, modes, offsets.
bool move(Run& run, const Block& block, NcWords& words) {
  words.ends = block.op == Op::EndProgram && ends_the_run(run);
  words.stops = words.ends || words.has(Role::Stop) || words.has(Role::End) ||
                (run.options.optional_stop && words.has(Role::OptionalStop));
  if (const auto wanted = run.motion.wanted_profile(words)) return move_along(run, words, *wanted);
  MachineInputs inputs = machine_inputs(run);
  if (!execute(run, words, inputs)) return false;
  follow_up(run, inputs);
  return true;
}

/// Return the words of a block that still hold after it restored modes. F, S and the feed mode are
/// read before that, and hold no longer. [rs274 2.9]
NcWords behind_modes(const NcWords& words, BlockCodes& codes) {
  NcWords left = words;
  codes = *words.codes;
  codes.groups &= ~bit(Group::Feed);
  codes.of[at(Group::Feed)] = {};
  left.codes = &codes;
  left.mask &= ~(bit('F') | bit('S'));
  return left;
}

bool move_behind_modes(Run& run, const Block& block, const NcWords& words) {
  BlockCodes codes;
  NcWords left = behind_modes(words, codes);
  return move(run, block, left);
}

}  // namespace

bool carry_out(Run& run, const Block& block) {
  NcWords words;
  run.block.left_out.clear();
  if (!decode(run, block, run.state.pc, words)) return false;
  if (run.observer != nullptr) observe(run, block, words);
  if (run.block.parallel_assign != nullptr && !assign_in_parallel(run)) return false;
  if (auto fault = unused_word(run.motion.view(), words))
    return alarm_of_motion(run, std::move(*fault));
  if ((words.codes->roles & kSavingRoles) != 0 && !change_saved_modes(run, words)) return false;
  const bool moved = words.has(Role::RestoreModes) ? move_behind_modes(run, block, words)
                                                   : move(run, block, words);
  if (!moved || !send_codes(run, words, block)) return false;
  const Motion::Outcome& outcome = run.block.outcome;
  if ((block.flags & Block::kDrops) != 0 || !run.block.left_out.empty() ||
      (outcome.dropped | outcome.dropped_codes) != 0)
    tell_dropped(run, block, words);
  run.block.words_done = true;
  if (outcome.missed_reference)
    return alarm_of_motion(run, {.cause = Cause::NotAtReference,
                                 .at = run.state.pc,
                                 .detail = {},
                                 .word = {.addresses = kAxisWords}});
  if (block.n >= 0) run.state.last_n = block.n;
  if (outcome.moved || words.has('T') || !words.codes->only_of_moves()) ++run.state.changes;
  if (is_words(block.op)) return after_words(run);
  if (run.block.next != RunningBlock::kEnd) return true;
  record_step(run);  // M#1 in the block of a call, a return or a jump ends the program first
  return end_run(run, Stop::End);
}

bool after_words(Run& run) {
  record_step(run);
  run.state.moved_at = run.state.pc;
  const Address next = run.block.next;
  if (next == RunningBlock::kRestart || next == RunningBlock::kEnd) return proceed(run, next);
  const Address behind = run.block.outcome.behind;
  if (behind != kNowhere) leave_loops(run, behind);
  run.state.pc = behind != kNowhere ? behind : next;
  return call_after_move(run);
}

}  // namespace cncsub
