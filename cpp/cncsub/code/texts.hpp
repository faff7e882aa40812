// Texts that values stand for, and how values are written as texts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "cncsub/text/scan.hpp"

namespace cncsub {

/// Return how many bytes the first characters of a text have, which is UTF-8.
inline std::size_t bytes_of_first(const std::string& text, std::size_t characters) {
  std::size_t at = 0;
  for (; at < text.size(); ++at)
    if (!is_inside_character(text[at]) && characters-- == 0) break;
  return at;
}

/// Texts of which each has one number.
class Texts {
 public:
  std::size_t size() const { return texts_.size(); }
  std::size_t bytes() const { return bytes_; }
  const std::string& at(std::size_t number) const { return texts_[number]; }
  std::optional<std::uint32_t> find(const std::string& text) const {
    const auto found = numbers_.find(text);
    return found == numbers_.end() ? std::nullopt : std::optional(found->second);
  }
  /// Return the number of a text, which it is given now where it has none.
  std::uint32_t number_of(const std::string& text) {
    const auto next = static_cast<std::uint32_t>(texts_.size());
    const auto [found, is_new] = numbers_.try_emplace(text, next);
    if (is_new) {
      texts_.push_back(text);
      bytes_ += 2 * text.size() + kBytesEach;
    }
    return found->second;
  }

 private:
  static constexpr std::size_t kBytesEach = 128;  // two strings and a node

  std::vector<std::string> texts_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
  std::size_t bytes_ = 0;
};

/// How a value is written as a text.
enum class WrittenAs : std::uint8_t { Text, Number, Truth, Character, Axis };

/// How SPRINT writes a value: %10.3F.
struct TextFormat {
  char kind = 'F';
  std::int32_t width = 0, decimals = -1;  // decimals: none given

  static constexpr std::int32_t kMost = 250;
  double packed() const { return kind + 256.0 * (width + 1024.0 * (decimals + 1)); }
  static TextFormat of(double packed);
};

inline TextFormat TextFormat::of(double packed) {
  const auto all = static_cast<std::uint32_t>(packed);
  return {static_cast<char>(all & 0xFFU), static_cast<std::int32_t>(all >> 8 & 0x3FFU),
          static_cast<std::int32_t>(all >> 18) - 1};
}

}  // namespace cncsub
