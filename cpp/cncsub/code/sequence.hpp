// Blocks in the order of their sequence numbers.
#pragma once

#include "cncsub/code/code.hpp"
#include "cncsub/text/interrupt_check.hpp"

namespace cncsub {

/// The entries of a program, which come by address or by number, are in order from now on.
void sort_numbers(Code& code, const Program& program, InterruptCheck& interrupt);

}  // namespace cncsub
