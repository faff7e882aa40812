// The words that a line may have beside its codes.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cncsub/dialect/grblhal/expression.hpp"

namespace cncsub::grblhal {

/// The words of a line, as far as its text tells them.
struct LineWords {
  std::vector<int> g, m;                         // codes; G times ten
  bool computed = false;                         // a code is an expression
  std::set<char> letters;                        // of the other words, in small letters
  std::array<std::optional<double>, 26> values;  // of the words; nothing if computed
  std::array<std::uint32_t, 26> at{}, width{};   // where each stands

  bool has_g(std::initializer_list<int> codes) const;
  bool has_m(std::initializer_list<int> codes) const;
  bool has(char letter) const { return letters.contains(letter); }
  bool has_axes() const { return has('x') || has('y') || has('z'); }
  /// Return the number of a word; `otherwise` if the line lacks the word, or it is computed.
  double number(char letter, double otherwise) const {
    const auto place = static_cast<std::size_t>(letter - 'a');
    return has(letter) ? values[place].value_or(otherwise) : otherwise;
  }
};

/// A word that is wrong beside the others.
struct WrongWord {
  char letter = 0;
  Cause cause{};
  std::string detail;
  Kind kind{};
};

/// Return the first wrong word of a line in the order of the control's own checks; nothing if the
/// mode in force decides. [gHg, gc_execute_block, step 3]
std::optional<WrongWord> wrong_word(const LineWords& line);

}  // namespace cncsub::grblhal
