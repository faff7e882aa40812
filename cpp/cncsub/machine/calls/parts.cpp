#include "cncsub/machine/calls/parts.hpp"

#include "cncsub/code/target.hpp"
#include "cncsub/machine/calls/calls.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/values/expressions.hpp"

namespace cncsub {

bool repeat_part(Run& run, const Block& block) {
  const CallRecord& record = run.code->calls[block.aux];
  if (auto fault = refused_here(run, record)) return alarm(run, *fault);
  CallOperands values;
  if (!value_of(run, record.l, values.l)) return false;
  Target target = record.target;
  if (auto fault = decode_call(*run.code, record, values, run.frame().program, target))
    return alarm(run, *fault);
  return enter(run, block.aux, target, -1);
}

bool end_pass(Run& run) {
  State& s = run.state;
  OpenFrame& open = run.frame();
  if (open.part_end != s.pc) return false;
  ++s.changes;
  if (open.repeat < open.repeats) {
    ++open.repeat;
    s.loops.resize(open.loops);
    s.pc = open.restart;
    return true;
  }
  leave(run, open.return_to, true);
  return true;
}

}  // namespace cncsub
