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
  std::ptrdiff_t most_digits;  // that a constant may have without a look at what they are

  /// Whether a function, or an operator that some controls have not, is there.
  bool has(Function function) const { return control.macros.functions.value.has(function); }
  /// The function of this name, or of the name that it abbreviates; null where there is none.
  const FunctionName* function(std::string_view name) const;
  /// The function of three letters that stands here with its bracket behind it, null where another
  /// word or a gap does.
  const FunctionName* short_function(const char* at) const;

  /// Where a local or one of the first commons lies, and how a value that may be vacant is pushed.
  struct Near {
    std::uint32_t first = 0, count = 0;
    Ins raw{};
    std::uint32_t base = 0;
    bool writable = false;
  };
  /// Null where the variable is another one.
  const Near* near(std::uint32_t number) const {
    for (const Near& range : near_)
      if (number - range.first < range.count) return &range;
    return nullptr;
  }

 private:
  std::array<Near, 3> near_{};
  std::array<std::uint32_t, 32> short_names_{};
  std::array<const FunctionName*, 32> short_functions_{};
};

}  // namespace cncsub
