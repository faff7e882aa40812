#include "cncsub/machine/run/endless.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <map>
#include <unordered_set>
#include <utility>

#include "cncsub/machine/calls/returns.hpp"
#include "cncsub/machine/run/run.hpp"
#include "cncsub/machine/values/variables.hpp"
#include "cncsub/motion/query.hpp"

namespace cncsub {

namespace {

constexpr double kMostSeconds = 2;         // that the search may take
constexpr std::size_t kMostChanging = 20;  // names that are reported

// ---- comparison: are two states the same for all that the program will do? ----

// Compares bit by bit: a vacant value is a NaN, and -0 is not 0 to ATAN.
bool same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same(const std::vector<double>& a, const std::vector<double>& b, std::size_t count) {
  const auto end = [count](const std::vector<double>& of) {
    return of.begin() + static_cast<std::ptrdiff_t>(std::min(count, of.size()));
  };
  return std::equal(a.begin(), end(a), b.begin(), end(b),
                    [](double one, double other) { return same(one, other); });
}
bool same(const std::vector<double>& a, const std::vector<double>& b) {
  return same(a, b, std::max(a.size(), b.size()));
}

bool same(const ModalCall& a, const ModalCall& b) {
  return a.record == b.record && a.target == b.target && same(a.locals, b.locals) &&
         a.program == b.program && a.every_block == b.every_block;
}

// The step is not compared: it counts for the record only.
bool same(const WaitingBlock& a, const WaitingBlock& b) {
  return a.op == b.op && a.aux == b.aux && a.at == b.at && a.target == b.target && same(a.p, b.p) &&
         same(a.l, b.l) && same(a.arguments, b.arguments) && a.programmed == b.programmed;
}

template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const T& one, const T& other) { return same(one, other); });
}

/// Return whether the open calls and the passes left are the same. Only max_cycles knows of the
/// main program's passes, and only the record of the numbers of calls and passes.
bool same_frames(const std::vector<OpenFrame>& a, const std::vector<OpenFrame>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    OpenFrame one = a[i];
    one.call = b[i].call;
    if (i > 0) one.repeats += b[i].repeat - one.repeat;  // M99 L counts on from the pass
    one.repeat = b[i].repeat;
    if (one != b[i]) return false;
  }
  return true;
}

/// Return whether both states know as much of jumps back, which show a wait for the world outside.
bool same_waits(const State& a, const State& b) {
  return (a.changes == a.changes_at_jump) == (b.changes == b.changes_at_jump) &&
         a.jumped_from == b.jumped_from && a.last_condition == b.last_condition;
}

/// Compare the arrays of the open levels.
bool same_elements(const State& a, const State& b) {
  const std::size_t most = std::min(a.elements.size(), b.elements.size());
  return std::equal(a.elements.begin(), a.elements.begin() + static_cast<std::ptrdiff_t>(most),
                    b.elements.begin());
}

bool same_variables(const State& a, const State& b, std::size_t locals) {
  if (a.level != b.level) return false;
  const std::size_t open = locals * (static_cast<std::size_t>(a.level) + 1);
  return same(a.locals, b.locals, open) && same_elements(a, b) &&
         std::equal(a.programmed.begin(),
                    a.programmed.begin() +
                        static_cast<std::ptrdiff_t>(std::min(open, a.programmed.size())),
                    b.programmed.begin()) &&
         same(a.commons, b.commons) && same(a.copies, b.copies) && a.system == b.system &&
         a.signals == b.signals && a.names == b.names;
}

bool same_place(const State& a, const State& b) {
  return a.pc == b.pc && a.moved_at == b.moved_at && a.subprograms == b.subprograms &&
         a.macros == b.macros && a.loops == b.loops && same_frames(a.frames, b.frames);
}

bool same(const State& a, const State& b, std::size_t locals) {
  return same_place(a, b) && same_variables(a, b, locals) && a.last_m == b.last_m &&
         a.last_n == b.last_n && a.external_reads == b.external_reads &&
         a.next_write == b.next_write && a.next_answer == b.next_answer && same_waits(a, b) &&
         same(a.modals, b.modals) && same(a.waiting, b.waiting) && a.labels == b.labels;
}

/// Return the motion state without what counts for the record only. The time counts where a program
/// can read it.
MotionState of_no_time(MotionState state, bool with_time) {
  if (!with_time) state.time = 0;
  state.row_state = 0;
  state.row_moves = nullptr;
  for (auto* pieces : {&state.pending_angle.line, &state.lookahead.corner, &state.lookahead.radius})
    for (Piece& piece : *pieces) piece.step = 0;
  return state;
}

bool same(const MotionState& a, const MotionState& b, bool with_time) {
  // Compares what differs most often first, before anything is copied.
  if (a.work != b.work || a.modal != b.modal) return false;
  return of_no_time(a, with_time) == of_no_time(b, with_time);
}

// ---- the search ----

/// A copy of a run that records nothing. Only the limits stop it: `blocks` more blocks, seconds and
/// memory.
class Probe {
 public:
  Probe(const Run& of, std::int64_t blocks) : run_(of) {
    run_.trace = {};
    run_.trace.depth = Trace::Depth::None;
    run_.motion.forget_table();
    run_.watched = {};
    run_.options.max_cycles = std::numeric_limits<std::int64_t>::max();
    run_.options.max_blocks = run_.state.executed + blocks;
    run_.options.max_seconds = kMostSeconds;
    run_.watch.spent = 0;
    for (OpenFrame& frame : run_.state.frames) frame.call = -1;
    run_.state.stop = Stop::Running;
    run_.state.external_reads.time = false;
    run_.state.external_reads.asked = 0;
  }

  /// Execute one block. Return false where the run stops instead, or `gives_up`.
  bool step(const std::function<bool()>& gives_up) {
    const std::int64_t cycles = run_.state.cycles;
    const Address at = run_.state.pc;
    if (!run_one(run_, {}) || run_.state.stop != Stop::Running || gives_up()) return false;
    if (run_.state.cycles != cycles) restarted_at = at;
    return true;
  }

  /// The state at one time, to compare with later ones.
  struct Snapshot {
    State state;
    MotionState motion;
  };
  Snapshot snapshot() const { return {run_.state, run_.motion.state()}; }
  bool stands_as(const Snapshot& then) const {
    return run_.state.pc == then.state.pc &&
           same(run_.state, then.state, static_cast<std::size_t>(run_.code->locals)) &&
           same(run_.motion.state(), then.motion, run_.state.external_reads.time);
  }
  /// Return whether the run is at the same block in as many calls.
  bool passes(const State& then) const {
    return run_.state.pc == then.pc && run_.state.frames.size() == then.frames.size() &&
           run_.state.level == then.level;
  }

  Run& run() { return run_; }
  const Run& run() const { return run_; }

  Address restarted_at = kNowhere;  // the last block that started the main program over

 private:
  Run run_;
};

/// Return the blocks that run next, each once, from the first one of the outermost program on.
std::vector<Address> blocks_of_loop(Probe& probe, std::int64_t period) {
  Run& run = probe.run();
  run.trace.depth = Trace::Depth::Blocks;
  run.options.max_blocks = run.state.executed + period;
  std::pair<std::size_t, Address> outermost{run.state.frames.size(), kNowhere};
  std::size_t head = 0;
  for (std::int64_t i = 0; i < period; ++i) {
    const std::size_t depth = run.state.frames.size();
    const std::size_t row = run.trace.steps.size();
    if (!probe.step([] { return false; }) || run.trace.steps.size() == row) break;
    const std::pair<std::size_t, Address> at{depth, run.trace.steps[row].address};
    if (at < outermost) {
      outermost = at;
      head = row;
    }
  }
  const std::size_t rows = run.trace.steps.size();
  std::vector<Address> blocks;
  std::unordered_set<Address> seen;
  for (std::size_t i = 0; i < rows; ++i) {
    const Address address = run.trace.steps[(head + i) % rows].address;
    if (seen.insert(address).second) blocks.push_back(address);
  }
  return blocks;
}

/// Return a variable as the program writes it.
std::string name_of(const Run& run, std::int64_t number) {
  return run.code->spelling->name_of_variable(*run.code->control, number);
}

/// Return the name of what was read from the world outside since `asked` was cleared.
std::string asked_outside(const Run& run) {
  const std::int64_t asked = run.state.external_reads.asked;
  if (asked == 0) return "";
  return asked == ExternalReads::kSkipSignal ? "the skip signal" : name_of(run, asked);
}

/// Return the values of the state that have a name.
std::map<std::string, double> named(const Run& run) {
  std::map<std::string, double> values;
  for (const auto& [number, value] : variables(run, run.state.level))
    values[name_of(run, number)] = value;
  for (const auto& [axis, value] : position(run.motion.view())) values[axis] = value;
  return values;
}

/// Return the names of what differs when the run comes to this block again.
std::vector<std::string> changing_in(Probe& probe, std::int64_t blocks,
                                     const std::function<bool()>& gives_up) {
  const State before = probe.run().state;
  std::map<std::string, double> was = named(probe.run());
  probe.run().options.max_blocks = before.executed + blocks;
  std::vector<std::string> changing;
  while (probe.step(gives_up)) {
    if (!probe.passes(before)) continue;
    const std::map<std::string, double> now = named(probe.run());
    for (const auto& [name, value] : now) {
      const auto old = was.find(name);
      if (old == was.end() || !same(old->second, value)) changing.push_back(name);
    }
    for (const auto& [name, value] : was)
      if (!now.contains(name)) changing.push_back(name);
    ExternalReads external_reads = before.external_reads;
    external_reads.time = probe.run().state.external_reads.time;
    external_reads.asked = probe.run().state.external_reads.asked;
    if (probe.run().state.external_reads != external_reads)
      changing.emplace_back("what it reads from outside");
    break;
  }
  if (changing.size() > kMostChanging) changing.resize(kMostChanging);
  return changing;
}

/// Find the period by Brent's method; return 0 where there is none. The state is kept after 1, 2,
/// 4, 8 ... blocks, and every state compared with the one that is kept.
std::int64_t period_of(Probe& probe, const std::function<bool()>& gives_up) {
  Probe::Snapshot kept = probe.snapshot();
  std::int64_t power = 1;
  std::int64_t behind = 0;
  while (probe.step(gives_up)) {
    ++behind;
    if (probe.stands_as(kept)) return behind;
    if (behind < power) continue;
    kept = probe.snapshot();
    power *= 2;
    behind = 0;
  }
  return 0;
}

}  // namespace

std::string_view to_string(Endless::Kind kind) {
  switch (kind) {
    case Endless::Kind::Repeats:
      return "repeats";
    case Endless::Kind::Loop:
      return "loop";
    case Endless::Kind::Waiting:
      return "waiting";
    case Endless::Kind::Long:
      return "long";
  }
  return "";
}

/// Fill in the loop of a state that came back, and whether it is proven.
static void take_loop(Probe& probe, Endless& found) {
  // A loop that is entered after the last start does not start the program over.
  probe.restarted_at = kNowhere;
  probe.run().state.external_reads.asked = 0;
  found.blocks = blocks_of_loop(probe, found.period);
  found.outside = asked_outside(probe.run());
  found.proven = found.outside.empty();
  if (probe.restarted_at == kNowhere)
    found.kind = found.proven ? Endless::Kind::Loop : Endless::Kind::Long;
}

Endless why_endless(const Run& run, std::int64_t blocks, const std::function<bool()>& gives_up) {
  Endless found;
  const Stop stop = run.state.stop;
  if (stop != Stop::Limit) {
    found.kind = stop == Stop::Waiting ? Endless::Kind::Waiting : Endless::Kind::Repeats;
    // A block that waits for the operator is done.
    if (stop != Stop::Waiting || run.state.waiting_for.starts_with('#'))
      found.blocks = {run.state.pc};
    return found;
  }
  Probe probe(run, blocks);
  found.period = period_of(probe, gives_up);
  found.looked = probe.run().state.executed - run.state.executed;
  if (probe.restarted_at != kNowhere || run.state.cycles > 0) found.kind = Endless::Kind::Repeats;
  if (found.period > 0) {
    take_loop(probe, found);
  } else {
    if (probe.run().state.stop != Stop::Limit) found.then = probe.run().state.stop;
    if (found.then == Stop::Running) {
      Probe again(probe.run(), blocks);
      found.changing = changing_in(again, blocks, gives_up);
    }
  }
  if (found.kind == Endless::Kind::Repeats)
    found.blocks = probe.restarted_at == kNowhere ? std::vector<Address>{}
                                                  : std::vector<Address>{probe.restarted_at};
  return found;
}

}  // namespace cncsub
