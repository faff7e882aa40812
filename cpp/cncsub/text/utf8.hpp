// Whether bytes are UTF-8 as Python reads it.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace cncsub {

/// Whether no byte is above 127.
bool is_ascii(std::string_view text);

/// The bytes of the character that `text` begins with; 0 where there is none: an overlong form, a
/// surrogate, a number beyond Unicode, the middle or a part of a character.
std::size_t utf8_character(std::string_view text);

/// `stopped` is asked behind each piece; what is answered then counts for nothing.
bool is_utf8(std::string_view text, const std::function<bool(std::size_t)>& stopped);

}  // namespace cncsub
