#include "cncsub/machine/state/stop.hpp"

#include <limits>
#include <string>
#include <utility>

#include "cncsub/code/fault_words.hpp"

namespace cncsub {

bool end_run(Run& run, Stop stop) {
  finish_calls(run);
  run.state.stop = stop;
  return false;
}

void finish_calls(Run& run) {
  for (const OpenFrame& open : run.state.frames)
    if (open.call >= 0)
      run.trace.calls.at(run.trace.call_row(open.call)).last_step = run.state.executed - 1;
}

void reopen_calls(Run& run) {
  for (const OpenFrame& open : run.state.frames)
    if (open.call >= 0) run.trace.reopen(open.call);
}

bool alarm(Run& run, const Fault& fault) {
  State& s = run.state;
  s.alarm = alarm_of(*run.code, fault.block != kNowhere ? fault.block : s.pc, fault);
  s.alarm->frames = open_calls(run);
  if (run.block.words_done)
    record_step(run);
  else
    rollback(run);
  return end_run(run, Stop::Alarm);
}

bool alarm_of_motion(Run& run, Fault fault) {
  fault.block = fault.at;
  point_at_word(*run.code, run.motion.view().facts.codes, fault);
  return alarm(run, fault);
}

namespace {

void take_back_together(Run& run) {
  BeforeTogether& before = run.block.before_together;
  State& s = run.state;
  for (auto of = before.variables.rbegin(); of != before.variables.rend(); ++of) {
    s.table(of->at.in)[of->at.index] = of->value;
    if (of->at.in == Reference::In::Locals && !s.programmed.empty())
      s.programmed[of->at.index] = of->programmed;
  }
  if (before.messages) run.trace.keep_messages(*before.messages);
  if (before.system) {
    s.locals = std::move(before.system->locals);
    s.system = std::move(before.system->variables);
    run.motion = std::move(before.system->motion);
  }
  before.forget();
}

}  // namespace

void rollback(Run& run) {
  take_back_together(run);
  auto& compared = run.trace.compared;
  while (!compared.empty() && compared[compared.size() - 1].step == run.state.executed)
    compared.keep(compared.size() - 1);
  if (run.block.took != run.state.executed) return;
  run.state.external_reads = run.block.before;
  run.block.took = -1;
}

std::vector<Frame> open_calls(const Run& run) {
  const std::vector<OpenFrame>& open = run.state.frames;
  std::vector<Frame> list;
  for (std::size_t i = open.size(); i-- > 1;) {
    const Program& caller = run.code->programs[static_cast<std::size_t>(open[i - 1].program)];
    const Block& block = run.code->blocks[open[i].called_at];
    Frame frame;
    frame.program = run.code->name_of(caller);
    frame.n = block.n;
    frame.line = block.line;
    frame.file = run.code->files[caller.file].name;
    frame.kind = std::string(to_string(open[i].kind));
    frame.called = run.code->name_of(open[i].program);
    frame.repeat = open[i].repeat;
    frame.repeats = open[i].repeats;
    list.push_back(std::move(frame));
  }
  return list;
}

bool restart_main(Run& run) {
  State& s = run.state;
  if (++s.cycles >= run.options.max_cycles) return end_run(run, Stop::Cycles);
  ++s.changes;
  OpenFrame& main = run.frame();
  s.loops.resize(main.loops);
  main.repeat += main.repeat < std::numeric_limits<std::int32_t>::max() ? 1 : 0;
  s.pc = main.restart;
  return true;
}

bool proceed(Run& run, Address next) {
  if (next == RunningBlock::kRestart) return restart_main(run);
  if (next == RunningBlock::kEnd) return end_run(run, Stop::End);
  run.state.pc = next;
  return true;
}

bool wait_for_operator(Run& run, const std::string& what) {
  const Inputs& inputs = run.options.inputs;
  if (!inputs.operator_given) return true;
  const std::size_t answer = run.state.next_answer++;
  if (answer < inputs.operator_starts.size() && inputs.operator_starts[answer]) return true;
  run.state.waiting_for = "cycle start after " + what;
  record_step(run);
  return proceed(run, run.block.next) && end_run(run, Stop::Waiting);
}

}  // namespace cncsub
