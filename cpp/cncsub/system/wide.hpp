// Paths for systems whose paths are UTF-16.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace cncsub::system {

constexpr char32_t kNoCharacter = 0xFFFD;

/// Return the character at a place of UTF-8, halves of pairs included (Python's "surrogatepass"),
/// and move to the place after it. Bytes that are none are U+FFFD.
inline char32_t next_point(std::string_view text, std::size_t& at) {
  const auto first = static_cast<unsigned char>(text[at++]);
  if (first < 0x80) return first;
  if (first < 0xC2 || first > 0xF4) return kNoCharacter;
  const unsigned more = first < 0xE0 ? 1U : first < 0xF0 ? 2U : 3U;
  char32_t point = first & (0x3FU >> more);
  for (unsigned i = 0; i < more; ++i, ++at) {
    const auto next = at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
    if ((next & 0xC0U) != 0x80) return kNoCharacter;
    point = point << 6U | (next & 0x3FU);
  }
  return point > 0x10FFFF ? kNoCharacter : point;
}

/// Return UTF-8 as 16-bit units.
template <class Wide = std::wstring>
Wide wide(std::string_view text) {
  using Unit = typename Wide::value_type;
  Wide units;
  units.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const char32_t point = next_point(text, at);
    if (point < 0x10000) {
      units += static_cast<Unit>(point);
      continue;
    }
    units += static_cast<Unit>(0xD800U + ((point - 0x10000U) >> 10U));
    units += static_cast<Unit>(0xDC00U + ((point - 0x10000U) & 0x3FFU));
  }
  return units;
}

}  // namespace cncsub::system
