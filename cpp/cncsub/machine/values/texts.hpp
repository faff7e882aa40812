// Texts of a run: the number of each, and what they say.
#pragma once

#include <string>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Return the text that a value stands for.
const std::string& text_of(const Run& run, double value);
/// Return the value that stands for a text. The character 0 ends a text.
double keep_text(Run& run, std::string text);

}  // namespace cncsub
