// The blocks of a program that no path to its end avoids.
#pragma once

#include <vector>

#include "cncsub/analysis/checker.hpp"

namespace cncsub {

/// Return the blocks that every path from one block to an end of the program passes, by their place
/// in it; all blocks where no path ends. It takes time in proportion to the exits.
std::vector<bool> passed_by_all(const Checker& c, const ProgramFlow& flow, Address start);

}  // namespace cncsub
