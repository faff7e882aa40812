// Runs a row and says what came out, and where that is something else than the row says.
#pragma once

#include <string>

#include "rows.hpp"

namespace cncsub::selftest {

/// Where the outcome of the run and the row part; empty where they agree. Numbers agree to a
/// ten-millionth: sines differ in their last digit from one system to the next.
std::string difference(Row row);

}  // namespace cncsub::selftest
