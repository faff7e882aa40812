// Which words a line may have beside its codes.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cncsub/control/alarm.hpp"

namespace cncsub::linuxcnc {

/// What stands in a line, as far as its text tells.
struct LineWords {
  std::vector<int> g, m;                         // codes; G times ten
  bool computed = false;                         // a code is an expression
  std::set<char> letters;                        // of the other words, small
  std::array<std::optional<double>, 26> values;  // of the words; nothing where they are computed
  std::array<std::uint32_t, 26> at{}, width{};   // where each stands

  bool has_g(std::initializer_list<int> codes) const;
  bool has_m(std::initializer_list<int> codes) const;
  bool has(char letter) const { return letters.contains(letter); }
  /// The number of a word; `otherwise` where it has none, or it is computed.
  double number(char letter, double otherwise) const {
    const auto place = static_cast<std::size_t>(letter - 'a');
    return has(letter) ? values[place].value_or(otherwise) : otherwise;
  }
};

/// A word that is wrong beside the others, and what the interpreter says of it.
struct WrongWord {
  char letter = 0;
  Cause cause{};
  std::string text;
};

/// A number below zero where there are none: it is refused while the line is read.
std::optional<WrongWord> below_zero(const LineWords& line);
/// The first of them in the order of the interpreter's own checks; nothing where the mode that is
/// in force decides.
std::optional<WrongWord> wrong_word(const LineWords& line);
/// Whether the mode in force decides over its words: it has none of the codes of motion.
bool is_in_mode(const LineWords& line);
/// The letters of its words that none of its codes uses, a bit for each.
std::uint32_t unused_letters(const LineWords& line);

}  // namespace cncsub::linuxcnc
