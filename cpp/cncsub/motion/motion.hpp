// Where the tool goes: a block's words change the modal state, move the axes and leave rows in the
// table of moves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/control/control.hpp"
#include "cncsub/motion/query.hpp"
#include "cncsub/motion/state/machine_inputs.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/setup.hpp"
#include "cncsub/motion/state/state.hpp"
#include "cncsub/trace/moves.hpp"

namespace cncsub {

/// The coordinates that a value counts in.
enum class Coordinates : std::uint8_t { Work, Machine };

class Motion {
 public:
  using Outcome = MotionOutcome;

  /// `general_only`: without the fast path of `linear` and `arc`.
  Motion(std::shared_ptr<const Control> control, const Setup& setup,
         std::shared_ptr<const CodeMeanings> meanings, bool general_only = false);

  /// Return the profile that a block names, G70 to G73, which is handed in with the block.
  std::optional<ProfileNumbers> wanted_profile(const NcWords& words) const {
    return words.has('P') && words.has('Q') ? named_profile(*facts_, words) : std::nullopt;
  }

  /// Execute the motion words of a block. When it returns a fault nothing has changed.
  std::optional<Fault> execute(const NcWords& words, std::uint32_t step, Moves* moves,
                               Outcome& outcome, MachineInputs& inputs);

  /// Execute a block with nothing but G00 or G01 (g 0, 1, or -1 for none), X, Y, Z and F, its
  /// values in the order of the alphabet. Return false when the state needs the general path; then
  /// nothing has changed.
  bool linear(std::uint32_t mask, const Cell* values, int g, std::uint32_t step, Moves* moves,
              bool& moved);

  /// Execute G02 or G03 (g 2, 3 or -1) with words of a centre likewise. It moves where it is true.
  bool arc(std::uint32_t mask, const Cell* values, int g, std::uint32_t step, Moves* moves);

  /// Emit the moves held back for compensation or corners: at M00, M02, M30 and the end of the run.
  /// When it returns a fault nothing has changed.
  std::optional<Fault> finish(Moves* moves);
  /// Set whether the spindle turns.
  void set_turning(bool turns) { now().turns = turns; }
  /// Put a frame of the program in force, as the return to saved modes does.
  void set_frame(const FrameValue& frame);
  /// Note that a program writes over what the control has set, see MotionState::set_anew.
  void write_over(std::size_t kind, double value) {
    now().set_anew[kind] = false;
    if (kind == 2) now().shifted = value != 0;
  }
  /// Do what M02, M30 and the reset key do.
  void reset();

  /// Return what the queries of query.hpp look at. It holds until the next block.
  MotionView view() const { return {*facts_, state()}; }
  const MotionState& state() const { return state_.front(); }
  double time() const { return state().time; }

  /// Let an axis, as kAxisNames count them, stand at a work coordinate, or a machine coordinate, as
  /// if it was brought there by hand: no row is written, and the next one of the table begins
  /// there. Return why it cannot stand there; then nothing has changed.
  std::optional<std::string> stand_at(int axis, double value, Coordinates of, Moves* moves);

  // What variables write. `system` and `axis` count as in query.hpp.
  void set_work_offset(int system, int axis, double value);
  void set_offset(VariableKind kind, int number, double value);
  /// Write a frame of a work system, or one that is in force; return why not where it is refused.
  std::optional<Fault> set_stored_frame(int number, const FrameValue& frame);
  std::optional<Fault> set_frame_in_force(FrameInForce which, const FrameValue& frame);
  void name_tool(int number, std::string_view name) { now().tables.name_tool(number, name); }

  /// Let the rows go to another table from now on.
  void forget_table() { now().row_moves = nullptr; }

 private:
  MotionState& now() { return state_.front(); }
  /// Begin the plan of a block: the state after it, which begins as the one before it.
  MotionState& begin_plan();
  /// Commit the plan, or drop it where it has a fault. The table of moves had so many `rows`.
  std::optional<Fault> commit(std::optional<Fault> wrong, Moves* moves, std::size_t rows);
  void write(Axes& values, int axis, double value);

  std::shared_ptr<const MotionFacts> facts_;
  // The state and the plan of the running block, one each: a commit swaps the two vectors, and that
  // is two pointers.
  std::vector<MotionState> state_, plan_;
};

/// Return how many pieces of path wait for the moves after them, and the memory that they take.
std::int64_t held_pieces(const MotionState& state);
std::size_t held_bytes(const MotionState& state);
/// Return the steps of moves that wait for those after them.
std::vector<std::uint32_t> held_steps(const MotionState& state);

}  // namespace cncsub

#include "cncsub/motion/linear.hpp"  // Motion::linear, which the run calls for most blocks
