// The codes and words of the language: the groups of which one may stand in a block, and words that
// are no names of programs.
#pragma once

#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <string_view>

#include "cncsub/code/spelling.hpp"

namespace cncsub::sinumerik {

constexpr int kCodeGroups = 64;

template <class List>
bool is_among(const List& words, std::string_view word) {
  return std::find(std::begin(words), std::end(words), word) != std::end(words);
}

/// Return the number of the G group of a code; 0 if it is in none.
int group_of(int code);
/// Return the same for a word such as BRISK.
int group_of(std::string_view word);
/// Return whether a code holds for one block and says alone what is done with its words: a dwell, a
/// reference point, a frame, a pole, machine coordinates, POS, FA and MEAS. [NCI ggroups]
bool acts_alone(int group, int code);

/// Return the place in the mask of a block that holds the value of a long address: of CR, or I1; -1
/// where it is none.
int place_of(std::string_view address);
/// The long addresses, as messages and tools know them.
extern const std::span<const Spelling::LongAddress> kLongAddresses;

/// The words that the reader passes over: those on which no path depends, those with a value, the
/// calls, and those that only say that something is off.
extern const std::span<const std::string_view> kNeutralWords, kReportedWords, kReportedCallWords,
    kOffAtZeroWords, kAxisEndWords;
/// The words that are not read here. The further ones are no names that the language keeps for
/// itself: a program may define a variable of such a name.
extern const std::span<const std::string_view> kNotComputedWords, kFurtherWords;

/// Return whether a word with a value, FA[X]=500 or LIMS=3000, only says how fast or how exactly
/// the machine goes, or turns a spindle: it is reported.
bool is_reported(std::string_view word);

/// Return whether a call of the language, WAITP(X) or GROUP_END(0,0), changes no path: it is
/// reported.
bool is_reported_call(std::string_view word);
/// Return whether a word says how exactly an axis beside the path comes to its end: FINEA[X].
bool is_axis_end(std::string_view word);
/// Return whether a word with the value 0 only says that what it begins is off: TOFFL=0.
bool is_off_at_zero(std::string_view word);

/// Return whether no path depends on a word, as on how fast an axis starts or what the screen
/// shows.
bool is_neutral(std::string_view word);
/// Return whether a word of the language is not read here.
bool is_not_computed(std::string_view word);
/// Return whether a word, in capitals, has a meaning in the language: it names no variable.
bool is_keyword(std::string_view word);
/// Return a word that is not computed, with what it would need where that is known.
std::string what_it_needs(std::string_view word);

/// Return whether a word, in capitals, is GOTO or one of its kind.
bool is_jump(std::string_view word);

}  // namespace cncsub::sinumerik
