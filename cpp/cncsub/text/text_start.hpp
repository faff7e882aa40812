// A look at the first bytes of a file, which tell what the rest is.
#pragma once

#include <string_view>

namespace cncsub {

/// The byte order mark that some write before UTF-8.
constexpr std::string_view kMarkOfBytes = "\xef\xbb\xbf";

/// Return whether the first bytes of a file are those of a text or of a punched tape.
bool looks_like_text(std::string_view bytes);

}  // namespace cncsub
