// What the first bytes of a file tell of the rest.
#pragma once

#include <string_view>

namespace cncsub {

/// The mark of the order of bytes that some put before UTF-8.
constexpr std::string_view kMarkOfBytes = "\xef\xbb\xbf";

/// Whether the first bytes of a file are those of a text or of a punched tape.
bool looks_like_text(std::string_view bytes);

}  // namespace cncsub
