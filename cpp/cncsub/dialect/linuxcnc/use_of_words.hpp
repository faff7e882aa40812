// The words that a line may have beside its codes.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cncsub/control/alarm.hpp"

namespace cncsub::linuxcnc {

/// The words of a line, as far as its text tells them.
struct LineWords {
  std::vector<int> g, m;                         // codes; G times ten
  bool computed = false;                         // a code is an expression
  std::bitset<128> letters;                      // of the other words, in small letters
  std::array<std::optional<double>, 26> values;  // of the words; nothing if computed
  std::array<std::uint32_t, 26> at{}, width{};   // where each stands

  bool has_g(std::initializer_list<int> codes) const;
  bool has_m(std::initializer_list<int> codes) const;
  bool has(char letter) const { return letters[static_cast<std::size_t>(letter)]; }
  /// Note the letter of a word; return false if the line has such a word already.
  bool add(char letter) {
    const bool is_new = !has(letter);
    letters.set(static_cast<std::size_t>(letter));
    return is_new;
  }
  /// Return the number of a word; `otherwise` if the line lacks the word, or it is computed.
  double number(char letter, double otherwise) const {
    const auto place = static_cast<std::size_t>(letter - 'a');
    return has(letter) ? values[place].value_or(otherwise) : otherwise;
  }
};

/// A word that is wrong beside the others, and the interpreter's message.
struct WrongWord {
  char letter = 0;
  Cause cause{};
  std::string text;
};

/// Return a word with a number below zero that it may not have: the reading of the line refuses it.
std::optional<WrongWord> below_zero(const LineWords& line);
/// Return the first wrong word in the order of the interpreter's own checks; nothing if the mode in
/// force decides.
std::optional<WrongWord> wrong_word(const LineWords& line);
/// Return whether the mode in force decides over the line's words: the line has no code of motion.
bool is_in_mode(const LineWords& line);
/// Return the letters of the words that none of the line's codes uses, a bit for each.
std::uint32_t unused_letters(const LineWords& line);

}  // namespace cncsub::linuxcnc
