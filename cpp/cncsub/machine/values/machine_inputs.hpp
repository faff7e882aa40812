// The inputs of a block's motion: the profile that it names, skip signals, and who stops it.
#pragma once

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Return the inputs of the running block; they hold no longer than it runs.
MachineInputs machine_inputs(Run& run);

/// Read the profile from N(ns) to N(nf) of the running program. Of several it is the one that
/// stands next after the cycle, on every control: programs that use the same numbers again write it
/// so. The run has stopped where a word of the profile has alarmed.
std::optional<Fault> read_profile(Run& run, const ProfileNumbers& numbers, Profile& found);

}  // namespace cncsub
