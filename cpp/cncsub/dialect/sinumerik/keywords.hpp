// The codes and words of the language: the groups of which one may stand in a block, and words that
// are no names of programs.
#pragma once

#include <string_view>

namespace cncsub::sinumerik {

constexpr int kCodeGroups = 64;

/// Return the number of the G group of a code; 0 if it is in none.
int group_of(int code);
/// Return the same for a word such as BRISK.
int group_of(std::string_view word);

/// Return whether no path depends on a word, as on how fast an axis starts or what the screen
/// shows.
bool is_neutral(std::string_view word);
/// Return whether a word of the language is not read here.
bool is_not_computed(std::string_view word);

}  // namespace cncsub::sinumerik
