// Values of the motion that an expression reads by their kind, and not by the number of a variable.
#pragma once

#include <cstdint>

namespace cncsub {

enum class MotionValue : std::uint8_t {
  ModalCode,  // the G code of a group, as #4001 and up number the groups
  ModalWord,  // F or S in force
  BlockEnd,   // the end of the block before on an axis, counted from 0
};

constexpr int kMotionValues = 1000;  // of a kind

/// Return the operand of Ins::MotionValue. `index`: the group, the letter or the axis.
constexpr double motion_value_operand(MotionValue kind, int index) {
  return static_cast<int>(kind) * kMotionValues + index;
}

}  // namespace cncsub
