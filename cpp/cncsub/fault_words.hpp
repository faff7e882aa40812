// Which word of its block a fault of the motion is about.
#pragma once

#include <string_view>
#include <vector>

#include "cncsub/code.hpp"
#include "cncsub/motion_codes.hpp"

namespace cncsub {

/// Points a fault at the word of its block, which is written as `block` and begins at `text` in its
/// file: at the word the fault names, else at the one its cause is about.
void point_at_word(const GCodes& codes, std::string_view block, std::uint32_t text, Fault& fault);

/// The causes that point at a word of their own, not at the head of their block.
std::vector<std::string_view> causes_with_words();

}  // namespace cncsub
