// The changes of the variables that are watched. A program writes a variable in many ways
// (assignments, arguments, what a code answers, a return to the caller's locals), so the changes of
// a step are found after it: a run in which nothing is watched does nothing for it. What the
// commonest blocks can change is known before: a plain move changes no variable of its own, an
// assignment one. After the others the watched variables are compared range by range.
#pragma once

#include <cstdint>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// The locals and commons that a step can change.
struct Reach {
  enum class Kind : std::uint8_t { None, One, Any } kind = Kind::Any;
  bool local = false;      // One: a local of the present level, or a common,
  std::int32_t index = 0;  // and its place
};

/// Return what the block that comes next can change.
Reach reach_of(const Run& run, const Block& block);

/// Begin to watch, before the first block and after the variables were given.
void begin_watching(Run& run);
/// Record a row, after a step, for each variable that now reads another value. Locals are those of
/// the level that is open then.
void note_changes(Run& run, std::int64_t step, Address at, const Reach& reach = {});
/// Record the changes that somebody else made between two steps.
inline void note_changes_from_outside(Run& run) { note_changes(run, -1, run.state.pc); }

}  // namespace cncsub
