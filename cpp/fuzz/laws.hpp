// The laws of a run, for all that make programs: a fuzzer from bytes, a generator from words.
#pragma once

#include "input.hpp"

namespace cncsub::fuzz {

/// Run a job in every way there is and check each run against the laws: in one go, block by block,
/// by a copy that continues by itself from some block, with pauses and interrupts, in parts that
/// are taken away, with every depth of the trace, and on the general path alone. Then reset two of
/// the machines and run them again. Stops the process where a claim is false.
void try_all_ways(const Job& job);

/// Check the words of every block, as they are written, against the words that it executes.
void check_words(const Code& code);

}  // namespace cncsub::fuzz
