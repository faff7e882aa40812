// The numbers of a second kind of commons.
#pragma once

#include <cstdint>

namespace cncsub {

/// The number of @0, where a control has such commons: @5 is this one plus 5.
inline constexpr std::int32_t kAtVariables = 1'000'000;

}  // namespace cncsub
