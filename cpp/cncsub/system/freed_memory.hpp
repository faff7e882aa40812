// What was freed, and what the C library keeps of it.
#pragma once

namespace cncsub::system {

/// Give what was freed back to the system, where the C library keeps it for itself: a process that
/// rests for a long time does not need it.
void give_back_freed_memory() noexcept;

}  // namespace cncsub::system
