// The changes of the variables that are watched. A program writes a variable in many ways
// (assignments, arguments, what a code answers, a return to the caller's locals): what a step
// changed is found by looking behind it, so that a run in which nothing is watched does nothing for
// it.
#pragma once

#include <cstdint>

#include "cncsub/machine/context.hpp"

namespace cncsub {

/// Before the first block, behind what the variables were given.
void begin_watching(Run& run);
/// Behind a step: a row for each variable that now reads another value. Locals are those of the
/// level that is open then.
void note_changes(Run& run, std::int64_t step, Address at);
/// Behind what somebody else did between two steps.
inline void note_changes_from_outside(Run& run) { note_changes(run, -1, run.state.pc); }

}  // namespace cncsub
