// The replacements for what a system or a library lacks, checked against the standard.
#pragma once

#include <string>
#include <vector>

namespace cncsub::selftest {

/// Return the differences, one line each.
std::vector<std::string> system_differences();

}  // namespace cncsub::selftest
