// Literals that are checked when they are compiled.
#pragma once

namespace cncsub {

/// Stop the compiler at a literal: this is no constant, and a consteval function calls it.
inline void literal_is_wrong() {}

}  // namespace cncsub
