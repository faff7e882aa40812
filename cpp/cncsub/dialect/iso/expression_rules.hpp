// The control's rules for expressions, prepared for use in every one of them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <unordered_map>

#include "cncsub/code/code.hpp"
#include "cncsub/control/at_variables.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

struct FunctionName {
  Function function;
  Ins one, two = Ins::End;  // for one argument, for two; End: it does not take so many
};

struct ExpressionRules {
  /// `structured`: of structured programs.
  explicit ExpressionRules(const Code& of, bool structured = false);

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
  bool word_arithmetic;  // X#1+10
  bool modulo;
  int most_brackets;
  std::ptrdiff_t most_digits;  // of a constant that needs no closer look
  static constexpr std::ptrdiff_t kMostVariableDigits = 9;
  bool structured;  // brackets are round, values have types, = compares
  // The text of the structured program that is read. Where it has an @, the # of the text that the
  // readers see stands for one.
  const char* written = nullptr;
  // The variables whose value is known to be whole (true) or real at the place that is read, of
  // structured programs.
  const std::unordered_map<std::int64_t, bool>* types = nullptr;

  /// Return whether the number of a variable does not say by itself which one is meant.
  bool needs_look(std::int64_t number) const { return structured || is_indirect(number); }
  /// Return what the sign at `at` adds to the number of a variable: @1 is #1000001.
  std::int32_t base_of(std::uint32_t at) const {
    return structured && written[at] == '@' ? kAtVariables : 0;
  }

  /// Return whether the number of a variable stands in another variable: #9100 is #[#100].
  bool is_indirect(std::int64_t number) const {
    return indirect && number >= 9000 && number <= 9999;
  }
  /// Return whether the control has a function, or an operator that some controls lack.
  bool has(Function function) const { return control.macros.functions.value.has(function); }
  /// Return the function of this name, or of the name that it abbreviates; null if there is none.
  const FunctionName* function(std::string_view name) const;
  /// Return the function whose name of up to five letters stands at `at` before a bracket; null if
  /// there is none. `width`: the length of the name with the bracket.
  const FunctionName* function_at(const char* at, const char* end, int& width) const {
    if (end - at > 3 && at[3] == '[') {
      width = 4;
      return packed(letter(at[0]) | letter(at[1]) << 8 | letter(at[2]) << 16);
    }
    std::uint64_t name = 0;
    for (width = 0; width <= kLongest && is_letter(at[width]); ++width)
      name |= letter(at[width]) << 8 * width;
    return at[width++] == '[' ? packed(name) : nullptr;
  }

 private:
  static constexpr std::size_t kSlots = 64;
  static constexpr int kLongest = 5;  // letters of the longest such name

  const FunctionName* packed(std::uint64_t name) const {
    for (std::size_t slot = slot_of(name);; slot = (slot + 1) % kSlots)
      if (short_names_[slot] == name || short_names_[slot] == 0) return short_functions_[slot];
  }
  static constexpr std::uint64_t letter(char of) {
    return std::uint64_t{static_cast<unsigned char>(upper(of))};
  }
  static constexpr std::size_t slot_of(std::uint64_t name) {
    return (name ^ name >> 6 ^ name >> 13 ^ name >> 27) % kSlots;
  }

  // Functions of up to five letters, each in the first free slot from its own on. There are more
  // slots than functions.
  std::array<std::uint64_t, kSlots> short_names_{};
  std::array<const FunctionName*, kSlots> short_functions_{};
};

}  // namespace cncsub
