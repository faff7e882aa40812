// Which calls open a level of locals.
#pragma once

#include "cncsub/code/call.hpp"
#include "cncsub/control/control.hpp"

namespace cncsub {

/// Return whether a called program has locals of its own; else it has those of its caller.
inline bool has_own_locals(const CallRecord& call, const Control& control) {
  return call.macro || call.locals != CallRecord::Locals::ByKind ||
         control.macros.call_passes_words.value;
}

/// Return whether the numbered ones are its own: a call may share these alone.
inline bool has_own_numbers(const CallRecord& call, const Control& control) {
  return has_own_locals(call, control) && call.locals != CallRecord::Locals::OwnByName;
}

}  // namespace cncsub
