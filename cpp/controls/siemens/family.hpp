// What the controls of Siemens share in their own language (not in ISO mode).
#pragma once

#include "cncsub/control/control.hpp"

namespace cncsub::siemens {

constexpr const char* kKnown = "general knowledge of the SINUMERIK 840D";

/// The language, its G codes and R0 to R99. What is not read or not computed is refused when it is
/// reached: tool offsets, frames, radius compensation, FOR, CASE, variables with names, calls with
/// values. Work begins in G54: which system is in force at power-on a machine's maker decides.
Control family();

}  // namespace cncsub::siemens
