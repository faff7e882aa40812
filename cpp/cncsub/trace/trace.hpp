// The record of a run: a row per executed block, per call and per move, per change of a watched
// variable, and what was sent to the machine. A run that is streamed leaves it in parts.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/trace/column.hpp"
#include "cncsub/trace/moves.hpp"

namespace cncsub {

struct CallRow {
  std::int32_t parent = -1;
  std::int32_t program = 0;
  std::int32_t start_n = -1;
  std::int32_t repeats = 1;
  std::int32_t level = 0;
  std::int32_t depth = 0;
  std::uint32_t record = 0;  // into Code::calls
  CallKind kind = CallKind::Subprogram;
  std::int64_t first_step = 0, last_step = -1, caller_step = 0;
  std::uint32_t first_argument = 0, arguments = 0;
};

struct Trace {
  struct Argument {
    std::int32_t variable;
    double value;
  };
  enum class Depth : std::uint8_t { None, Calls, Blocks, Moves };
  struct Step {
    // Blocks are 40 bytes each: no memory holds so many that their addresses need the last bit.
    std::uint32_t address : 31;
    std::uint32_t failed : 1;  // the condition of the block did not hold
    std::int32_t call;
    std::int32_t repeat;
  };

  struct Place {
    std::int64_t step;
    Address address;
  };
  /// A code that was sent to the machine.
  struct Sent {
    std::int64_t step;
    double value;
    Address address;
    char kind;  // 'M', 'T', 'S'

    bool operator==(const Sent&) const = default;
  };
  /// A word that the control read and did not obey.
  struct Dropped {
    std::int64_t step;
    Address address;
    std::string text;
  };

  struct HeldStep {
    std::int64_t number;
    Step step;
  };

  /// A watched variable: its value when this part began, and its value now.
  struct Watched {
    std::int32_t number;
    double before, now;
  };
  /// A new value of a watched variable.
  struct Change {
    std::int64_t step;  // -1: none, it changed from outside between two steps
    double value;
    std::int32_t variable;
    Address address;
  };

  /// A comparison of a condition, or a condition that compares nothing: a value alone.
  struct Compared {
    std::int64_t step;
    double left, right;  // of a value alone: `right` is vacant
    Address address;
    Ins op;  // End: a value alone
    bool holds;
  };

  Depth depth = Depth::Moves;
  Column<Step> steps;
  Column<CallRow> calls;
  Column<Argument> arguments;
  Moves moves;
  Column<Sent> codes;
  Column<std::string> messages;
  Column<Place> missed_skips;  // the blocks of G31 that met nothing
  Column<Dropped> dropped;
  std::vector<Watched> watched;
  Column<Change> changes;
  Column<Compared> compared;
  std::size_t text = 0;  // characters of the messages

  // Steps, calls and moves are numbered through the run; a part begins anywhere.
  std::int64_t first_step = 0, first_move = 0;
  std::int32_t first_call = 0;          // the number of the first call that was made in this part
  std::vector<HeldStep> held;           // steps of earlier parts, whose moves come in this one
  std::vector<std::int32_t> carried;    // calls of earlier parts that were open when this one
                                        // began: the first rows of `calls`
  std::vector<std::size_t> unfinished;  // rows of `calls` that belong to a later part

  std::int32_t call_number(std::size_t row) const;
  std::size_t call_row(std::int32_t number) const;
  /// Return the depth of a call, or 0 for -1: the main program.
  std::int32_t depth_of(std::int32_t call) const {
    return call < 0 ? 0 : calls[call_row(call)].depth;
  }
  /// Return how many calls ended in this part; `index` counts them in order.
  std::size_t ended_calls() const { return calls.size() - unfinished.size(); }
  std::size_t ended_call(std::size_t index) const;
  std::int64_t step_of_move(std::uint32_t step) const;
  /// Return the step of a number: of this part, or an earlier one whose moves were held back; null
  /// for any other one.
  const Step* find_step(std::int64_t number) const;
  std::size_t bytes() const;

  void say(std::string message);
  /// Forget the messages from `count` on.
  void keep_messages(std::size_t count);
  /// How much was recorded when a run stood somewhere, to go back to.
  struct Mark {
    std::size_t steps = 0, calls = 0, arguments = 0, codes = 0, messages = 0, missed_skips = 0,
                dropped = 0, changes = 0, compared = 0;
    Moves::Mark moves;
    std::vector<Watched> watched;
  };
  Mark mark() const;
  /// Forget what was recorded after a mark. Calls that were open there count as open again when
  /// `reopen` names them.
  void rewind(const Mark& mark);
  void reopen(std::int32_t call) { calls.at(call_row(call)).last_step = -1; }
  /// The calls, steps and moves that go on after a part that is taken away.
  struct Open {
    std::vector<std::int32_t> calls;
    std::vector<std::uint32_t> held;  // the steps of moves that are held back, as moves hold them
    std::int64_t next_step = 0;
    bool last = false;  // nothing comes after it
  };
  /// Give away what was recorded and go on empty, with what is open.
  Trace take(const Open& open);
};

inline std::int32_t Trace::call_number(std::size_t row) const {
  return row < carried.size() ? carried[row]
                              : first_call + static_cast<std::int32_t>(row - carried.size());
}

}  // namespace cncsub
