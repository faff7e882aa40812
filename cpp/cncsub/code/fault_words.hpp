// Finds the word of its block that a fault is about.
#pragma once

#include <cstdint>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/control/g_codes.hpp"

namespace cncsub {

/// Return the first word of a block that has one of these names; null where none has. Groups of G
/// codes need `codes`.
const WrittenWord* find_word(const WordName& name, const std::vector<WrittenWord>& words,
                             const Spelling& spelling, const GCodes* codes);

/// Point a fault of the motion, which says its block, at the word that it names.
void point_at_word(const Code& code, const GCodes& codes, Fault& fault);

}  // namespace cncsub
