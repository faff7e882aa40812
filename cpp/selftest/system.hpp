// What stands in for what a system or a library lacks, held to what the standard says.
#pragma once

#include <string>
#include <vector>

namespace cncsub::selftest {

/// What is wrong, a line each.
std::vector<std::string> system_differences();

}  // namespace cncsub::selftest
