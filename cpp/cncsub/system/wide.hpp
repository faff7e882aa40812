// Paths for systems whose paths are UTF-16.
#pragma once

#include <string>
#include <string_view>

namespace cncsub::system {

/// UTF-8 as 16-bit units, halves of pairs included (Python's "surrogatepass"). Bytes that are none
/// become U+FFFD.
template <class Wide = std::wstring>
Wide wide(std::string_view text) {
  using Unit = typename Wide::value_type;
  Wide units;
  units.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const auto first = static_cast<unsigned char>(text[at++]);
    int more = first < 0x80 ? 0 : first < 0xC2 ? -1 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : 3;
    if (first > 0xF4) more = -1;
    char32_t point = more <= 0 ? first : first & (0x3FU >> static_cast<unsigned>(more));
    for (; more > 0; --more, ++at) {
      const auto next = at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
      if ((next & 0xC0U) != 0x80) break;
      point = point << 6U | (next & 0x3FU);
    }
    if (more != 0 || point > 0x10FFFF) point = 0xFFFD;
    if (point < 0x10000) {
      units += static_cast<Unit>(point);
    } else {
      units += static_cast<Unit>(0xD800U + ((point - 0x10000U) >> 10U));
      units += static_cast<Unit>(0xDC00U + ((point - 0x10000U) & 0x3FFU));
    }
  }
  return units;
}

}  // namespace cncsub::system
