// The groups of codes and words. One of a group may stand in a block.
#pragma once

#include <string_view>

namespace cncsub::sinumerik {

constexpr int kCodeGroups = 64;

/// Return the number of the G group of a code; 0 if it is in none.
int group_of(int code);
/// Return the same for a word such as BRISK.
int group_of(std::string_view word);

}  // namespace cncsub::sinumerik
