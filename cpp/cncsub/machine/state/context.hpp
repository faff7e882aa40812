// A run under way: what it runs, its state, its record, and what is known of the running block
// only. The functions of this folder work on it.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/machine/state/observer.hpp"
#include "cncsub/machine/state/options.hpp"
#include "cncsub/machine/state/state.hpp"
#include "cncsub/motion/motion.hpp"
#include "cncsub/system/compiler.hpp"
#include "cncsub/trace/trace.hpp"

namespace cncsub {

/// The values and messages before the assignments of a block, for a rollback. A block that does
/// something else besides may alarm after them.
struct BeforeTogether {
  struct Variable {
    Reference at;
    double value = 0;
    std::uint8_t programmed = 0;  // of a local
  };
  struct System {
    std::vector<double> locals;  // which images of levels write
    std::map<std::int64_t, double> variables;
    Motion motion;
  };
  std::vector<Variable> variables;
  std::optional<System> system;         // from the first assignment to a system variable on
  std::optional<std::size_t> messages;  // how many there were

  void forget() { *this = {}; }
};

/// The state of the running block. Between two blocks nothing of it counts.
struct RunningBlock {
  Address next = 0;               // where the run goes on after it; or one of the two below
  bool words_done = false;        // its words are executed: what alarms now leaves a step
  Motion::Outcome outcome;        // of its words
  bool is_step = false;           // it waited for a modal macro, and was recorded before that:
  std::int64_t step = 0;          // as this step
  bool waiting_is_due = false;    // the frame that the last of State::waiting waited for is left
  bool failed = false;            // its condition did not hold (O words)
  bool follows_moves = false;     // it has no words to be the arguments of G66.1: the macro follows
                                  // its move, as with G66
  std::vector<Drop> left_out;     // words of it that the run does not know how to obey
  std::vector<double> arguments;  // the locals of the level that it is about to open,
  std::vector<std::uint8_t> programmed;  // and how they were programmed
  const ParallelAssign* parallel_assign =
      nullptr;             // what it does besides its words, and has not done yet
  std::int64_t took = -1;  // `before` holds the reads of when that many blocks were executed
  ExternalReads before;
  BeforeTogether before_together;

  // Instead of the address of a block: an M code starts the main program over, or M#1 ends it.
  static constexpr Address kRestart = kNowhere, kEnd = kNowhere - 1;
};

/// The means to stop a run, and when it next looks for a reason to stop.
struct Watch {
  using Clock = std::chrono::steady_clock;

  const std::function<bool()>* interrupted = nullptr;  // while it runs: whether to stop
  Stop broken_off = Stop::Running;                     // why the running block was stopped
  Clock::time_point begun;                             // while it runs: when it began
  double spent = 0, asked = 0;  // seconds at work before, and until it asked `interrupted`
  std::uint64_t in_block = 0;   // bytes that the running block takes besides what it records
  std::int64_t look_at = 0;     // when that many blocks are executed the run looks for a reason,
  std::int64_t look_moves = 0;  // or when it has made so many moves since the last time
  std::int64_t moves = 0;       // which are these
  // While it runs: by address, which blocks it may pause before. Null: none, or all.
  const std::uint8_t* marked = nullptr;
  bool sees_moves = false;  // breakpoints look at moves that are not recorded
};

/// The watched variables, laid out so that a step pays for what it changes, however much is
/// watched. The numbers are places in Trace::watched.
struct Watched {
  /// Locals of the present level, or commons, that lie side by side.
  struct Range {
    bool local;
    std::size_t first, count;
    std::size_t seen;  // into `seen`
  };

  std::vector<VariablePlace> places;  // of Trace::watched, one by one
  std::vector<Range> ranges;
  std::vector<double> seen;                   // what stood in the ranges after the step before
  std::vector<std::uint32_t> seen_at;         // of each place: into `seen`
  std::vector<std::int32_t> locals, commons;  // by their index: what is watched of them, or -1
  std::vector<std::uint32_t> system;          // neither local nor common,
  std::vector<std::uint32_t> moving;          // those that follow moves, time or locals

  bool empty() const { return places.empty(); }
};

struct Run {
  /// Make a run that is in no program yet.
  Run(std::shared_ptr<const Code> of, Options how);

  std::shared_ptr<const Code> code;
  Options options;
  double largest_word = 0;  // no computed word of a block reaches it
  // The codes of the block whose words are being decoded: its unit counts for its own words.
  const BlockCodes* codes_decoded = nullptr;
  std::uint32_t unsigned_words = 0;  // the addresses whose computed values may not be negative
  std::uint32_t computed_whole = 0;  // the addresses whose computed values are rounded
  State state;
  std::shared_ptr<const CodeMeanings> meanings;  // the meanings of codes on this kind of machine
  BlockCodes codes;                              // the codes of a block that computes them
  Motion motion;
  Trace trace;
  RunningBlock block;
  Watch watch;
  Watched watched;
  Observer* observer = nullptr;  // null where nobody listens

  const Control& control() const { return *code->control; }
  /// Return whether the control refuses this.
  bool refuses(Cause cause) const { return control().common.refuses.value.has(cause); }
  const OpenFrame& frame() const { return state.frames.back(); }
  OpenFrame& frame() { return state.frames.back(); }
  /// Return the program that is running.
  const Program& program() const {
    return code->programs[static_cast<std::size_t>(frame().program)];
  }
  /// Return whether what runs was typed in MDI, or was called from there.
  bool in_mdi() const {
    return state.frames.front().typed ||
           state.frames.size() - 1 > static_cast<std::size_t>(state.open_calls());
  }
  /// Go on with a library that has more at the ends of its tables.
  void extend(std::shared_ptr<const Code> with);
  /// Return where the moves go; null when they are not recorded.
  Moves* moves() {
    return trace.depth == Trace::Depth::Moves || watch.sees_moves ? &trace.moves : nullptr;
  }
  /// Return the step of the block, for the rows of its moves.
  std::uint32_t step() const { return static_cast<std::uint32_t>(state.executed); }
  /// Return the place of a local variable of a level.
  std::size_t local_at(int level, std::int32_t index) const {
    return static_cast<std::size_t>(level) * static_cast<std::size_t>(code->locals) +
           static_cast<std::size_t>(index);
  }
  /// Return the place of an element of an array of the present level.
  std::size_t element_at(std::size_t index) const {
    return static_cast<std::size_t>(state.level) * static_cast<std::size_t>(code->elements) + index;
  }
};

/// Record the running block. `failed`: it has a condition, and that did not hold.
CNCSUB_ALWAYS_INLINE inline void record_step(Run& run, bool failed = false) {
  if (run.trace.depth >= Trace::Depth::Blocks)
    run.trace.steps.push(
        {run.state.pc & 0x7fffffffU, failed ? 1U : 0U, run.frame().call, run.frame().repeat});
  ++run.state.executed;
}

/// Record a block that may be a step already.
inline void record_block(Run& run, bool failed = false) {
  if (!run.block.is_step) record_step(run, failed);
}

/// Keep the external reads as they are before the clock, a random number or a skip signal is read.
inline void log_read(Run& run) {
  if (run.block.took == run.state.executed) return;
  run.block.took = run.state.executed;
  run.block.before = run.state.external_reads;
}

}  // namespace cncsub
