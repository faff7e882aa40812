// What system variables and reports read of the motion. `axis` counts from 0 in the control's
// order: X Y Z A B C U V W; lathe X Z Y C A B.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cncsub/motion/state.hpp"
#include "cncsub/motion/workpiece.hpp"

namespace cncsub {

inline bool in_cycle(const MotionState& state) { return state.cycle.cycle != Meaning::CycleOff; }
inline bool compensating(const MotionState& state) {
  const Meaning radius = state.modal[at(Group::Radius)].meaning;
  return radius == Meaning::RadiusLeft || radius == Meaning::RadiusRight;
}
/// -1 to the left, 1 to the right, 0 where nothing is compensated.
inline int side_of(const MotionState& state) {
  const Meaning radius = state.modal[at(Group::Radius)].meaning;
  return radius == Meaning::RadiusLeft ? -1 : radius == Meaning::RadiusRight ? 1 : 0;
}
inline bool g20(const MotionState& state) {
  return state.modal[at(Group::Units)].meaning == Meaning::Inch;
}

double modal_code(MotionView m, int group);
double modal_word(MotionView m, char address);
double block_end(MotionView m, int axis);
double machine_position(MotionView m, int axis);
double work_position(MotionView m, int axis);
double skip_position(MotionView m, int axis);
/// The length of the tool in the spindle.
double tool_length(MotionView m, int axis);
double active_length(MotionView m, int axis);
double work_offset(MotionView m, int system, int axis);
/// What the shift of G92 becomes when it is taken back in; of axis -1 whether it counts, 1 or 0.
double kept_shift(MotionView m, int axis);
double reference_point(MotionView m, int number, int axis);
double extra_offset(MotionView m, int p, int axis);
double offset(MotionView m, VariableKind kind, int number);

std::vector<std::pair<std::string, double>> position(MotionView m);
std::vector<std::pair<std::string, std::string>> modal(MotionView m);

/// A number without a point at this address, as an argument of a macro.
double scaled(MotionView m, char address, double value);
/// The least input increment of an address, 0 where it has none.
double increment(MotionView m, char address);
/// A computed value at an address as the control takes it: to the least increment.
double rounded(MotionView m, char address, double value);
/// The axes that addresses (a block's mask) can move, as the columns of the moves are called.
std::string axes_of(MotionView m, std::uint32_t mask);
/// A workpiece by machine coordinates and true lengths, its zero point where it is now.
Workpiece placed(MotionView m, Workpiece workpiece);

/// The axis of this number, -1 where the control has none.
int axis_number(MotionView m, int axis);

}  // namespace cncsub
