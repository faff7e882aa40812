// Finds the word of its block that a fault of the motion is about.
#pragma once

#include <string_view>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/control/g_codes.hpp"

namespace cncsub {

/// Point a fault at one of the words of its block, which begins at `text` in its file: at the word
/// the fault names, else at the one its cause is about.
void point_at_word(const GCodes& codes, const std::vector<WrittenWord>& words, std::uint32_t text,
                   Fault& fault);

/// Return the causes that point at a word of their own, not at the head of their block.
std::vector<std::string_view> causes_with_words();

}  // namespace cncsub
