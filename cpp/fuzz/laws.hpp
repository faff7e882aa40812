// The laws of a run, for whoever makes programs: a fuzzer from bytes, a generator from words.
#pragma once

#include "input.hpp"

namespace cncsub::fuzz {

/// Makes the run of a job in every way there is - in one go, block by block, by a copy that goes on
/// by itself from some block on, with pauses and interrupts, in parts that are taken away, with
/// every depth of the trace, and by the general way alone -, holds them all to the laws, then
/// resets two of the machines and runs them again. Stops the process where a claim is false.
void try_all_ways(const Job& job);

/// Holds the words of every block, as they are written, to the words that it executes.
void check_words(const Code& code);

}  // namespace cncsub::fuzz
