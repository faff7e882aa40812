// The modes as they are, to be restored later.
#pragma once

#include <array>

#include "cncsub/code/block_codes.hpp"
#include "cncsub/motion/state/state.hpp"

namespace cncsub {

/// The modes that M70 and M73 keep. [LC m-code, M70]
struct SavedModes {
  std::array<GCode, kGroups> codes{};
  double feed = 0;  // in the unit of the program
  double speed = 0;
  bool shifted = false, extended = false;  // the shift of G92, and a tool length, are in force
  bool turns = false;
  bool codes_alone = false;  // the code of motion comes back as well, but neither F nor S
  FrameValue frame;          // of the program: comes back with the codes alone
};

SavedModes modes_of(MotionView m);
/// The block by which a control returns to saved modes: its codes, and F and S where they differ.
struct ReturnToModes {
  CodeList codes;
  bool has_feed = false, has_speed = false;
};
/// Return the block for the unit of lengths, in which F is written, and the one for the other
/// modes. A control writes both blocks itself and executes them: what it refuses in one it refuses
/// here too. [rs274 2.9]
ReturnToModes units_to(MotionView m, const SavedModes& saved);
ReturnToModes modes_to(MotionView m, const SavedModes& saved);

}  // namespace cncsub
