#include "cncsub/machine/machine.hpp"

#include <algorithm>
#include <utility>

#include "cncsub/machine/run/run.hpp"
#include "cncsub/machine/state/limits.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/values/variables.hpp"
#include "cncsub/machine/values/watch.hpp"
#include "cncsub/motion/state/values.hpp"

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

bool Machine::step(const std::function<bool()>& interrupted) { return run_one(run_, interrupted); }

void Machine::run(const std::function<bool()>& interrupted,
                  const std::function<bool(const Machine&)>& pause) {
  if (pause)
    run_on(run_, interrupted, [&] { return pause(*this); });
  else
    run_on(run_, interrupted, {});
}

void Machine::run(const std::function<bool()>& interrupted, std::int64_t blocks) {
  const std::int64_t most = kAllBlocks - 1 - run_.state.executed;
  run_on(run_, interrupted, {}, run_.state.executed + std::min(blocks, most));
}

void Machine::interrupt() {
  if (stop() == Stop::Running) end_run(run_, Stop::Interrupted);
}

void Machine::reset() {
  State& s = run_.state;
  finish_calls(run_);
  run_.motion.reset();
  s.modals.clear();
  s.loops.clear();
  s.waiting.clear();
  s.frames.resize(1);
  s.frames[0].repeat = 1;
  s.level = 0;
  s.subprograms = s.macros = 0;
  s.cycles = 0;
  clear_variables(run_);
  set_own_parameters(run_);
  s.stop = Stop::Running;
  s.alarm.reset();
  s.waiting_for.clear();
  s.pc = s.frames[0].restart;
  note_changes_from_outside(run_);
}

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

std::optional<Fault> Machine::read(std::int64_t number, int level, double& value) const {
  return read_variable(run_, number, level, value);
}

std::optional<Fault> Machine::write(std::int64_t number, int level, double value) {
  auto fault = write_variable(run_, number, level, value);
  note_changes_from_outside(run_);
  return fault;
}

void Machine::set_from_outside(std::int32_t number, double value) {
  cncsub::set_from_outside(run_, number, value);
  note_changes_from_outside(run_);
}

}  // namespace cncsub
