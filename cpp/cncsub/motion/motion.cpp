// The public face: a block is executed whole, or not at all.
#include "cncsub/motion/motion.hpp"

#include <utility>

#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/cycle/cycles.hpp"
#include "cncsub/motion/fast_path.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/power_on.hpp"
#include "cncsub/motion/query.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

/// The step in the numbers of variables from one reference point to the next.
constexpr int kReferenceStep = 20;

/// End the waiting of moves for the next one.
Result end_waiting(MoveSink& sink) {
  const Result waiting = unfinished_move(sink);
  return waiting ? waiting : flush_radius(sink);
}

}  // namespace

Motion::Motion(std::shared_ptr<const Control> control, const Setup& setup,
               std::shared_ptr<const CodeMeanings> meanings, bool general_only)
    : facts_(std::make_shared<MotionFacts>(std::move(control), setup, std::move(meanings),
                                           general_only)),
      state_(state_of(*facts_, setup)) {}

/// Roll everything back when the work ends in a fault.
template <class Work>
std::optional<Fault> Motion::whole_or_nothing(Moves* moves, const Work& work) {
  Undo undo(state_, before_, log_, moves);
  state_.plain = false;  // from here on tool_at is kept
  auto wrong = work();
  if (wrong)
    undo.put_back();
  else
    prepare_fast_path(*facts_, state_);
  return wrong;
}

std::optional<Fault> Motion::execute(const NcWords& words, std::uint32_t step, Moves* moves,
                                     Outcome& outcome, MachineInputs& inputs) {
  if (state_.plain) state_.tool_at = machine_point(state_);
  outcome = {};
  MotionContext context{*facts_, state_, log_, {*facts_, state_, moves}, outcome, inputs};
  auto wrong = whole_or_nothing(moves, [&] {
    auto fault = run_block(context, words, step);
    return fault || !words.stops ? fault : end_waiting(context.sink);
  });
  if (wrong) outcome = {};
  return wrong;
}

std::int64_t held_pieces(const MotionState& state) {
  return static_cast<std::int64_t>(state.lookahead.corner.size() + state.lookahead.radius.size());
}

std::size_t held_bytes(const MotionState& state) {
  return (state.lookahead.corner.capacity() + state.lookahead.radius.capacity()) * sizeof(Piece);
}

std::vector<std::uint32_t> held_steps(const MotionState& state) {
  std::vector<std::uint32_t> steps;
  for (const auto* pieces :
       {&state.lookahead.corner, &state.lookahead.radius, &state.pending_angle.line})
    for (const Piece& piece : *pieces) steps.push_back(piece.step);
  return steps;
}

std::optional<Fault> Motion::finish(Moves* moves) {
  if (state_.plain) return std::nullopt;
  MoveSink sink{*facts_, state_, moves};
  return whole_or_nothing(moves, [&] { return end_waiting(sink); });
}

void Motion::reset() {
  const Control& c = *facts_->control;
  if (c.common.reset_clears.value.has(Cleared::Codes)) power_on(*facts_, state_, true);
  state_.modal[at(Group::Radius)] = facts_->codes.of(Meaning::RadiusOff);
  end_cycles(*facts_, state_);
  state_.lookahead = {};
  state_.pending_angle = {};
  state_.rigid_waits = state_.data_set = false;
  state_.transform = {};
  if (c.common.reset_clears.value.has(Cleared::LocalSystem)) {
    state_.local = {};
    refresh_offset(state_);
  }
  if (std::exchange(state_.zero_is_held, false)) refresh_offset(state_);
  state_.moved_before = false;
  prepare_fast_path(*facts_, state_);
}

void Motion::write(Axes& values, int axis, double value) {
  const int i = axis_number(view(), axis);
  if (i < 0) return;
  values[static_cast<std::size_t>(i)] = is_rotary(i) || !g20(state_) ? value : value * kInch;
  refresh_offset(state_);
  prepare_fast_path(*facts_, state_);
}

void Motion::write_zero(int system, Axes& values, int axis, double value) {
  const bool waits = facts_->control->motion.written_offset.value == WrittenOffset::WhenSelected;
  if (waits && system == system_in_force(state_)) hold_zero(state_);
  if (axis == kTurn && waits) state_.tables.system_angles[system] = value;
  write(values, axis, value);
}

void Motion::set_work_offset(int system, int axis, double value) {
  if (system >= 0 && system <= 6)
    write_zero(system, state_.tables.work[static_cast<std::size_t>(system)], axis, value);
}

void Motion::set_extra_offset(int p, int axis, double value) {
  if (p >= 1 && p <= static_cast<int>(state_.tables.extra.size()))
    write_zero(6 + p, state_.tables.extra[static_cast<std::size_t>(p - 1)], axis, value);
}

void Motion::set_offset(VariableKind kind, int number, double value) {
  if (kind == VariableKind::Shift) return write(state_.kept_shift, number - 1, value);
  if (kind == VariableKind::ReferencePoint) {
    const int point = number / kReferenceStep + 1;
    return write(state_.tables.reference[point], number % kReferenceStep, value);
  }
  std::vector<double>* table = state_.tables.of(kind);
  if (table == nullptr || number < 0 || number >= static_cast<int>(table->size())) return;
  state_.row_moves = nullptr;  // compensation may use the offset
  (*table)[static_cast<std::size_t>(number)] = value * (g20(state_) ? kInch : 1);
}

}  // namespace cncsub
