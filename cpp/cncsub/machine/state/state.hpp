// The state of a run between two blocks: plain values, so that a copy is a snapshot.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/motion/saved_modes.hpp"
#include "cncsub/motion/state/signals.hpp"

namespace cncsub {

enum class Stop : std::uint8_t { Running, End, Alarm, Cycles, Limit, Waiting, Interrupted };
std::string_view to_string(Stop stop);

/// A variable: the table of the state that holds its value, and the place there. A local holds one
/// as a value. It outlives the level of what it stands for only in a modal call.
struct Reference {
  enum class In : std::uint8_t { Locals, Commons, Elements, Copies } in = In::Commons;
  std::size_t index = 0;

  static constexpr double kTable = 4294967296.0;  // the places of a table

  double packed() const { return static_cast<double>(in) * kTable + static_cast<double>(index); }
  static Reference of(double packed) {
    const auto table = static_cast<std::uint8_t>(packed / kTable);
    return {static_cast<In>(table), static_cast<std::size_t>(packed - table * kTable)};
  }
  /// Return the variable so many places after it, as of an array.
  Reference behind(std::size_t places) const { return {in, index + places}; }
};

/// A program that was entered and not left yet: the main program, or what a call opened.
struct OpenFrame {
  std::int32_t program = 0;
  std::int32_t call = -1;                // its number in the trace, -1 for the main program
  std::int32_t repeat = 1, repeats = 1;  // the pass that runs, of how many
  Address return_to = 0;                 // in the caller
  Address called_at = 0;                 // the caller's block, for the list of open calls
  Address restart = 0;                   // where each pass begins
  CallKind kind = CallKind::Subprogram;
  bool macro = false;             // it counts as a macro, not as a subprogram
  bool own_locals = false;        // it opened a level of local variables
  bool external = false;          // it, or a frame below it, is on the external device
  char code_letter = 0;           // 'G' or 'M': a code called it, or a frame below it
  std::int32_t modal = -1;        // the modal call that it is the macro of
  std::int32_t modal_limit = 0;   // only modal calls below this one follow its moves
  std::uint32_t loops = 0;        // how many of the open loops belong to frames below
  Address part_end = kNowhere;    // of RepeatPart and of a text typed in the middle of a run: the
                                  // block before which each pass ends
  std::uint32_t label = 0;        // the label it was called by, 0 = none
  std::int32_t passes_left = -1;  // of the M98 L that it is at
  bool shares_locals = false;     // the numbered locals of its level are the caller's
  std::size_t copies = 0;         // how many elements of copied arrays belong to frames below
  bool interrupts = false;        // after it the caller's block does what it waits with
  bool typed = false;             // it was typed in MDI

  bool operator==(const OpenFrame&) const = default;
};

/// A modal macro call in force: G66, G66.1 and codes that call as they do.
struct ModalCall {
  std::uint32_t record = 0;    // into Code::calls
  Target target;               // looked up at the first call
  std::vector<double> locals;  // its arguments, or what the macro left in them
  std::int32_t program = 0;    // where it was declared
  bool every_block = false;    // G66.1: it follows blocks, not moves
};

/// The call, return or jump that a block has left to do when a modal macro follows its move.
struct WaitingBlock {
  Op op = Op::Call;                 // Op::Call for every kind of call, Op::Return or Op::Jump
  std::uint32_t aux = 0;            // the aux of the block
  Address at = 0;                   // the address of the block
  std::int64_t step = 0;            // the step that it is already
  Target target;                    // of a call
  double p = kVacant, l = kVacant;  // of a return or a jump
  std::vector<double> arguments;    // of a call
  std::vector<std::uint8_t> programmed;
};

/// The reads of blocks from the world outside. Every read moves it on; a block that alarms is
/// rolled back.
struct ExternalReads {
  double clock_ms = 0;                            // #3001, besides the time of the moves
  std::array<std::size_t, kSkipSignals> skips{};  // how many of Inputs::skips, list by list
  std::minstd_rand random{1};
  bool time = false;  // a program asked for the time of the moves since this was cleared
  // The last variable that it read and the world outside sets, or kSkipSignal; 0: none since.
  std::int64_t asked = 0;
  static constexpr std::int64_t kSkipSignal = -1;

  bool operator==(const ExternalReads&) const = default;
};

/// The labels met: a subprogram by its own label, all else by the subprogram it was met in.
struct Labels {
  struct Met {
    Address address = kNowhere;
    OWordKind kind = OWordKind::Sub;
    std::int32_t repeats = -1;  // passes left, -1: to be counted anew

    bool operator==(const Met&) const = default;
  };
  std::unordered_map<std::uint64_t, Met> met;
  bool defining = false;   // the head of a subprogram was met: it is skipped
  bool searching = false;  // a call goes to a head that nobody has met
  bool skipping = false;   // the block was reached by skipping others
  bool entered = false;    // a branch of the innermost IF was entered
  bool back = false;       // the main program was returned to, and defined nothing since
  // Set by a break and a continue, until the end of a loop asks. [rs274 2.9: a break of a WHILE is
  // still there when the next DO ends]
  bool breaks = false, continues = false;

  bool operator==(const Labels&) const = default;
};

/// A WHILE, DO or FOR that is open.
struct OpenLoop {
  Address start = 0;
  double last = 0;  // of a FOR: the last value

  bool operator==(const OpenLoop&) const = default;
};

struct State {
  // The place of the run.
  Address pc = 0;                   // the block to be executed next
  std::vector<OpenFrame> frames;    // the main program first
  int subprograms = 0, macros = 0;  // how many of the open calls are subprograms, and macros
  /// Return how many calls are open, without texts that were typed in MDI.
  int open_calls() const { return subprograms + macros; }
  Labels labels;
  std::vector<OpenLoop> loops;        // of all frames
  std::vector<ModalCall> modals;      // in the order they were declared
  std::vector<WaitingBlock> waiting;  // one for each frame that `interrupts`
  struct ModalStackEntry {
    std::size_t depth = 0;    // how many frames were open
    bool valid = false;       // nobody said to forget them
    bool for_return = false;  // they come back when the program returns
    SavedModes modes;
  };
  std::vector<ModalStackEntry> modal_stack;  // modes, the innermost program's last
  Address moved_at = 0;  // the block whose move a modal call follows, or that called last

  // Variables.
  int level = 0;                         // the present level of locals
  std::vector<double> locals;            // level after level, Code::locals each
  std::vector<std::uint8_t> programmed;  // of each local how its word was programmed, for AR[]; or
                                         // nothing where the control does not ask
  std::vector<double> commons;           // by their place, see Code::place
  std::vector<double> elements;          // of arrays: level after level, Code::elements each
  std::vector<double> copies;            // of arrays that calls hand over by value, call after call
  Texts texts;                           // those that blocks made; numbered after those of the code
  Texts frame_values;                    // the bytes of frames that blocks made; 1 is the first
  std::map<std::int64_t, double> system;  // what was written to system variables
  // Written variables that the control sets too, each with its place in MotionState::set_anew.
  std::map<std::int64_t, std::size_t> written_over;
  std::map<std::int32_t, double> signals;     // of the machine, as they are now
  std::map<std::string, std::int64_t> names;  // SETVN: a name and its variable

  std::vector<double>& table(Reference::In in) {
    switch (in) {
      case Reference::In::Locals:
        return locals;
      case Reference::In::Commons:
        return commons;
      case Reference::In::Elements:
        return elements;
      case Reference::In::Copies:
        break;
    }
    return copies;
  }
  const std::vector<double>& table(Reference::In in) const {
    return const_cast<State*>(this)->table(in);
  }
  /// Return where a variable lies; null where its level is left.
  double* cell(const Reference& of) {
    std::vector<double>& all = table(of.in);
    return of.index < all.size() ? all.data() + of.index : nullptr;
  }
  const double* cell(const Reference& of) const { return const_cast<State*>(this)->cell(of); }

  // The counts of what was done so far.
  std::int64_t executed = 0;              // blocks
  std::int64_t cycles = 0;                // of the main program
  std::int64_t last_m = -1, last_n = -1;  // the last M code and sequence number; -1: none yet
  std::int64_t skipped = 0;               // blocks skipped by block skip in a row
  std::int64_t skipped_behind = -1;       // they were skipped when that many blocks were executed
  ExternalReads external_reads;
  std::size_t next_write = 0;   // of Inputs::writes
  std::size_t next_answer = 0;  // of Inputs::operator_starts

  // A jump back that is reached twice while nothing changed can only wait for the world outside.
  std::uint64_t changes = 0;                // counts what changes anything
  std::uint64_t changes_at_jump = ~0ULL;    // as it was at the last jump back
  Address jumped_from = kNowhere;           // that jump
  std::uint32_t last_condition = kNowhere;  // the expression that was asked since; or none

  // The reason why the run has stopped.
  Stop stop = Stop::Running;
  std::optional<Alarm> alarm;
  std::string waiting_for;  // "#1000", or "cycle start after M00"
};

}  // namespace cncsub
