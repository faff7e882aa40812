// Characters that look like others, for the messages about what cannot be read.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cncsub {

/// Return what to say of a character that no word begins with, in addition: which plain one a
/// full-width one looks like; nothing for others.
std::string full_width_of(std::string_view character);

/// Return whether the letter O may be meant as a zero in the word at `at`: it follows the address,
/// or a digit or a point stands beside it.
bool has_letter_for_zero(std::string_view text, std::size_t at);

/// Return what to say in addition where it does.
inline std::string letter_for_zero(std::string_view text, std::size_t at) {
  return has_letter_for_zero(text, at) ? "; is the letter O meant as the digit 0?" : "";
}

}  // namespace cncsub
