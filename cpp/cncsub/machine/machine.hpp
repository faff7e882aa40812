// The interpreter: one run of one program, whole or block by block.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/machine/run/breakpoints.hpp"
#include "cncsub/machine/run/endless.hpp"
#include "cncsub/machine/run/history.hpp"
#include "cncsub/machine/run/settings.hpp"
#include "cncsub/machine/state/context.hpp"
#include "cncsub/machine/state/options.hpp"
#include "cncsub/machine/state/state.hpp"
#include "cncsub/machine/values/named_variables.hpp"
#include "cncsub/machine/values/texts.hpp"
#include "cncsub/motion/motion.hpp"
#include "cncsub/trace/trace.hpp"

namespace cncsub {

/// A run of a program. A copy goes on from where this machine stands, and each of the two by
/// itself.
class Machine {
 public:
  /// Stand at the first block of the program `main`, or at the block to start from. Variables that
  /// cannot be written are left as they are (see `write`).
  Machine(std::shared_ptr<const Code> code, std::int32_t main, Options options);

  /// Execute one block. Return false where the run has stopped before one was executed, or where
  /// `interrupted` stopped the block, which then did nothing. A block of very many moves asks it
  /// now and then.
  bool step(const std::function<bool()>& interrupted = {});
  /// Run until the run stops, or until `pause` says so (asked before each block when it is given).
  void run(const std::function<bool()>& interrupted,
           const std::function<bool(const Machine&)>& pause = {});
  /// Run on for about this many blocks: fewer where they made very many moves.
  void run(const std::function<bool()>& interrupted, std::int64_t blocks);
  /// Run until the run stops, or one of the breakpoints is reached. Return them as they are then.
  Breakpoints run(const std::function<bool()>& interrupted, std::vector<Breakpoint> list,
                  const ExpressionList& expressions);

  /// Remember from now on where the run came from, to go back. It costs a snapshot now and then.
  void remember();
  /// Go back to when so many blocks were executed, 0 to `blocks`; what was set from outside after
  /// that is forgotten, what was set before is set again, and blocks that were typed in at the step
  /// are not there. Return false where `interrupted` stopped it: it stands where it stood then.
  bool back(std::int64_t step, const std::function<bool()>& interrupted);
  /// Return the last step before the present one at which the breakpoints show a block; -1: none;
  /// nothing: `interrupted` stopped the search.
  std::optional<std::int64_t> last_met(const std::vector<Breakpoint>& list,
                                       const ExpressionList& expressions,
                                       const std::function<bool()>& interrupted) const;
  /// Return what it remembers; null where it remembers nothing.
  const History* history() const { return history_ ? &*history_ : nullptr; }
  /// Return the step of the block that opened the innermost call; -1 where none is open, or calls
  /// are not recorded.
  std::int64_t step_of_call() const;

  /// Return the block about to be executed, past those that the block-skip switches skip; kNowhere
  /// where the program has ended.
  Address next_block() const;
  /// Evaluate an expression in the present state, which stays as it is. `text`: the value of one
  /// that is no number, as it is written.
  std::optional<Alarm> evaluate(const ExpressionList& list, const ExpressionList::One& one,
                                double& value, std::string& text) const;

  /// Tell `observer` what each block does from now on, until there is none (null). It is to be
  /// emptied before each block.
  void tell(Observer* observer) { run_.observer = observer; }
  /// Stop the run as Ctrl-C does.
  void interrupt();
  /// Do what the reset key, M02 and M30 do: calls, modal calls and loops are gone, the variables
  /// that the control clears are vacant, and the main program is at its head again. What was
  /// recorded stays.
  void reset();

  const Code& code() const { return *run_.code; }
  std::shared_ptr<const Code> shared_code() const { return run_.code; }
  const State& state() const { return run_.state; }
  const Motion& motion() const { return run_.motion; }
  Stop stop() const { return run_.state.stop; }
  const std::optional<Alarm>& alarm() const { return run_.state.alarm; }
  /// Return how many blocks were executed.
  std::int64_t blocks() const { return run_.state.executed; }
  /// Return how many calls are open; `frames`: what they are, the last one first.
  int depth() const { return static_cast<int>(run_.state.frames.size()) - 1; }
  std::vector<Frame> frames() const;

  /// Return why the program had not ended when the run stopped. The search asks `gives_up` now and
  /// then.
  Endless endless(const std::function<bool()>& gives_up) const {
    return why_endless(run_, kFurtherBlocks, gives_up);
  }

  /// Return what was recorded so far.
  const Trace& trace() const { return run_.trace; }
  /// Give away what was recorded; the run goes on with empty tables. Calls that are still open come
  /// with a later part.
  Trace take();
  /// Return the bytes of what was recorded.
  std::uint64_t memory() const;
  /// Return the axes that the programs in memory name, X Y Z first, before any of them moves.
  std::string axes() const;

  /// Return every variable that is not vacant or was ever written: commons and the locals of a
  /// level.
  std::map<std::int32_t, double> variables(int level) const;
  /// Return the variables that have a name, those of a level and those of all programs.
  std::vector<NamedValues> named(int level) const { return named_variables(run_, level); }
  /// Return the text that a value of a variable stands for.
  const std::string& text(double value) const { return text_of(run_, value); }
  /// Return the frame of the control that a variable is, as programs write it; nothing where it is
  /// none, or no functions make it.
  std::optional<std::string> frame_text(std::int64_t number) const;
  /// A frame of the control that programs may write, and how they write what it is now; nothing
  /// where no functions make it.
  struct ControlFrame {
    std::string name;
    std::optional<FrameInForce> role;  // nothing: a work offset holds it
    std::optional<std::string> text;
  };
  std::vector<ControlFrame> control_frames() const;
  /// Read or write a variable. A fault says why it has no value, or takes none. Locals are those of
  /// an open level, 0 to State::level.
  std::optional<Fault> read(std::int64_t number, int level, double& value) const;
  std::optional<Fault> write(std::int64_t number, int level, double value);
  /// Set a signal or a variable as the machine and other programs do.
  void set_from_outside(std::int32_t number, double value);
  /// Set a mode, or a variable that a program defines: see settings.hpp. Return why it cannot be.
  std::optional<std::string> set_mode(const std::shared_ptr<const Code>& typed,
                                      const std::string& mode);
  std::optional<std::string> set_named(int level, const std::string& name,
                                       const std::vector<NamedValue>& values);
  /// Let an axis stand elsewhere: see Motion::stand_at. Return why it cannot.
  std::optional<std::string> set_position(int axis, double value, Coordinates of);
  /// Make another block of the program that runs the next one: see next_block.hpp. Return why it
  /// cannot be.
  std::optional<std::string> set_next_block(Address to);
  /// Go on with the blocks that were typed in MDI, the last program of a library that is this one
  /// with more at its end (see `compile_mdi`); after them the run goes on where it stands. Return
  /// why it cannot.
  std::optional<std::string> type_in(std::shared_ptr<const Code> with);
  /// Set the block-skip switches, a bit each, and whether M01 stops.
  void set_switches(std::uint16_t skips, bool optional_stop);
  const Options& options() const { return run_.options; }

 private:
  /// Change the run from outside, and remember what does the same again.
  void change(const std::function<void(Run&)>& now, const std::function<void(Run&)>& again);

  Run run_;
  std::optional<History> history_;
};

}  // namespace cncsub
