// Modes that a program saves for itself and for its caller.
#pragma once

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Execute codes that save the modes, forget them or restore them. Return false where that alarms.
bool change_saved_modes(Run& run, const NcWords& words);
/// Save the modes as they are when a program is entered whose return restores them: its codes, and
/// neither F nor S.
void keep_modes_of_caller(Run& run);
/// Restore, after a return, the modes that were to come back.
bool come_back_to_modes(Run& run);

}  // namespace cncsub
