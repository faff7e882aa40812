// The statements of the GSK controls: G65 H.
#pragma once

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// G65 H1 P#100 Q#101 R#102: assigns, calculates, jumps or raises an alarm. Of a jump that
/// compares it tells whether it `holds`.
bool h_code(Run& run, const HCode& h, bool& holds);

}  // namespace cncsub
