#include "cncsub/machine/run/breakpoints.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "cncsub/machine/run/aside.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/query.hpp"

namespace cncsub {

namespace {

/// Return the call that opened the present level of locals; -1: the main program's.
std::int32_t opener_of_level(const State& s) {
  for (std::size_t i = s.frames.size(); i-- > 1;)
    if (s.frames[i].own_locals) return s.frames[i].call;
  return -1;
}

/// Return the programmed point, as the column of the moves has it.
double coordinate(const Run& run, char axis) {
  const MotionState& state = run.motion.state();
  return as_programmed(state, state.work)[static_cast<std::size_t>(axis_of(axis))];
}

/// Forget the rows of moves that only breakpoints look at.
void forget_moves(Run& run) {
  run.trace.moves.rewind({});
  run.motion.forget_table();
}

/// Return whether a block comes next. A run that was interrupted stands before one.
bool goes_on(const Run& run) {
  return run.state.stop == Stop::Running || run.state.stop == Stop::Interrupted;
}

constexpr std::int32_t kTyped = -2;  // in place of the program of a typed text

bool same(double a, double b) { return a == b || (is_vacant(a) && is_vacant(b)); }

}  // namespace

Breakpoints::Breakpoints(std::vector<Breakpoint> list, ExpressionList expressions,
                         const Run& present, bool on_opening)
    : list_(std::move(list)),
      expressions_(std::move(expressions)),
      marked_(present.code->blocks.size()),
      on_opening_(on_opening),
      level_(present.state.level),
      opened_by_(opener_of_level(present.state)),
      met_(list_.size()) {
  for (const ExpressionList::One& one : expressions_.list)
    of_level_.push_back(reads_locals(expressions_, one));
  for (const Breakpoint& of : list_) {
    each_ = each_ || of.kind != Breakpoint::Kind::Block;
    for (const Address block : of.blocks) marked_[block] = 1;
  }
}

void Breakpoints::begin(Run& run, bool here) {
  begun_ = here ? -1 : run.state.executed;
  seen_.clear();
  run.watch.sees_moves = run.trace.depth != Trace::Depth::Moves && watches_axis();
  look(run);
}

void Breakpoints::end(Run& run) {
  if (!std::exchange(run.watch.sees_moves, false)) return;
  forget_moves(run);
}

bool Breakpoints::watches_axis() const {
  return std::any_of(list_.begin(), list_.end(),
                     [](const Breakpoint& of) { return of.kind == Breakpoint::Kind::Axis; });
}

bool Breakpoints::pauses(Run& run) {
  reached_.clear();
  const bool moved = run.state.executed != begun_;
  for (std::size_t i = 0; i < list_.size(); ++i)
    if (meets(run, i, moved) && holds(run, i) && ++met_[i] >= list_[i].hits) reached_.push_back(i);
  if (each_) look(run);
  return !reached_.empty() || faulty_;
}

std::int64_t Breakpoints::step_of_reached(const Run& run) const {
  const bool next = std::any_of(reached_.begin(), reached_.end(),
                                [this](std::size_t i) { return list_[i].is_next(); });
  return run.state.executed - (next ? 0 : 1);
}

bool Breakpoints::meets(Run& run, std::size_t index, bool moved) {
  const Breakpoint& of = list_[index];
  switch (of.kind) {
    case Breakpoint::Kind::Block:
      return moved && goes_on(run) &&
             std::find(of.blocks.begin(), of.blocks.end(), run.state.pc) != of.blocks.end();
    case Breakpoint::Kind::Depth:
      return moved && goes_on(run) &&
             static_cast<std::int64_t>(run.state.frames.size()) - 1 <= of.number;
    case Breakpoint::Kind::Call:
      return called(run, of.number);
    case Breakpoint::Kind::Return:
      return returned(run, of.number);
    case Breakpoint::Kind::Alarm:
      return run.state.stop == Stop::Alarm && run.state.alarm &&
             (of.name.empty() || of.name == run.state.alarm->number ||
              of.name == info(run.state.alarm->cause).slug);
    case Breakpoint::Kind::Code:
      return sent(run, of);
    case Breakpoint::Kind::Axis:
      return passed(run, of, seen_[index].value);
    case Breakpoint::Kind::Value:
    case Breakpoint::Kind::Mode:
      return changed(run, index);
  }
  return false;
}

bool Breakpoints::holds(Run& run, std::size_t index) {
  if (list_[index].condition == Breakpoint::kNone) return true;
  double value = 0;
  return value_of(run, index, list_[index].condition, value) && value != 0 && !is_vacant(value);
}

bool Breakpoints::value_of(Run& run, std::size_t index, std::uint32_t expression, double& value) {
  auto fault = evaluate_aside(run, expressions_, expressions_.list[expression], value);
  if (fault && !faulty_) faulty_.emplace(index, std::move(*fault));
  return !fault;
}

bool Breakpoints::is_level_open(const Run& run) const {
  return run.state.level == level_ && opener_of_level(run.state) == opened_by_;
}

void Breakpoints::look(Run& run) {
  if (!each_) return;
  calls_ = run.trace.calls.size();
  codes_ = run.trace.codes.size();
  if (run.watch.sees_moves) forget_moves(run);
  rows_ = run.trace.moves.size();
  const std::vector<OpenFrame>& open = run.state.frames;
  frames_.resize(open.size());
  for (std::size_t i = 0; i < open.size(); ++i)
    frames_[i] = {open[i].call, open[i].typed ? kTyped : open[i].program};
  if (seen_.empty()) {
    seen_.resize(list_.size());
    for (std::size_t i = 0; i < list_.size(); ++i) seen_[i] = seen_now(run, i);
  }
}

Breakpoints::Seen Breakpoints::seen_now(Run& run, std::size_t index) {
  const Breakpoint& of = list_[index];
  Seen seen;
  if (of.kind == Breakpoint::Kind::Mode) seen.modes = modal(run.motion.view());
  if (of.kind == Breakpoint::Kind::Axis) seen.value = coordinate(run, of.letter);
  if (of.kind != Breakpoint::Kind::Value) return seen;
  seen.open = !of_level_[of.expression] || is_level_open(run);
  // What has no value yet, such as a variable that nobody has set, gets one: that is a change.
  if (seen.open && evaluate_aside(run, expressions_, expressions_.list[of.expression], seen.value))
    seen.value = kVacant;
  return seen;
}

bool Breakpoints::called(const Run& run, std::int64_t program) const {
  for (std::size_t row = calls_; row < run.trace.calls.size(); ++row)
    if (program < 0 || run.trace.calls[row].program == program) return true;
  return false;
}

bool Breakpoints::returned(const Run& run, std::int64_t program) const {
  const std::vector<OpenFrame>& open = run.state.frames;
  for (std::size_t i = frames_.size(); i-- > 1;) {
    if (i < open.size() && open[i].call == frames_[i].first) return false;
    if (frames_[i].second != kTyped && (program < 0 || frames_[i].second == program)) return true;
  }
  return false;
}

bool Breakpoints::sent(const Run& run, const Breakpoint& of) const {
  for (std::size_t row = codes_; row < run.trace.codes.size(); ++row) {
    const Trace::Sent& code = run.trace.codes[row];
    if (code.kind == of.letter && (of.number < 0 || code.value == static_cast<double>(of.number)))
      return true;
  }
  return false;
}

/// Return whether the moves since the last look lead over the value, or reach it; `from` goes on.
bool Breakpoints::passed(const Run& run, const Breakpoint& of, double& from) const {
  bool passes = false;
  const auto goes_to = [&](double to) {
    passes = passes || (from != of.value && (from < of.value) != (to < of.value)) ||
             (from != of.value && to == of.value);
    from = to;
  };
  const auto axis = static_cast<std::size_t>(axis_of(of.letter));
  for (std::size_t row = rows_; row < run.trace.moves.size(); ++row)
    goes_to(run.trace.moves.row(row).point[axis]);
  goes_to(coordinate(run, of.letter));
  return passes;
}

bool Breakpoints::changed(Run& run, std::size_t index) {
  const Breakpoint& of = list_[index];
  Seen now = seen_now(run, index);
  std::swap(now, seen_[index]);
  const Seen& before = now;
  const Seen& after = seen_[index];
  if (of.kind == Breakpoint::Kind::Value) {
    if (after.open && before.open) return !same(before.value, after.value);
    if (!after.open) {  // what the level held stands until it is open again, or for good
      if (before.open) seen_[index] = {true, before.value, {}};
      return false;
    }
    return on_opening_;
  }
  const auto code_of = [&](const Seen& seen) {
    const auto found = std::find_if(seen.modes.begin(), seen.modes.end(),
                                    [&](const auto& mode) { return mode.first == of.name; });
    return found == seen.modes.end() ? std::string() : found->second;
  };
  return of.name.empty() ? before.modes != after.modes : code_of(before) != code_of(after);
}

}  // namespace cncsub
