// Runs a row and compares its outcome with the row.
#pragma once

#include <string>

#include "rows.hpp"

namespace cncsub::selftest {

/// Return the first difference between the outcome of the run and the row; empty where they agree.
/// Numbers agree to a ten-millionth: sines differ in their last digit from one system to the next.
std::string difference(Row row);

}  // namespace cncsub::selftest
