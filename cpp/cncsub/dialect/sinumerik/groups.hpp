// The groups of codes and words of which one stands in a block.
#pragma once

#include <string_view>

namespace cncsub::sinumerik {

constexpr int kCodeGroups = 64;

/// The number of the G group of a code; 0 where it is in none.
int group_of(int code);
/// The same of a word such as BRISK.
int group_of(std::string_view word);

}  // namespace cncsub::sinumerik
