// The public face: a block is executed whole, or not at all.
#include "cncsub/motion/motion.hpp"

#include <utility>

#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/cycle/cycles.hpp"
#include "cncsub/motion/fast_path.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/frame/frame_values.hpp"
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
      state_(1, state_of(*facts_, setup)),
      plan_(state_) {}

MotionState& Motion::begin_plan() {
  MotionState& plan = plan_.front();
  plan = state();
  if (plan.plain) plan.tool_at = machine_point(plan);
  plan.plain = false;  // from here on tool_at is kept
  return plan;
}

std::optional<Fault> Motion::commit(Result wrong, Moves* moves, std::size_t rows) {
  if (wrong) {
    if (moves != nullptr) moves->truncate(rows);
    return wrong;
  }
  state_.swap(plan_);
  prepare_fast_path(*facts_, now());
  return std::nullopt;
}

std::optional<Fault> Motion::execute(const NcWords& words, std::uint32_t step, Moves* moves,
                                     Outcome& outcome, MachineInputs& inputs) {
  const std::size_t rows = moves != nullptr ? moves->size() : 0;
  outcome = {};
  MotionContext plan{{*facts_, begin_plan(), moves}, outcome, inputs};
  auto wrong = run_block(plan, words, step);
  if (!wrong && words.stops) wrong = end_waiting(plan);
  if (wrong) outcome = {};
  return commit(std::move(wrong), moves, rows);
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
  if (state().plain) return std::nullopt;
  const std::size_t rows = moves != nullptr ? moves->size() : 0;
  MoveSink plan{*facts_, begin_plan(), moves};
  Result wrong = leave_corner(plan);
  if (!wrong) wrong = end_waiting(plan);
  return commit(std::move(wrong), moves, rows);
}

void Motion::set_frame(const FrameValue& frame) {
  MotionState& state = now();
  if (state.frames->program == frame) return;
  const Axes from = increments_from(state);
  state.frames.change().program = frame;
  combine_frames(state);
  refresh_offset(state);
  keep_increments(*facts_, state, from);
  prepare_fast_path(*facts_, state);
}

namespace {

std::optional<Fault> check_written(const MotionState& state, const FrameValue& frame) {
  if (g20(state))
    return Fault{.cause = Cause::CodeNotComputed,
                 .detail = "cncsub does not compute frames as values in inches"};
  if (in_range(frame)) return std::nullopt;
  return Fault{.cause = Cause::ValueOutOfRange, .detail = "the frame is out of range"};
}

}  // namespace

std::optional<Fault> Motion::set_stored_frame(int number, const FrameValue& frame) {
  if (auto wrong = check_written(state(), frame)) return wrong;
  store_frame(now(), number, frame);
  prepare_fast_path(*facts_, now());
  return std::nullopt;
}

std::optional<Fault> Motion::set_frame_in_force(FrameInForce which, const FrameValue& frame) {
  const auto refused = [](const char* why) {
    return Fault{.cause = Cause::CodeNotComputed, .detail = why};
  };
  if (auto wrong = check_written(state(), frame)) return wrong;
  if (which == FrameInForce::Other && frame == FrameValue()) return std::nullopt;
  if (which == FrameInForce::Other)
    return refused("a run has no such frame, and takes only the one that changes nothing");
  if (moves_wait(state()))
    return refused(
        "cncsub does not compute a frame while a radius is compensated or a corner waits");
  if (which == FrameInForce::Program) return set_frame(frame), std::nullopt;
  MotionState plan = state();
  const Axes from = increments_from(plan);
  if (which == FrameInForce::Settable) {
    plan.zero_is_held = true;
    plan.zero = frame.whole_shift();
    plan.frames.change().settable = frame;
    combine_frames(plan);
  } else {
    if (frame.matrix != kUnitMatrix)
      return refused("cncsub computes a basic frame that only shifts");
    write_frame(plan, 0, frame);
  }
  refresh_offset(plan);
  keep_increments(*facts_, plan, from);
  if (!in_range(plan.frame.matrix) || !in_range(plan.offset) || !in_range(plan.work))
    return Fault{.cause = Cause::ValueOutOfRange, .detail = "the frame is out of range"};
  now() = std::move(plan);
  prepare_fast_path(*facts_, now());
  return std::nullopt;
}

std::optional<std::string> Motion::stand_at(int axis, double value, Coordinates of, Moves* moves) {
  if (moves_wait(state()))
    return "a move waits for the one after it, or the radius is compensated: step on to where that"
           " is over";
  if (of == Coordinates::Machine && state().frame_angle != 0)
    return "the work coordinates are turned: set the work coordinate";
  const auto i = static_cast<std::size_t>(axis);
  MotionState& plan = begin_plan();
  const double offset = (plan.offset + plan.length)[i];
  plan.work[i] = of == Coordinates::Machine ? value - offset : value;
  plan.tool_at[i] = machine_point(plan)[i];
  plan.unmoved[i] = 0;
  plan.named |= 1U << i;
  if (!in_range(plan.work) || !in_range(plan.tool_at)) return "it is out of range";
  if (plan.frame_angle == 0)
    if (auto wrong = check_travel({*facts_, plan}, Piece{}, plan.tool_at)) return wrong->detail;
  if (moves != nullptr) {
    if (i >= 3) moves->use(1U << i);
    if (moves->size() > 0) moves->begin_next_at(in_machine(plan, plan.tool_at));
  }
  commit(std::nullopt, nullptr, 0);
  return std::nullopt;
}

void Motion::reset() {
  const Control& c = *facts_->control;
  MotionState& state = now();
  if (c.common.reset_clears.value.has(Cleared::Codes)) power_on(*facts_, state, true);
  state.modal[at(Group::Radius)] = facts_->codes.of(Meaning::RadiusOff);
  end_cycles(*facts_, state);
  state.lookahead = {};
  state.pending_angle = {};
  state.rigid_waits = state.data_set = false;
  state.transform = {};
  state.unmoved = {};
  state.pole = {};
  state.modal_round = state.corner_feed = state.contour_offset = 0;
  if (state.frames->program != FrameValue()) state.frames.change().program = {};
  if (c.common.reset_clears.value.has(Cleared::LocalSystem)) {
    state.local = {};
    refresh_offset(state);
  }
  state.zero_is_held = false;
  take_stored_frame(state);
  combine_frames(state);
  refresh_offset(state);
  state.moved_before = false;
  prepare_fast_path(*facts_, state);
}

void Motion::write(Axes& values, int axis, double value) {
  MotionState& state = now();
  const int i = axis_number(view(), axis);
  if (i < 0) return;
  values[static_cast<std::size_t>(i)] = is_rotary(i) || !g20(state) ? value : value * kInch;
  refresh_offset(state);
  prepare_fast_path(*facts_, state);
}

void Motion::set_work_offset(int system, int axis, double value) {
  MotionState& state = now();
  if (system < 0 || system > state.tables.last_system()) return;
  const bool waits = facts_->control->motion.written_offset.value != WrittenOffset::AtOnce;
  if (waits && system == system_in_force(state)) hold_zero(state);
  if (axis == kTurn && waits) state.tables.angles.change()[system] = value;
  write(state.tables.change_zero(system), axis, value);
}

void Motion::set_offset(VariableKind kind, int number, double value) {
  MotionState& state = now();
  if (kind == VariableKind::Shift) return write(state.kept_shift, number - 1, value);
  if (kind == VariableKind::ReferencePoint) {
    const int point = number / kReferenceStep + 1;
    return write(state.tables.reference.change()[point], number % kReferenceStep, value);
  }
  if (kind == VariableKind::EdgeDatum) {
    state.tables.edges.change().data[number] = value;
    return;
  }
  auto* table = state.tables.of(kind);
  if (table == nullptr || number < 0 || number >= static_cast<int>((*table)->size())) return;
  state.row_moves = nullptr;  // compensation may use the offset
  table->change()[static_cast<std::size_t>(number)] = value * (g20(state) ? kInch : 1);
}

}  // namespace cncsub
