// The codes that the parameters of a control register to call programs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "cncsub/control/control.hpp"
#include "cncsub/text/number.hpp"

namespace cncsub {

/// Return whether a list names its programs by their codes and not by numbers: M0050 of M50,
/// G200001 of G200.1, T0000 of each T. Such a list of no parameters holds all codes from its first
/// to its last one.
inline bool calls_by_name(const CodeCall& list) { return list.program < 0; }
inline bool calls_all(const CodeCall& list) {
  return calls_by_name(list) && list.form == CodeCall::Form::List && list.count == 0;
}

/// Return the name of the program that a code calls by its name: M0050 of M50, G200001 of G200.1,
/// G200010 of G200.10. `written`: its number; empty where all codes of the letter call one program.
inline std::string name_of_called(char letter, std::string_view written) {
  std::string whole, decimals;
  bool point = false;
  for (const char c : written) {
    point = point || c == '.';
    if (c >= '0' && c <= '9') (point ? decimals : whole) += c;
  }
  const auto padded = [](std::string digits, std::size_t width) {
    digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
    return std::string(width - std::min(width, digits.size()), '0') + digits;
  };
  if (decimals.find_first_not_of('0') == std::string::npos) return letter + padded(whole, 4);
  return letter + padded(whole, 3) + padded(decimals, 3);
}

/// Call `take(list, number, program)` for each registered code. `number` is as the parameter holds
/// it: negative where the code calls modally, 0 where it registers nothing. It is also 0 for a
/// switch, by which every code of a letter calls, if its parameter has the value that the switch
/// holds as `parameter`, or any but 0 where that is 0.
template <class Take>
void each_code_call(const Control& control, const Take& take) {
  constexpr std::int32_t kMost = 1'000'000'000, kMostOfRange = 1000;
  const auto parameter = [&](std::int32_t number) {
    return to_whole<std::int32_t>(control.parameter(std::to_string(number)), -kMost, kMost);
  };
  for (const CodeCall& list : control.code_calls) {
    const double enabled = list.enable.empty() ? 1 : control.parameter(list.enable);
    const bool other = list.form == CodeCall::Form::Switch && list.parameter != 0;
    if (enabled == 0 || (other && enabled != list.parameter)) continue;
    switch (list.form) {
      case CodeCall::Form::List:
        for (std::int32_t i = 0; i < list.count; ++i)
          take(list, parameter(list.parameter + i), list.program + i);
        break;
      case CodeCall::Form::Range: {
        const std::int32_t first = parameter(list.parameter), program = parameter(list.program);
        const std::int32_t count = std::min(parameter(list.count), kMostOfRange);
        for (std::int32_t i = 0; i < count; ++i) take(list, first + i, program + i);
        break;
      }
      case CodeCall::Form::Switch:
        take(list, 0, list.program);
        break;
    }
  }
}

}  // namespace cncsub
