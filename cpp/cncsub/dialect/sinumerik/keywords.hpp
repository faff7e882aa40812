// Words of the language that are no names of programs.
#pragma once

#include <string_view>

namespace cncsub::sinumerik {

/// Words that no path depends on: how fast an axis starts, what the screen shows.
bool is_neutral(std::string_view word);
/// Words of the language that are not read here.
bool is_not_computed(std::string_view word);

/// Whether a line is the head of a subprogram whose return takes the modes of its caller back in:
/// PROC NAME(..) SAVE.
bool saves_modes(std::string_view line);

}  // namespace cncsub::sinumerik
