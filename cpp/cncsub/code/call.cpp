#include "cncsub/code/call.hpp"

#include <array>
#include <cstddef>

namespace cncsub {

std::string_view to_string(CallKind kind) {
  static constexpr std::array<std::string_view, 14> kNames{
      "M98",   "M198",   "M97",    "O",      "call",   "G65",    "G66",
      "G66.1", "G-code", "M-code", "T-code", "S-code", "B-code", "ASCII"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace cncsub
