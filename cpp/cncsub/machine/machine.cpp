#include "cncsub/machine/machine.hpp"

#include <algorithm>
#include <utility>

#include "cncsub/machine/run/aside.hpp"
#include "cncsub/machine/run/next_block.hpp"
#include "cncsub/machine/run/run.hpp"
#include "cncsub/machine/run/typed_text.hpp"
#include "cncsub/machine/state/limits.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/values/frames.hpp"
#include "cncsub/machine/values/variables.hpp"
#include "cncsub/machine/values/watch.hpp"
#include "cncsub/motion/state/values.hpp"
#include "cncsub/text/axis_names.hpp"

namespace cncsub {

std::string_view to_string(Stop stop) {
  switch (stop) {
    case Stop::Running:
      return "running";
    case Stop::End:
      return "end";
    case Stop::Alarm:
      return "alarm";
    case Stop::Cycles:
      return "cycles";
    case Stop::Limit:
      return "limit";
    case Stop::Waiting:
      return "waiting";
    case Stop::Interrupted:
      return "interrupted";
  }
  return "";
}

namespace {

/// Give the parameters of the main program, which nobody calls, their own values.
void set_own_parameters(Run& run) {
  const Program& main = run.code->programs[static_cast<std::size_t>(run.state.frames[0].program)];
  for (std::uint32_t i = 0; i < main.parameters; ++i) {
    const FormalParameter& of = run.code->formal_parameters[main.first_parameter + i];
    run.state.locals[run.local_at(0, of.variable)] = of.otherwise;
  }
}

}  // namespace

Machine::Machine(std::shared_ptr<const Code> code, std::int32_t main, Options options)
    : run_(std::move(code), std::move(options)) {
  State& s = run_.state;
  const Options& given = run_.options;
  const Program& program = run_.code->programs[static_cast<std::size_t>(main)];
  OpenFrame frame;
  frame.program = main;
  frame.restart = program.first;
  frame.modal_limit = 1 << 20;
  frame.typed = given.mdi;
  s.frames.push_back(frame);
  set_own_parameters(run_);
  for (const auto& [number, value] : given.variables) write_variable(run_, number, value);
  s.pc = program.first;
  if (given.start >= 0) {
    const Address start = run_.code->first_of(program, given.start);
    if (start != kNowhere) s.pc = start;
  }
  begin_watching(run_);
}

bool Machine::step(const std::function<bool()>& interrupted) {
  if (history_) history_->note(run_);
  const bool executed = run_one(run_, interrupted);
  leave_typed(run_);
  return executed;
}

namespace {

/// Run on, with a snapshot for the way back where one is due. Where it pauses, `paused` says so.
void run_with(Run& run, std::optional<History>& history, const std::function<bool()>& interrupted,
              const Pauses& pauses, const bool& paused) {
  if (!history) return run_on(run, interrupted, pauses);
  do {
    history->note(run);
    run_on(run, interrupted, pauses, run.state.executed + history->distance());
  } while (run.state.stop == Stop::Running && !paused);
}

}  // namespace

void Machine::run(const std::function<bool()>& interrupted,
                  const std::function<bool(const Machine&)>& pause) {
  bool paused = false;
  if (pause)
    run_with(run_, history_, interrupted, {[&] { return paused = pause(*this); }}, paused);
  else
    run_with(run_, history_, interrupted, {}, paused);
}

Breakpoints Machine::run(const std::function<bool()>& interrupted, std::vector<Breakpoint> list,
                         const ExpressionList& expressions) {
  bool paused = false;
  Breakpoints breakpoints(std::move(list), expressions, run_);
  breakpoints.begin(run_);
  run_with(run_, history_, interrupted,
           {[&] { return paused = breakpoints.pauses(run_); }, breakpoints.marked()}, paused);
  if (!paused) breakpoints.pauses(run_);
  breakpoints.end(run_);
  return breakpoints;
}

void Machine::remember() {
  if (!history_) history_.emplace().note(run_);
}

bool Machine::back(std::int64_t step, const std::function<bool()>& interrupted) {
  return history_ && history_->back(run_, step, interrupted);
}

std::optional<std::int64_t> Machine::last_met(const std::vector<Breakpoint>& list,
                                              const ExpressionList& expressions,
                                              const std::function<bool()>& interrupted) const {
  if (!history_) return -1;
  return history_->last_met(run_, list, expressions, interrupted);
}

std::int64_t Machine::step_of_call() const {
  const std::int32_t call = run_.frame().call;
  return call < 0 ? -1 : run_.trace.calls[run_.trace.call_row(call)].caller_step;
}

Address Machine::next_block() const {
  const State& s = run_.state;
  if (s.stop == Stop::End || s.stop == Stop::Cycles) return kNowhere;
  if ((code().blocks[s.pc].skip & run_.options.skips) == 0 || s.stop == Stop::Alarm) return s.pc;
  Run probe = run_;
  probe.state.stop = Stop::Running;
  while (probe.state.stop == Stop::Running && passes_over(probe)) continue;
  return probe.state.stop == Stop::Running ? probe.state.pc : kNowhere;
}

std::optional<Alarm> Machine::evaluate(const ExpressionList& list, const ExpressionList::One& one,
                                       double& value, std::string& text) const {
  Run probe = run_;
  auto fault = evaluate_aside(probe, list, one, value);
  if (fault) return fault;
  if (one.type == ValueType::Text) text = text_of(probe, value);
  if (one.type == ValueType::Axis) text = axis_letter(value);
  if (one.type == ValueType::Frame)
    text = written(frame_of(probe, value)).value_or("a frame that shears or turns inside out");
  return std::nullopt;
}

void Machine::change(const std::function<void(Run&)>& now, const std::function<void(Run&)>& again) {
  const Address pc = run_.state.pc;
  now(run_);
  if (history_) history_->edited(run_, pc, again);
}

void Machine::run(const std::function<bool()>& interrupted, std::int64_t blocks) {
  const std::int64_t most = kAllBlocks - 1 - run_.state.executed;
  run_on(run_, interrupted, {}, run_.state.executed + std::min(blocks, most));
}

void Machine::interrupt() {
  if (stop() == Stop::Running) end_run(run_, Stop::Interrupted);
}

namespace {

void reset(Run& run) {
  State& s = run.state;
  finish_calls(run);
  run.motion.reset();
  s.modals.clear();
  s.loops.clear();
  s.waiting.clear();
  s.frames.resize(1);
  s.frames[0].repeat = 1;
  s.level = 0;
  s.subprograms = s.macros = 0;
  s.cycles = 0;
  clear_variables(run);
  set_own_parameters(run);
  s.stop = Stop::Running;
  s.alarm.reset();
  s.waiting_for.clear();
  s.pc = s.frames[0].restart;
  note_changes_from_outside(run);
}

}  // namespace

void Machine::reset() { change(&cncsub::reset, &cncsub::reset); }

std::vector<Frame> Machine::frames() const { return open_calls(run_); }

Trace Machine::take() {
  Trace::Open open{.calls = {},
                   .held = held_steps(run_.motion.state()),
                   .next_step = run_.state.executed,
                   .last = stop() != Stop::Running};
  for (const OpenFrame& frame : run_.state.frames)
    if (frame.call >= 0) open.calls.push_back(frame.call);
  run_.motion.forget_table();
  return run_.trace.take(open);
}

std::uint64_t Machine::memory() const { return cncsub::memory(run_); }

std::string Machine::axes() const {
  std::uint32_t mask = 0;
  for (const auto* blocks : {&code().blocks, &code().variants})
    for (const Block& block : *blocks) mask |= block.mask;
  return axes_of(run_.motion.view(), mask);
}

std::map<std::int32_t, double> Machine::variables(int level) const {
  return cncsub::variables(run_, level);
}

std::optional<std::string> Machine::frame_text(std::int64_t number) const {
  const auto frame = control_frame(run_.motion.state(), code().place(number));
  return frame ? written(*frame) : std::nullopt;
}

std::vector<Machine::ControlFrame> Machine::control_frames() const {
  std::vector<ControlFrame> frames;
  for (const PlacedRange& placed : code().variables) {
    const VariableRange& of = placed.range;
    if (of.kind != VariableKind::StoredFrame && of.kind != VariableKind::FrameInForce) continue;
    for (std::int64_t number = of.first; number <= of.last; ++number) {
      std::optional<FrameInForce> role;
      if (of.kind == VariableKind::FrameInForce)
        role = static_cast<FrameInForce>(code().place(number).index);
      if (role == FrameInForce::Whole || role == FrameInForce::Other) continue;
      frames.push_back(
          {code().spelling->name_of_variable(*code().control, number), role, frame_text(number)});
    }
  }
  return frames;
}

std::optional<Fault> Machine::read(std::int64_t number, int level, double& value) const {
  return read_variable(run_, number, level, value);
}

namespace {

std::optional<Fault> write(Run& run, std::int64_t number, int level, double value) {
  auto fault = write_variable(run, number, level, value);
  note_changes_from_outside(run);
  return fault;
}

}  // namespace

std::optional<Fault> Machine::write(std::int64_t number, int level, double value) {
  std::optional<Fault> fault;
  change([&](Run& run) { fault = cncsub::write(run, number, level, value); },
         [=](Run& run) { cncsub::write(run, number, level, value); });
  return fault;
}

void Machine::set_from_outside(std::int32_t number, double value) {
  const auto set = [number, value](Run& run) {
    cncsub::set_from_outside(run, number, value);
    note_changes_from_outside(run);
  };
  change(set, set);
}

std::optional<std::string> Machine::set_mode(const std::shared_ptr<const Code>& typed,
                                             const std::string& mode) {
  std::optional<std::string> refused;
  change([&](Run& run) { refused = cncsub::set_mode(run, typed, mode); },
         [=](Run& run) { cncsub::set_mode(run, typed, mode); });
  return refused;
}

std::optional<std::string> Machine::set_named(int level, const std::string& name,
                                              const std::vector<NamedValue>& values) {
  std::optional<std::string> refused;
  change([&](Run& run) { refused = cncsub::set_named(run, level, name, values); },
         [=](Run& run) { cncsub::set_named(run, level, name, values); });
  return refused;
}

std::optional<std::string> Machine::set_position(int axis, double value, Coordinates of) {
  std::optional<std::string> refused;
  change([&](Run& run) { refused = cncsub::set_position(run, axis, value, of); },
         [=](Run& run) { cncsub::set_position(run, axis, value, of); });
  return refused;
}

std::optional<std::string> Machine::set_next_block(Address to) {
  const Address pc = run_.state.pc;
  auto refused = cncsub::set_next_block(run_, to);
  // One that was refused is not done again: on the way back no limit stops the run.
  if (!refused && history_)
    history_->edited(run_, pc, [to](Run& run) { cncsub::set_next_block(run, to); });
  return refused;
}

std::optional<std::string> Machine::type_in(std::shared_ptr<const Code> with) {
  if (auto refused = refused_text(run_, *with)) return refused;
  const auto program = static_cast<std::int32_t>(with->programs.size() - 1);
  const Address pc = run_.state.pc;
  const bool drops = run_.state.stop == Stop::Alarm && run_.frame().typed;
  run_.extend(std::move(with));
  if (history_)
    history_->edited(run_, pc, [=](Run& run) { enter_typed(run, program, drops); }, true);
  enter_typed(run_, program, drops);
  return std::nullopt;
}

void Machine::set_switches(std::uint16_t skips, bool optional_stop) {
  const auto set = [=](Run& run) {
    run.options.skips = static_cast<std::uint16_t>(skips | (run.options.skips & Block::kPartEnd));
    run.options.optional_stop = optional_stop;
  };
  change(set, set);
}

}  // namespace cncsub
