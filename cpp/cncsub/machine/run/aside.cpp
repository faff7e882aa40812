#include "cncsub/machine/run/aside.hpp"

#include <functional>
#include <memory>
#include <utility>

#include "cncsub/machine/state/limits.hpp"
#include "cncsub/machine/values/expressions.hpp"

namespace cncsub {

namespace {

/// What an evaluation leaves behind in a run. It is put back when this ends.
class Undone {
 public:
  Undone(Run& run, const ExpressionList& list, Address block)
      : run_(run),
        code_(std::exchange(run.code, list.code)),
        pc_(std::exchange(run.state.pc, block)),
        reads_(run.state.external_reads),
        condition_(run.state.last_condition),
        changes_(run.state.changes),
        words_done_(std::exchange(run.block.words_done, false)),
        defining_(std::exchange(run.state.labels.defining, false)),
        stop_(run.state.stop),
        alarm_(std::exchange(run.state.alarm, std::nullopt)),
        took_(std::exchange(run.block.took, -1)) {}
  Undone(const Undone&) = delete;
  Undone& operator=(const Undone&) = delete;
  // Calls are reopened where they were: nothing is allocated.
  ~Undone() {  // NOLINT(bugprone-exception-escape)
    State& s = run_.state;
    if (s.stop != stop_)
      for (const OpenFrame& frame : s.frames)
        if (frame.call >= 0) run_.trace.reopen(frame.call);
    run_.code = std::move(code_);
    s.pc = pc_;
    s.external_reads = reads_;
    s.last_condition = condition_;
    s.changes = changes_;
    run_.block.words_done = words_done_;
    s.labels.defining = defining_;
    s.stop = stop_;
    s.alarm = std::move(alarm_);
    run_.block.took = took_;
  }

 private:
  Run& run_;
  std::shared_ptr<const Code> code_;
  Address pc_;
  ExternalReads reads_;
  std::uint32_t condition_;
  std::uint64_t changes_;
  bool words_done_, defining_;
  Stop stop_;
  std::optional<Alarm> alarm_;
  std::int64_t took_;
};

}  // namespace

std::optional<Alarm> evaluate_aside(Run& run, const ExpressionList& list,
                                    const ExpressionList::One& one, double& value) {
  static const std::function<bool()> kNever;
  std::optional<AtWork> at_work;  // a long expression asks who interrupts it
  if (run.watch.interrupted == nullptr) at_work.emplace(run, kNever);
  const Undone undone(run, list, one.block);
  if (evaluate(run, one.expression, value)) return std::nullopt;
  if (run.state.alarm) return std::move(run.state.alarm);
  Alarm interrupted;
  interrupted.detail = "it was interrupted";
  return interrupted;
}

bool reads_locals(const ExpressionList& list, const ExpressionList::One& one) {
  const Expression of = list.code->expression(one.expression);
  for (auto at = of.begin(); !(at == Expression::end()); ++at) {
    const Ins op = (*at).op;
    if (op == Ins::Local || op == Ins::LocalRaw || op == Ins::Indirect || op == Ins::IndirectRaw ||
        op == Ins::Programmed || op == Ins::NamedLocal || op == Ins::Element ||
        op == Ins::Referenced || op == Ins::ReferencedElement)
      return true;
  }
  return false;
}

}  // namespace cncsub
