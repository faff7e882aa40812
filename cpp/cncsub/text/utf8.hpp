// A check whether bytes are UTF-8 as Python reads it.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace cncsub {

/// Return whether no byte is above 127.
bool is_ascii(std::string_view text);

/// Return how many bytes the character has that `text` begins with. Return 0 if there is none: an
/// overlong form, a surrogate, a number beyond Unicode, the middle or a part of a character.
std::size_t utf8_character(std::string_view text);

/// Return whether a text is UTF-8. `stopped` is asked before each piece; if it gives true, the
/// result means nothing.
bool is_utf8(std::string_view text, const std::function<bool(std::size_t)>& stopped);

}  // namespace cncsub
