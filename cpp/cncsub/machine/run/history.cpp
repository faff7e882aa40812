#include "cncsub/machine/run/history.hpp"

#include <algorithm>
#include <utility>

#include "cncsub/machine/run/run.hpp"
#include "cncsub/machine/run/typed_text.hpp"
#include "cncsub/machine/state/limits.hpp"
#include "cncsub/machine/state/stop.hpp"

namespace cncsub {

namespace {

constexpr std::int64_t kNear = 64;  // blocks that are run again at once
constexpr std::size_t kNodeBytes = 64;

std::int64_t work_of(const Run& run) {
  return run.state.executed + static_cast<std::int64_t>(run.trace.moves.size());
}

template <class T>
std::size_t bytes_of(const std::vector<T>& of) {
  return of.capacity() * sizeof(T);
}

std::size_t bytes_of(const Snapshot& of) {
  const State& s = of.state;
  return sizeof(Snapshot) + 2 * (sizeof(MotionState) + held_bytes(of.motion.state())) +
         bytes_of(s.frames) + bytes_of(s.loops) + bytes_of(s.waiting) + bytes_of(s.locals) +
         bytes_of(s.programmed) + bytes_of(s.commons) + bytes_of(s.elements) + bytes_of(s.copies) +
         s.texts.bytes() + s.frame_values.bytes() +
         s.modals.size() * (sizeof(ModalCall) + bytes_of(s.locals)) + bytes_of(s.modal_stack) +
         (s.system.size() + s.signals.size() + s.names.size() + s.labels.met.size()) * kNodeBytes +
         bytes_of(of.seen);
}

/// Put a run into the state of a snapshot; what it recorded since is forgotten.
void restore(Run& run, const Snapshot& from) {
  run.state = from.state;
  fit(run.state, from.layout, *run.code);
  run.motion = from.motion;
  run.trace.rewind(from.recorded);
  reopen_calls(run);
  run.watched.seen = from.seen;
  run.options.skips = from.skips;
  run.options.optional_stop = from.optional_stop;
  run.block = {};
  run.watch.broken_off = Stop::Running;
  run.watch.in_block = 0;
}

/// Run on until so many blocks are executed, or the run stops.
void run_to(Run& run, std::int64_t step, const std::function<bool()>& interrupted,
            const Pauses& pauses = {}) {
  while (run.state.executed < step && run.state.stop == Stop::Running)
    run_on(run, interrupted, pauses, step);
}

/// Skip blocks as the run did before somebody edited it at this block.
void skip_to(Run& run, Address pc) {
  while (run.state.pc != pc && run.state.stop == Stop::Running && passes_over(run)) continue;
}

}  // namespace

void History::note(const Run& run) {
  if (run.state.stop != Stop::Running || (work_of(run) < due_ && !snapshots_.empty())) return;
  // Back at this step, what was typed in here is to be gone.
  if (!edits_.empty() && edits_.back().typed && edits_.back().at == run.state.executed) return;
  keep(run, edits_.size());
  if (snapshots_.size() > kMost || bytes_ > kMostBytes) thin();
  due_ = work_of(run) + distance_;
}

void History::keep(const Run& run, std::size_t edits) {
  if (!snapshots_.empty() && snapshots_.back()->state.executed == run.state.executed) return;
  Snapshot snapshot{.state = run.state,
                    .motion = run.motion,
                    .recorded = run.trace.mark(),
                    .seen = run.watched.seen,
                    .skips = run.options.skips,
                    .optional_stop = run.options.optional_stop,
                    .edits = edits,
                    .layout = variable_layout(*run.code),
                    .work = work_of(run)};
  snapshot.motion.forget_table();
  snapshot.bytes = bytes_of(snapshot);
  bytes_ += snapshot.bytes;
  snapshots_.push_back(std::make_shared<const Snapshot>(std::move(snapshot)));
}

/// Double the distance until half of the room is free.
void History::thin() {
  while (snapshots_.size() > 2 && (snapshots_.size() > kMost / 2 || bytes_ > kMostBytes / 2)) {
    distance_ *= 2;
    std::vector<std::shared_ptr<const Snapshot>> kept{snapshots_.front()};
    for (const auto& snapshot : snapshots_)
      if (snapshot->work - kept.back()->work >= distance_) kept.push_back(snapshot);
    snapshots_ = std::move(kept);
    bytes_ = 0;
    for (const auto& snapshot : snapshots_) bytes_ += snapshot->bytes;
    if (snapshots_.size() == 1) break;
  }
}

/// Run on to a step, with the edits on the way from that number on. `edits` becomes how many came:
/// those at the step too, up to one that typed blocks in.
void History::replay(Run& run, std::int64_t step, std::size_t& edits,
                     const std::function<bool()>& interrupted) const {
  for (; edits < edits_.size() && edits_[edits].at <= step; ++edits) {
    if (edits_[edits].typed && edits_[edits].at == step) break;
    run_to(run, edits_[edits].at, interrupted);
    if (run.state.stop == Stop::Interrupted) return;
    skip_to(run, edits_[edits].pc);
    edits_[edits].apply(run);
  }
  run_to(run, step, interrupted);
  leave_typed(run);
}

bool History::back(Run& run, std::int64_t step, const std::function<bool()>& interrupted) {
  const auto after = std::partition_point(
      snapshots_.begin(), snapshots_.end(),
      [step](const auto& snapshot) { return snapshot->state.executed <= step; });
  const Run stood = run;
  const auto kept = snapshots_;
  const std::size_t kept_bytes = bytes_;
  for (auto at = after; at != snapshots_.end(); ++at) bytes_ -= (*at)->bytes;
  snapshots_.erase(after, snapshots_.end());
  const Snapshot& from = *snapshots_.back();
  restore(run, from);
  std::size_t edits = from.edits;
  {
    const LiftedLimits lifted(run);
    // Whoever steps back once does so again: the nearer the goal, the closer the snapshots.
    for (std::int64_t gap = (step - run.state.executed) / 2; gap >= kNear; gap /= 2) {
      replay(run, step - gap, edits, interrupted);
      if (run.state.stop == Stop::Running) keep(run, edits);
    }
    replay(run, step, edits, interrupted);
  }
  if (run.state.stop == Stop::Interrupted) {
    run = stood;
    snapshots_ = kept;
    bytes_ = kept_bytes;
    return false;
  }
  edits_.resize(edits);
  due_ = work_of(run) + distance_;
  return true;
}

namespace {

/// Return whether one of the breakpoints is met by how the run stopped, where it stands.
bool is_met_by_stop(Run& stopped, const std::vector<Breakpoint>& list,
                    const ExpressionList& expressions) {
  if (stopped.state.stop != Stop::Alarm) return false;
  Breakpoints breakpoints(list, expressions, stopped);
  breakpoints.begin(stopped);
  return breakpoints.pauses(stopped) && !breakpoints.reached().empty();
}

}  // namespace

std::optional<std::int64_t> History::last_met(const Run& run, const std::vector<Breakpoint>& list,
                                              const ExpressionList& expressions,
                                              const std::function<bool()>& interrupted) const {
  Run probe = run;
  const LiftedLimits lifted(probe);
  std::int64_t end = run.state.executed;
  if (is_met_by_stop(probe, list, expressions)) return end;
  for (std::size_t i = snapshots_.size(); i-- > 0;) {
    if (interrupted && interrupted()) return std::nullopt;  // each of the parts may be short
    restore(probe, *snapshots_[i]);
    Breakpoints breakpoints(list, expressions, run, true);
    breakpoints.begin(probe, true);
    std::int64_t last = -1;
    const auto look = [&] {
      if (breakpoints.pauses(probe) && !breakpoints.reached().empty() &&
          breakpoints.step_of_reached(probe) < run.state.executed)
        last = breakpoints.step_of_reached(probe);
      return false;
    };
    std::size_t edits = snapshots_[i]->edits;
    for (; edits < edits_.size() && edits_[edits].at < end; ++edits) {
      run_to(probe, edits_[edits].at, interrupted, {look, breakpoints.marked()});
      if (probe.state.stop == Stop::Interrupted) return std::nullopt;
      look();
      skip_to(probe, edits_[edits].pc);
      edits_[edits].apply(probe);
      breakpoints.begin(probe, true);
    }
    run_to(probe, end, interrupted, {look, breakpoints.marked()});
    if (probe.state.stop == Stop::Interrupted) return std::nullopt;
    look();
    if (last >= 0) return last;
    end = snapshots_[i]->state.executed;
  }
  return -1;
}

}  // namespace cncsub
