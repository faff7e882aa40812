// The arguments of macro calls.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "cncsub/dialect/iso/block_meaning.hpp"
#include "cncsub/dialect/iso/block_rules.hpp"

namespace cncsub {

/// The arguments of a macro call, each with the local that it sets, in the order written. A later
/// argument of the same local wins.
class MacroArguments {
 public:
  MacroArguments(const BlockRules& rules, const BlockMeaning& meaning)
      : rules_(rules), control_(rules.control), meaning_(meaning) {}
  /// Find the local that a word after the call sets; return what is wrong with the word.
  std::optional<Fault> add(const Token& token, int& variable);

 private:
  std::optional<Fault> refused_code(const Token& token) const;
  int set_of(char letter);

  const BlockRules& rules_;
  const Control& control_;
  const BlockMeaning& meaning_;
  std::uint32_t seen_ = 0;
  // For I, J and K: the set of the last one, its letter, and how many of each were read.
  int set_ = 1;
  char last_ = 0;
  std::array<int, 3> of_letter_{};
};

}  // namespace cncsub
