// The changes of the variables that are watched. A program writes a variable in many ways
// (assignments, arguments, what a code answers, a return to the caller's locals): what a step
// changed is found by looking behind it, so that a run in which nothing is watched does nothing for
// it. What the commonest blocks can change is known before: a plain move no variable of its own, an
// assignment one. Behind the others what is watched is compared range by range.
#pragma once

#include <cstdint>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// What a step can change of locals and commons.
struct Reach {
  enum class Kind : std::uint8_t { None, One, Any } kind = Kind::Any;
  bool local = false;      // One: a local of the present level, or a common,
  std::int32_t index = 0;  // and its place
};

/// Of the block that comes next.
Reach reach_of(const Run& run, const Block& block);

/// Before the first block, behind what the variables were given.
void begin_watching(Run& run);
/// Behind a step: a row for each variable that now reads another value. Locals are those of the
/// level that is open then.
void note_changes(Run& run, std::int64_t step, Address at, const Reach& reach = {});
/// Behind what somebody else did between two steps.
inline void note_changes_from_outside(Run& run) { note_changes(run, -1, run.state.pc); }

}  // namespace cncsub
