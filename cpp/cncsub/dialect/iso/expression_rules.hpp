// What a control says of expressions, made ready to be asked for every one of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "cncsub/code/code.hpp"

namespace cncsub {

struct FunctionName {
  Function function;
  Ins one, two = Ins::End;  // of one argument, of two; End: it does not take so many
};

struct ExpressionRules {
  explicit ExpressionRules(const Code& of);

  const Code& code;
  const Control& control;
  bool alike;          // logic binds like arithmetic
  bool numbers_first;  // logic binds like arithmetic where it joins numbers, and last otherwise
  bool joined;         // [...] AND [...]
  bool values;         // a comparison leaves a number
  bool bare;           // conditions stand without brackets
  bool symbols;        // >= beside GE
  bool names;          // #NAME
  bool indirect;       // #9100
  bool points;         // #100.
  bool distinguishes_vacant;
  bool modulo;
  int most_brackets;
  std::ptrdiff_t most_digits;           // that a constant may have without a look at what they are
  std::ptrdiff_t most_variable_digits;  // the same of the number of a variable
  static constexpr std::ptrdiff_t kMostVariableDigits = 9;

  /// Whether a function, or an operator that some controls have not, is there.
  bool has(Function function) const { return control.macros.functions.value.has(function); }
  /// The function of this name, or of the name that it abbreviates; null where there is none.
  const FunctionName* function(std::string_view name) const;
  /// The function whose name is these three letters, null where there is none.
  const FunctionName* short_function(char a, char b, char c) const {
    const std::uint32_t name = packed(a, b, c);
    for (std::size_t slot = slot_of(name);; slot = (slot + 1) % kSlots)
      if (short_names_[slot] == name || short_names_[slot] == 0) return short_functions_[slot];
  }

 private:
  static constexpr std::size_t kSlots = 64;

  /// Small letters are as capital ones, and no other character becomes a letter.
  static constexpr std::uint32_t packed(char a, char b, char c) {
    const auto byte = [](char of) { return std::uint32_t{static_cast<unsigned char>(of)}; };
    return (byte(a) | byte(b) << 8 | byte(c) << 16) & 0xDFDFDFU;
  }
  static constexpr std::size_t slot_of(std::uint32_t name) {
    return (name ^ name >> 6 ^ name >> 13) % kSlots;
  }

  // Functions of three letters, each in the first free slot from its own on; fewer than there are.
  std::array<std::uint32_t, kSlots> short_names_{};
  std::array<const FunctionName*, kSlots> short_functions_{};
};

}  // namespace cncsub
