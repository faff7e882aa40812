// The G and M codes of the control, and their groups. One code of a group may stand in a line.
#pragma once

namespace cncsub::grblhal {

/// Return the group of a G code, which is given ten times; -1 if there is no such code. [gHg,
/// gc_execute_block, step 2]
int group_of_g(int code10);
/// Return the group of an M code; -1 if there is no such code, 0 if it is in none.
int group_of_m(int code);
/// Return whether a code takes the axis words of its line for itself: a line has one of these.
bool claims_axes(int code10);
/// Return whether a code of this number may have a fraction.
bool has_fractions(int number);

}  // namespace cncsub::grblhal
