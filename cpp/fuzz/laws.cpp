// The laws that every run obeys: all ways to run it give the same result, and what it reports is
// finite, in order and clean.
#include "laws.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cncsub::fuzz {

namespace {

constexpr std::size_t kMostCompared = 20'000;  // rows of moves
constexpr std::uint64_t kPlenty = 1 << 30;     // more bytes than a fuzzer's run needs

/// The tolerance for values that count as the same: absolute, and as a share of the value.
double rounding = 0;

bool same(double a, double b) {
  return a == b || (std::isnan(a) && std::isnan(b)) ||
         std::fabs(a - b) <= rounding * (1 + std::fabs(a));
}

bool same_values(const std::map<std::int32_t, double>& a, const std::map<std::int32_t, double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
    return x.first == y.first && same(x.second, y.second);
  });
}

void same_stop(const Machine& a, const Machine& b) {
  claim(a.stop() == b.stop(), "both stop for the same reason");
  claim(a.blocks() == b.blocks(), "both execute the same number of blocks");
  claim(a.state().waiting_for == b.state().waiting_for, "both wait for the same thing");
  claim(a.alarm().has_value() == b.alarm().has_value(), "both alarm");
  if (a.alarm()) claim(message(*a.alarm()) == message(*b.alarm()), "both give the same alarm");
  claim(a.frames().size() == b.frames().size(), "both have the same calls open");
  claim(a.state().level == b.state().level && a.state().pc == b.state().pc,
        "both stand at the same block");
}

void same_state(const Machine& a, const Machine& b) {
  for (int level = 0; level <= a.state().level; level += std::max(1, a.state().level))
    claim(same_values(a.variables(level), b.variables(level)), "both have the same variables");
  const auto at = position(a.motion().view()), other = position(b.motion().view());
  claim(at.size() == other.size(), "both have the same axes");
  for (std::size_t i = 0; i < at.size(); ++i)
    claim(at[i].first == other[i].first && same(at[i].second, other[i].second),
          "both stand at the same point");
  claim(modal(a.motion().view()) == modal(b.motion().view()), "both have the same modal state");
  claim(same(a.motion().time(), b.motion().time()), "both took the same time");
}

template <class T>
bool same_column(const Column<T>& a, const Column<T>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(a[i] == b[i])) return false;
  return true;
}

void same_rows(const Trace& a, const Trace& b) {
  claim(a.steps.size() == b.steps.size(), "both have as many steps");
  for (std::size_t i = 0; i < a.steps.size(); ++i) {
    const Trace::Step x = a.steps[i], y = b.steps[i];
    claim(x.address == y.address && x.call == y.call && x.repeat == y.repeat, "step by step");
  }
  claim(a.calls.size() == b.calls.size(), "both have as many calls");
  for (std::size_t i = 0; i < a.calls.size(); ++i) {
    const CallRow x = a.calls[i], y = b.calls[i];
    claim(x.program == y.program && x.parent == y.parent && x.first_step == y.first_step &&
              x.last_step == y.last_step && x.arguments == y.arguments,
          "call by call");
  }
  claim(a.arguments.size() == b.arguments.size(), "both pass as many arguments");
  for (std::size_t i = 0; i < a.arguments.size(); ++i)
    claim(same(a.arguments[i].value, b.arguments[i].value), "argument by argument");
  claim(same_column(a.codes, b.codes), "both send the same codes");
  claim(same_column(a.messages, b.messages), "both print the same");
}

void same_moves(const Moves& a, const Moves& b) {
  claim(a.size() == b.size() && a.axes() == b.axes(), "both move as often");
  if (a.size() == 0 || a.size() > kMostCompared) return;
  std::vector<double> x(a.size()), y(a.size());
  for (const char* name :
       {"x", "w", "mz", "cx", "feed", "spindle", "length", "time", "sx", "msz", "mcy"}) {
    a.columns({name}, {x.data()});
    b.columns({name}, {y.data()});
    claim(std::equal(x.begin(), x.end(), y.begin(), same), "move by move");
  }
}

void same_run(const Machine& a, const Machine& b) {
  same_stop(a, b);
  same_state(a, b);
  same_rows(a.trace(), b.trace());
  same_moves(a.trace().moves, b.trace().moves);
}

/// Check the moves: each is finite, they come in the order of their steps, none is shorter than its
/// chord or leaves the travel, and their times add up to the time of the run.
void check_moves(const Machine& machine, const Options& options) {
  const Moves& moves = machine.trace().moves;
  if (moves.size() == 0 || moves.size() > kMostCompared) return;
  const bool lathe = options.setup.machine.empty()
                         ? machine.code().control->motion.machine.value != MachineType::Mill
                         : options.setup.machine != "mill";
  MoveRow before = moves.row(0);
  double time = 0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const MoveRow row = moves.row(i);
    claim(row.step >= before.step && row.step <= machine.blocks(), "moves come in order");
    double chord = 0;
    for (std::size_t axis = 0; axis < row.point.size(); ++axis) {
      claim(std::isfinite(row.point[axis]) && std::isfinite(row.machine[axis]),
            "a move ends somewhere");
      const double way =
          (row.machine[axis] - before.machine[axis]) * (lathe && axis == 0 ? 0.5 : 1);
      if (axis < 3) chord += way * way;
    }
    for (const double centre : row.centre) claim(!std::isinf(centre), "a centre is somewhere");
    claim(std::isfinite(row.state->feed) && std::isfinite(row.spindle), "a speed is a number");
    for (const double value : {row.length, row.time})
      claim(std::isfinite(value) && value >= 0, "a length and a time are numbers");
    const double tolerance = 1e-6 * (1 + std::fabs(row.machine[0]) + std::fabs(row.machine[1]) +
                                     std::fabs(row.machine[2]));
    claim(row.length >= std::sqrt(chord) - tolerance, "no way is shorter than its chord");
    for (const auto& [name, range] : options.setup.limits)
      if (const auto axis = kAxisNames.find(name); axis != std::string_view::npos)
        claim(row.machine[axis] >= range.first - 1e-6 && row.machine[axis] <= range.second + 1e-6,
              "the tool stays inside the travel");
    time += row.time;
    before = row;
  }
  const double whole = machine.motion().time();
  claim(std::fabs(time - whole) <= 1e-9 * (1 + whole),
        "the times of the moves are that of the run");
  const Moves::Bounds bounds = moves.bounds();
  for (std::size_t axis = 0; axis < before.point.size(); ++axis)
    claim(!(bounds.low[axis] > before.point[axis]) && !(bounds.high[axis] < before.point[axis]) &&
              !std::isinf(bounds.low[axis]) && !std::isinf(bounds.high[axis]),
          "the bounds hold the moves");
}

/// Return whether a text of ours is clean: no number in it is nan, inf or a negative zero, except
/// where it quotes in brackets.
bool clean(const std::string& whole) {
  std::string text;
  int depth = 0;
  for (const char c : whole) {
    depth += c == '[' ? 1 : 0;
    if (depth == 0) text += c;
    depth -= c == ']' && depth > 0 ? 1 : 0;
  }
  for (const std::string_view word : {"nan", "inf", "-0"})
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
      const auto letter = [&](std::size_t i) {
        return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0 ||
                                   text[i] == '.' || text[i] == '"' || text[i] == '<');
      };
      if (!letter(at + word.size()) && (at == 0 || !letter(at - 1))) return false;
    }
  return true;
}

void check_alarm(const Alarm& alarm) {
  claim(!message(alarm).empty(), "an alarm has a message");
  claim((alarm.line >= 1 && alarm.column >= 1) || alarm.source_line.empty(),
        "an alarm has a place");
  claim(alarm.cause == Cause::UserAlarm || clean(alarm.detail), "the detail of an alarm is clean");
  const bool cut = alarm.source_line.size() == kLongestSource;
  claim(cut || alarm.source_line.find(alarm.word) != std::string::npos,
        "the word stands in its line");
}

/// Check what holds for every run that has stopped.
void check(const Machine& machine, const Options& options) {
  claim(machine.stop() != Stop::Running, "a run stops");
  claim(machine.alarm().has_value() == (machine.stop() == Stop::Alarm), "an alarm stops");
  claim(machine.blocks() <= options.max_blocks + 1, "no more blocks than were asked for");
  if (options.trace >= Trace::Depth::Blocks)
    claim(static_cast<std::int64_t>(machine.trace().steps.size()) == machine.blocks(),
          "one row for each step");
  for (std::size_t i = 0; i < machine.trace().calls.size(); ++i) {
    const CallRow call = machine.trace().calls[i];
    claim(call.parent < static_cast<std::int64_t>(i), "a caller comes first");
    claim(call.first_step <= call.last_step + 1 && call.last_step < machine.blocks(),
          "a call spans steps");
    claim(call.first_argument + std::size_t{call.arguments} <= machine.trace().arguments.size(),
          "a call has its arguments");
  }
  for (const auto& [axis, value] : position(machine.motion().view()))
    claim(std::isfinite(value), "a position is a number");
  claim(machine.motion().time() >= 0, "time goes on");
  check_moves(machine, options);
  if (machine.alarm()) check_alarm(*machine.alarm());
}

void step_to_the_end(Machine& machine) {
  while (machine.step()) {
  }
}

/// Run on, paused before every other block and interrupted now and then.
void run_with_pauses(Machine& machine) {
  while (machine.stop() == Stop::Running) {
    const std::int64_t from = machine.blocks();
    machine.run({}, [from](const Machine& m) { return m.blocks() >= from + 2; });
    if (machine.blocks() % 3 == 0) {
      machine.interrupt();
      machine.run({}, [from](const Machine& m) { return m.blocks() > from + 2; });
    }
  }
}

/// Run in parts of `blocks` blocks; the parts together are what one run recorded.
void run_in_parts(Machine machine, std::int64_t blocks, const Machine& whole) {
  std::int64_t steps = 0, moves = 0;
  std::size_t calls = 0, messages = 0;
  bool stopped = false;
  while (!stopped) {
    const std::int64_t from = machine.blocks();
    machine.run({}, blocks);
    stopped = machine.stop() != Stop::Running;
    const Trace part = machine.take();
    claim(part.first_step == from && part.first_move == moves, "a part begins where one ended");
    for (std::size_t i = 0; i < part.steps.size(); ++i)
      claim(
          part.steps[i].address == whole.trace().steps[static_cast<std::size_t>(steps) + i].address,
          "the steps of a part");
    for (std::size_t i = 0; i < part.ended_calls(); ++i)
      claim(part.ended_call(i) < part.calls.size(), "a call that ended is in the part");
    part.moves.bounds();
    steps += static_cast<std::int64_t>(part.steps.size());
    moves += static_cast<std::int64_t>(part.moves.size());
    calls += part.ended_calls();
    messages += part.messages.size();
  }
  same_stop(machine, whole);
  same_state(machine, whole);
  claim(steps == static_cast<std::int64_t>(whole.trace().steps.size()), "all steps in parts");
  claim(moves == static_cast<std::int64_t>(whole.trace().moves.size()), "all moves in parts");
  claim(calls == whole.trace().calls.size(), "all calls in parts");
  claim(messages == whole.trace().messages.size(), "all messages in parts");
}

/// Check that after an alarm the state is that before the block, or that after its words where
/// these are a step.
void alarm_changes_nothing(Machine machine, const Machine& alarmed) {
  while (machine.blocks() < alarmed.blocks() && machine.step()) {
  }
  if (machine.stop() != Stop::Running || machine.blocks() != alarmed.blocks()) return;
  const Moves &rows = machine.trace().moves, &others = alarmed.trace().moves;
  claim(rows.size() == others.size(), "a block that alarms leaves no move");
  same_state(machine, alarmed);
}

/// Check that the depth of the trace changes nothing of what is done.
void other_depths(const std::shared_ptr<const Code>& code, std::int32_t main, Options options,
                  const Machine& whole) {
  for (const auto depth : {Trace::Depth::None, Trace::Depth::Calls, Trace::Depth::Moves}) {
    options.trace = depth;
    Machine machine(code, main, options);
    machine.run({});
    same_stop(machine, whole);
    same_state(machine, whole);
  }
}

/// Check that the fast paths do what the general path does, except for the order in which numbers
/// are added.
void by_the_general_way(const Job& job, const Machine& whole) {
  std::int32_t main = 0;
  const auto code = library_of(job, main, true);
  Machine machine(code, main, job.options);
  machine.run({});
  rounding = 1e-9;
  same_run(machine, whole);
  rounding = 0;
}

void write_by_hand(Machine& machine, const Job& job) {
  for (const auto& [number, value] : job.by_hand) {
    machine.write(number, machine.state().level, value);
    double read = 0;
    machine.read(number, machine.state().level, read);
    machine.read(number, 0, read);
  }
}

}  // namespace

void try_all_ways(const Job& job) {
  std::int32_t main = 0;
  const auto code = library_of(job, main);
  check_words(*code);

  const Machine fresh(code, main, job.options);
  Machine whole = fresh;
  whole.run({});
  check(whole, job.options);
  // Where memory ends a run depends on when its use is checked.
  if (job.options.max_memory < kPlenty) return;
  if (whole.stop() == Stop::Alarm) alarm_changes_nothing(fresh, whole);
  other_depths(code, main, job.options, whole);
  by_the_general_way(job, whole);

  Machine stepped = fresh;
  for (std::size_t i = 0; i < job.copied_after && stepped.step(); ++i) {
  }
  Machine copy = stepped;
  write_by_hand(stepped, job);
  step_to_the_end(stepped);
  if (job.by_hand.empty()) same_run(whole, stepped);
  write_by_hand(copy, job);
  run_with_pauses(copy);
  check(copy, job.options);
  same_run(stepped, copy);
  run_in_parts(fresh, 1 + static_cast<std::int64_t>(job.copied_after), whole);

  whole = copy;
  whole.reset();
  copy.reset();
  whole.run({});
  step_to_the_end(copy);
  same_run(whole, copy);
}

}  // namespace cncsub::fuzz
