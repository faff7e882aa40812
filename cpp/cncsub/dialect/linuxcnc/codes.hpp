// The G and M codes of the interpreter, and their groups. One code of a group may stand in a line.
#pragma once

namespace cncsub::linuxcnc {

/// Return the group of a G code, which is given ten times; -1 if there is no such code. [LC
/// overview, modal groups; the names of the groups are the interpreter's own]
int group_of_g(int code10);
/// Return the group of an M code.
int group_of_m(int code);

}  // namespace cncsub::linuxcnc
