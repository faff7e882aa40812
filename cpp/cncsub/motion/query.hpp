// The values of the motion that system variables and reports read. `axis` counts from 0 in the
// control's order: X Y Z A B C U V W; lathe X Z Y C A B.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cncsub/motion/state/state.hpp"
#include "cncsub/motion/state/workpiece.hpp"

namespace cncsub {

double modal_code(MotionView m, int group);
double modal_word(MotionView m, char address);
double block_end(MotionView m, int axis);
double machine_position(MotionView m, int axis);
double work_position(MotionView m, int axis);
double skip_position(MotionView m, int axis);
/// Return where the last skip ended in the frame of its block, or in machine coordinates.
double measured_position(MotionView m, int axis);
double measured_machine(MotionView m, int axis);
/// Return the length of the tool in the spindle.
double tool_length(MotionView m, int axis);
double active_length(MotionView m, int axis);
/// Return a datum of an edge of a tool by its number: what a program wrote, or what the setup says.
double edge_datum(MotionView m, std::int32_t number);
/// Return a number of the zero point of a work system: 0 is the external one, 7 the first extra
/// one.
double work_offset(MotionView m, int system, int axis);
/// Return what the shift of G92 becomes when it is restored; of axis -1 whether it counts, 1 or 0.
double kept_shift(MotionView m, int axis);
double reference_point(MotionView m, int number, int axis);
double offset(MotionView m, VariableKind kind, int number);

/// Return where the tool stands, in work coordinates, and in machine coordinates: mm.
std::vector<std::pair<std::string, double>> position(MotionView m);
std::vector<std::pair<std::string, double>> position_in_machine(MotionView m);
std::vector<std::pair<std::string, std::string>> modal(MotionView m);
/// Return every name that `modal` may show.
std::vector<std::string> mode_names();
/// Return the group of codes that `modal` shows under a name; nothing for one of a word.
std::optional<Group> group_named(std::string_view name);

/// Return a number without a point at this address, as an argument of a macro.
double scaled(MotionView m, char address, double value);
/// Return the least input increment of an address, 0 where it has none.
double increment(MotionView m, char address, const BlockCodes* of_block = nullptr);
/// Return a workpiece in machine coordinates and true lengths, its zero point where it is now.
Workpiece placed(MotionView m, Workpiece workpiece);

/// Return the axis of this number, -1 where the control has none.
int axis_number(MotionView m, int axis);

}  // namespace cncsub
