// Files that define variables for the programs of all others, which are read after them.
#pragma once

#include <algorithm>
#include <string_view>

#include "cncsub/code/program.hpp"
#include "cncsub/code/spelling.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

/// Return whether a file is one of these in the language of the spelling.
inline bool defines_for_all(const Spelling& spelling, const SourceFile& file) {
  const std::string_view ending = spelling.definitions, name = file.name;
  return !ending.empty() && name.size() >= ending.size() &&
         std::equal(ending.begin(), ending.end(), name.end() - std::ssize(ending),
                    [](char a, char b) { return a == upper(b); });
}

}  // namespace cncsub
