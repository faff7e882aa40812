// What a block's motion takes from around it: the profile that it names, skip signals, who stops
// it.
#pragma once

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// For the running block; it holds no longer than that runs.
MachineInputs machine_inputs(Run& run);

/// The profile from N(ns) to N(nf) of the running program. Of several it is the one that stands
/// next behind the cycle, on every control: programs that use the same numbers again write it so.
/// The run may have stopped then: a word of it has alarmed.
std::optional<Fault> read_profile(Run& run, const ProfileNumbers& numbers, Profile& found);

}  // namespace cncsub
