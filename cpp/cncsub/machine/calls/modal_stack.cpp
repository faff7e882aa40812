// Modes that a program saves for itself and for its caller.
#include <algorithm>
#include <cmath>

#include "cncsub/machine/calls/words.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/values/machine_inputs.hpp"
#include "cncsub/motion/saved_modes.hpp"

namespace cncsub {

namespace {

using ModalStackEntry = State::ModalStackEntry;

ModalStackEntry* modal_stack_entry(Run& run) {
  auto& all = run.state.modal_stack;
  const auto depth = run.state.frames.size();
  return !all.empty() && all.back().depth == depth ? &all.back() : nullptr;
}

bool carry_out(Run& run, const ReturnToModes& block, const SavedModes& modes) {
  const bool nothing = block.codes.g_count == 0 && !block.has_feed && !block.has_speed;
  if (nothing) return true;
  const BlockCodes codes(block.codes, *run.meanings);
  if (run.observer != nullptr && modes.codes_alone) run.observer->restored.push_back(codes);
  NcWords words;
  words.codes = &codes;
  words.at = run.state.pc;
  const auto set = [&words](char address, double value) {
    words.mask |= bit(address);
    words.value[static_cast<std::size_t>(address - 'A')] = value;
  };
  if (block.has_feed) set('F', std::round(modes.feed * 10) / 10);
  if (block.has_speed) set('S', std::round(modes.speed));
  Motion::Outcome outcome;
  MachineInputs inputs = machine_inputs(run);
  const auto fault = run.motion.execute(words, run.step(), run.moves(), outcome, inputs);
  return !fault || alarm_of_motion(run, *fault);
}

/// Restore modes by two blocks.
bool restore_modes(Run& run, const SavedModes& modes) {
  if (!carry_out(run, units_to(run.motion.view(), modes), modes)) return false;
  if (!carry_out(run, modes_to(run.motion.view(), modes), modes)) return false;
  run.motion.set_turning(modes.turns);
  if (!modes.codes_alone) return true;
  if (run.observer != nullptr && !(run.motion.state().frames->program == modes.frame))
    run.observer->frame_restored = true;
  run.motion.set_frame(modes.frame);
  return true;
}

void save(Run& run, bool for_return) {
  ModalStackEntry* saved = modal_stack_entry(run);
  if (saved == nullptr) {
    run.state.modal_stack.push_back({run.state.frames.size(), false, false, {}});
    saved = &run.state.modal_stack.back();
  }
  saved->valid = true;
  saved->for_return = saved->for_return || for_return;
  saved->modes = modes_of(run.motion.view());
}

}  // namespace

bool change_saved_modes(Run& run, const NcWords& words) {
  if (words.has(Role::SaveModes)) save(run, false);
  if (words.has(Role::KeepModes)) save(run, true);
  ModalStackEntry* const saved = modal_stack_entry(run);
  if (words.has(Role::ForgetModes) && saved != nullptr) saved->valid = false;
  if (!words.has(Role::RestoreModes)) return true;
  if (saved == nullptr || !saved->valid)
    return !run.refuses(Cause::ModesNotSaved) ||
           alarm(run,
                 {.cause = Cause::ModesNotSaved, .detail = {}, .word = {.addresses = bit('M')}});
  return restore_modes(run, saved->modes);
}

void keep_modes_of_caller(Run& run) {
  save(run, true);
  run.state.modal_stack.back().modes.codes_alone = true;
}

bool come_back_to_modes(Run& run) {
  auto& all = run.state.modal_stack;
  const auto depth = run.state.frames.size();
  bool fine = true;
  while (fine && !all.empty() && all.back().depth > depth) {
    const ModalStackEntry last = all.back();
    all.pop_back();
    if (last.valid && last.for_return) fine = restore_modes(run, last.modes);
  }
  return fine;
}

}  // namespace cncsub
