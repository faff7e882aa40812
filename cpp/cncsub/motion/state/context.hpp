// A block that is carried out, and what each part of the motion may touch.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cncsub/motion/state/facts.hpp"
#include "cncsub/motion/state/machine_inputs.hpp"
#include "cncsub/motion/state/state.hpp"

namespace cncsub {

/// The fault of a block, or nothing.
using Result = std::optional<Fault>;

/// The words of a block by their meaning, and how far it has come.
struct BlockWords {
  const NcWords& words;
  std::uint32_t step;
  bool was_cycle = false;     // a canned cycle was active before this block
  bool cycle = false;         // a cycle makes its moves
  bool submitted = false;     // a piece went out
  bool consumed = false;      // the axis words belong to G68, G51 and the like
  double axis_extension = 0;  // G45 to G48: how much longer the move gets on each axis

  bool has(Group group) const { return words.codes->has(group); }
  const GCode& code(Group group) const { return words.codes->of[at(group)]; }
  Meaning meaning(Group group) const { return words.codes->meaning(group); }
};

/// The sink of moves: they change the planned state, and leave rows in a table.
struct MoveSink {
  const MotionFacts& facts;
  MotionState& state;  // a plan: the state after the block, if the block has no fault
  Moves* table = nullptr;
  std::vector<Piece>* captured = nullptr;  // keeps the pieces of a profile that is tried out

  operator MotionView() const { return {facts, state}; }  // NOLINT(misc-explicit-constructor)
};

/// Everything that the words of a block may touch.
struct MotionContext : MoveSink {
  MotionOutcome& outcome;
  MachineInputs& inputs;
};

// The faults of a block: of the code by which it acts, of a word, of a G code (ten times its
// number).
Fault fault(Cause cause, const BlockWords& block, std::string detail = {});
Fault fault_at(char address, Cause cause, const BlockWords& block, std::string detail = {});
Fault fault_at(const WordName& word, Cause cause, const BlockWords& block, std::string detail = {});
Fault fault_at(const WordName& word, Cause cause, Address block, std::string detail = {});
Fault fault_of(int code, Cause cause, const BlockWords& block);

}  // namespace cncsub
