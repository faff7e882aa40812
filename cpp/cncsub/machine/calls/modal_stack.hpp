// Modes that a program saves for itself and for its caller.
#pragma once

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Carries out codes that save the modes, forget them or take them back in. False where that
/// alarms.
bool change_saved_modes(Run& run, const NcWords& words);
/// Behind a return: modes that were to come back do so.
bool come_back_to_modes(Run& run);

}  // namespace cncsub
