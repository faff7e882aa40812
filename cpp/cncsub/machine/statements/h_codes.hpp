// The statements of the GSK controls: G65 H.
#pragma once

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Execute G65 H1 P#100 Q#101 R#102: assign, calculate, jump or raise an alarm. `holds`: what the
/// comparison of a jump gave.
bool h_code(Run& run, const HCode& h, bool& holds);

}  // namespace cncsub
