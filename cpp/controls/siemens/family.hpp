// The parts that the controls of Siemens share in their own language (not in ISO mode).
#pragma once

#include "cncsub/control/control.hpp"

namespace cncsub::siemens {

constexpr const char* kKnown = "general knowledge of the SINUMERIK 840D";

/// Return the language, its G codes and R0 to R99. Words that are not read or not computed are
/// refused when they are reached: tool offsets, frames, radius compensation, global variables,
/// arrays, texts. Work begins in G54: the machine's maker decides which system is
/// in force at power-on.
Control family();
/// Give a control the standard cycles and their alarms; the family has them.
void standard_cycles(Control& c);

}  // namespace cncsub::siemens

namespace cncsub {

/// Return the SINUMERIK ONE mill, from which its relatives are copied.
Control siemens_one();

}  // namespace cncsub
