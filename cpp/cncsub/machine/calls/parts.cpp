#include "cncsub/machine/calls/parts.hpp"

#include <string>

#include "cncsub/code/target.hpp"
#include "cncsub/machine/calls/calls.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/values/expressions.hpp"
#include "cncsub/machine/values/texts.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

/// The blocks of a part that texts name.
struct Part {
  Address first = kNowhere, end = kNowhere;
};

/// Return the nearest block of this name before the call, or else the nearest after it; of another
/// program the first.
Address first_block(const Code& code, const Program& in, const std::string& name, Address call) {
  Address found = code.named_return_target(in, name, in.first - 1);
  if (call < in.first || call >= in.last) return found;
  for (;;) {
    const Address next = found == kNowhere ? kNowhere : code.named_return_target(in, name, found);
    if (next == kNowhere || next <= found || next >= call) return found;
    found = next;
  }
}

/// Find the blocks from the one that a text names to that of another text.
bool find_part(Run& run, const CallExtras& named, const Program& in, Part& part) {
  const auto missing = [&run](const Operand& text, const char* detail) {
    return alarm(run, {Cause::PartIncomplete, text.at, text.width, detail});
  };
  const auto name_of = [&run](const Operand& text, std::string& name) {
    double value = 0;
    if (!value_of(run, text, value)) return false;
    name = capitals(trimmed(text_of(run, value)));
    return true;
  };
  std::string first, last;
  if (!name_of(named.first_text, first) || !name_of(named.last_text, last)) return false;
  part.first = first_block(*run.code, in, first, run.state.pc);
  if (part.first == kNowhere) return missing(named.first_text, "no block has this label");
  const Address end = run.code->named_return_target(in, last, part.first - 1);
  if (end == kNowhere || end < part.first)
    return missing(named.last_text, "no block with its end follows");
  part.end = end + 1;
  return true;
}

/// Execute a part whose blocks, and perhaps whose program, are found now.
bool call_part(Run& run, const Block& block, const CallRecord& record) {
  Target target;
  target.program = record.target.program;
  if (!decode_target(run, record, target)) return false;
  if (target.program == kNoProgram)
    if (auto fault = find_target(*run.code, record, target, search_of(run)))
      return alarm(run, *fault);
  Part part;
  const Program& in = run.code->programs[static_cast<std::size_t>(target.program)];
  if (!find_part(run, record.extras.get(), in, part)) return false;
  if (record.locals == CallRecord::Locals::Own && !evaluate_arguments(run, record)) return false;
  target.start = part.first;
  if (!enter(run, block.aux, target, -1)) return false;
  run.frame().part_end = part.end;
  return true;
}

}  // namespace

bool repeat_part(Run& run, const Block& block) {
  const CallRecord& record = run.code->calls[block.aux];
  if (auto fault = refused_here(run, record)) return alarm(run, *fault);
  if (record.extras.get().first_text.present()) return call_part(run, block, record);
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
