// The axes of a run by their letters, and the values that stand for axes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace cncsub {

constexpr std::string_view kAxisNames = "XYZABCUVW";

/// Return the value that stands for an axis: its place from 1; 0 where the letter is none.
constexpr std::int32_t axis_value(char letter) {
  return static_cast<std::int32_t>(kAxisNames.find(letter) + 1);
}
/// Return the letter of the axis that a value stands for; nothing where it is none.
inline std::string axis_letter(double value) {
  const bool known = value >= 1 && value < static_cast<double>(kAxisNames.size()) + 1;
  return known ? std::string(1, kAxisNames[static_cast<std::size_t>(value) - 1]) : std::string();
}

}  // namespace cncsub
