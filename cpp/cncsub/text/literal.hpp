// Literals that are checked when they are compiled.
#pragma once

namespace cncsub {

/// No constant: a consteval function that comes here stops the compiler at its literal.
inline void literal_is_wrong() {}

}  // namespace cncsub
