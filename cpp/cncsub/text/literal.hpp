// Literals that are checked when they are compiled.
#pragma once

namespace cncsub {

/// Stop the compiler at a wrong literal: a consteval function that calls this gives no constant.
inline void literal_is_wrong() {}

}  // namespace cncsub
