// The words of a line as interpreters of the RS274/NGC family write them.
#pragma once

#include <optional>
#include <string_view>

#include "cncsub/text/words.hpp"

namespace cncsub {

/// Read a word as `ReadWord` does. An O-word is one word with all the text after it, and an
/// assignment is one with its value. `signs`: those that are addresses, as letters are.
std::optional<WrittenWord> ngc_word(std::string_view block, std::size_t& from,
                                    std::string_view signs = {});

}  // namespace cncsub
