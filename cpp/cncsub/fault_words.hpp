// Which word of its block a fault of the motion is about.
#pragma once

#include <string_view>

#include "cncsub/code.hpp"
#include "cncsub/motion_codes.hpp"

namespace cncsub {

/// Points a fault at the word of its block, which is written as `block` and begins at `text` in its
/// file: at the word the fault names, else at the one its cause is about.
void point_at_word(const GCodes& codes, std::string_view block, std::uint32_t text, Fault& fault);

}  // namespace cncsub
