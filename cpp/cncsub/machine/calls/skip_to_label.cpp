#include "cncsub/machine/calls/skip_to_label.hpp"

#include <utility>
#include <vector>

#include "cncsub/machine/calls/calls.hpp"
#include "cncsub/machine/state/stop.hpp"
#include "cncsub/machine/values/expressions.hpp"
#include "cncsub/motion/block/block.hpp"

namespace cncsub {

namespace {

/// Raise the alarm of a block that cannot be skipped.
bool stopped_at(Run& run, Address at, Fault fault, const std::string& sought) {
  fault.block = at;
  fault.name = sought;
  return alarm(run, fault);
}

/// Return the fault of a % that nothing follows.
Fault nothing_behind(const OWord& met) {
  Fault fault{Cause::ProgramNotFound, met.at, met.width, "there is nothing after the %"};
  fault.text = met.of_another_kind;
  return fault;
}

/// Set the result of a return that is skipped in the search for a label: it gives no value.
void pass_return(Run& run) {
  if (run.state.labels.searching) set_returned(run, 0, false);
}

/// Return whether the main program begins with a %.
bool begins_with_percent(const Run& run) {
  const auto main = static_cast<std::size_t>(run.state.frames.front().program);
  return run.code->programs[main].opening != 0;
}

}  // namespace

std::string full_name(const Run& run, std::uint32_t label) {
  const std::vector<std::string>& labels = run.code->labels;
  const std::uint32_t inside = run.frame().label;
  return (inside < labels.size() ? labels[inside] : "") + "#" + labels[label];
}

void set_returned(Run& run, double value, bool any) {
  if (run.code->returned < 0) return;
  run.state.commons[static_cast<std::size_t>(run.code->returned)] = value;
  run.state.commons[static_cast<std::size_t>(run.code->returned) + 1] = any ? 1 : 0;
}

bool read_98(Run& run, const CallRecord& record, double& p, double& l) {
  if (!value_of(run, record.p, p) || !value_of(run, record.l, l)) return false;
  return !(l < 0) ||
         alarm(run, {Cause::IllegalRepeatCount, record.l.at, record.l.width, "L is negative"});
}

bool read_skipped_blocks(Run& run, Address first, Address to, const std::string& sought) {
  const Address start = run.state.pc;
  Address at = first;
  for (; at != kNowhere && at <= to; at = run.code->head_behind(kOnTheWay, at)) {
    const Block& block = run.code->blocks[at];
    if (block.op == Op::Fault) {
      if (!run.state.labels.searching) continue;
      return stopped_at(run, at, run.code->faults[block.aux], sought);
    }
    const OWord& met = run.code->o_words[block.aux];
    if (met.kind == OWordKind::FileEnd) {
      if (met.refused != OWord::kNone && !begins_with_percent(run)) continue;
      return stopped_at(run, at, nothing_behind(met), sought);
    }
    if (at == to) break;
    if (met.kind == OWordKind::Back) {
      pass_return(run);
      continue;
    }
    double p = 0, l = kVacant;
    run.state.pc = at;
    if (!read_98(run, run.code->calls[met.call], p, l)) return false;
  }
  run.state.pc = start;
  return true;
}

bool may_be_read(Run& run, const OWord& own, std::int32_t file, const std::string& name) {
  const auto opening = [&run](std::int32_t program) {
    return run.code->programs[static_cast<std::size_t>(program)].opening;
  };
  const std::int32_t main = run.state.frames.front().program;
  if (file == main || opening(main) == 0 || opening(file) == 0) return true;
  Fault fault{Cause::ProgramNotFound, opening(file) - 1, 1, "there is nothing after the %"};
  fault.text = own.of_another_kind;
  fault.name = name;
  fault.block = run.code->programs[static_cast<std::size_t>(file)].first;
  return alarm(run, fault);
}

bool uses_words_beside(Run& run, const OWord& own) {
  if (own.beside == 0) return true;
  constexpr std::uint32_t kRotary = bit('A') | bit('B') | bit('C');
  constexpr std::uint32_t kAxisWords = bit('X') | bit('Y') | bit('Z') | kRotary;
  const MotionState& motion = run.motion.state();
  if (motion.no_motion && (own.beside & kAxisWords) != 0)
    return alarm_of_motion(run, {.cause = Cause::NoMotionCode, .at = run.state.pc, .detail = {}});
  if (in_cycle(motion) && (own.beside & kRotary) != 0)
    return alarm_of_motion(run, {.cause = Cause::CycleRotary,
                                 .at = run.state.pc,
                                 .detail = {},
                                 .word = {.addresses = kRotary}});
  NcWords words;
  words.mask = own.beside;
  words.at = run.state.pc;
  auto fault = unused_word(run.motion.view(), words);
  return !fault || alarm_of_motion(run, std::move(*fault));
}

bool skip_over(Run& run, const OWord& own, const std::string& sought) {
  run.block.next = own.next;
  const Address first = run.code->head_behind(kOnTheWay, run.state.pc);
  return read_skipped_blocks(run, first, own.next, sought);
}

bool skip_to_label(Run& run, const OWord& own) {
  run.state.labels.skipping = true;
  return skip_over(run, own, full_name(run, own.label));
}

}  // namespace cncsub
