// Sorts blocks by their sequence numbers.
#pragma once

#include "cncsub/code/code.hpp"
#include "cncsub/text/interrupt_check.hpp"

namespace cncsub {

/// Sort the entries of a program, which come by address or by number.
void sort_numbers(Code& code, const Program& program, InterruptCheck& interrupt);

}  // namespace cncsub
