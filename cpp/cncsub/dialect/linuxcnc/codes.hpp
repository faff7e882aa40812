// The G and M codes of the interpreter, and the groups of which one code may stand in a line.
#pragma once

namespace cncsub::linuxcnc {

/// The group of a G code, ten times its number; -1 where there is no such code. [LC overview,
/// modal groups; the names of the groups are the interpreter's own]
int group_of_g(int code10);
/// The group of an M code.
int group_of_m(int code);

}  // namespace cncsub::linuxcnc
