// The arguments of macro calls.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "cncsub/dialect/iso/block_meaning.hpp"
#include "cncsub/dialect/iso/block_rules.hpp"

namespace cncsub {

/// The arguments of a macro call, each as the local it sets, in the order written: the later one
/// wins.
class MacroArguments {
 public:
  MacroArguments(const BlockRules& rules, const BlockMeaning& meaning)
      : rules_(rules), control_(rules.control), meaning_(meaning) {}
  /// The local that a word behind the call sets, or what is wrong with it.
  std::optional<Fault> add(const Token& token, int& variable);

 private:
  std::optional<Fault> refused_code(const Token& token) const;
  int set_of(char letter);

  const BlockRules& rules_;
  const Control& control_;
  const BlockMeaning& meaning_;
  std::uint32_t seen_ = 0;
  // Of I, J and K: the set in which the last one stands, which that was, and how many of each.
  int set_ = 1;
  char last_ = 0;
  std::array<int, 3> of_letter_{};
};

}  // namespace cncsub
