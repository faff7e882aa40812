// Sets of single characters: the addresses of a rule, the marks of a name.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "cncsub/text/literal.hpp"

namespace cncsub {

/// Characters of one kind, each once, in the order in which they were given. A literal is checked
/// when it is compiled.
template <class Kind>
class Characters {
 public:
  constexpr Characters() = default;
  consteval Characters(const char* literal) {  // NOLINT(misc-explicit-constructor)
    for (; *literal != 0; ++literal)
      if (!put(*literal)) literal_is_wrong();
  }

  /// Put a character after the others; return false where it is none of the kind.
  constexpr bool put(char c) {
    if (!Kind::has(c)) return false;
    if (has(c)) return true;
    there_[word(c)] |= bit(c);
    list_[size_++] = c;
    return true;
  }
  constexpr bool has(char c) const {
    return static_cast<unsigned char>(c) < 128 && (there_[word(c)] & bit(c)) != 0;
  }
  constexpr bool empty() const { return size_ == 0; }
  constexpr const char* begin() const { return list_.data(); }
  constexpr const char* end() const { return list_.data() + size_; }
  constexpr char front() const { return list_[0]; }
  constexpr std::string_view text() const { return {list_.data(), size_}; }
  bool operator==(const Characters&) const = default;

 private:
  static constexpr std::size_t word(char c) { return static_cast<unsigned char>(c) / 64; }
  static constexpr std::uint64_t bit(char c) {
    return std::uint64_t{1} << (static_cast<unsigned char>(c) % 64);
  }

  // The widest first: Clang 16 loses a literal with a gap between its members.
  std::array<std::uint64_t, 2> there_{};
  std::array<char, Kind::kMost> list_{};
  std::uint8_t size_ = 0;
};

struct AddressKind {
  static constexpr std::size_t kMost = 26;
  static constexpr std::string_view kWhat = "an address: write capital letters, as in XYZ";
  static constexpr bool has(char c) { return c >= 'A' && c <= 'Z'; }
};
struct MarkKind {
  static constexpr std::size_t kMost = 42;
  static constexpr std::string_view kWhat = "a mark: write +-_.";
  static constexpr bool has(char c) {
    return (c > ' ' && c < 'A') || (c > 'Z' && c < 'a') || (c > 'z' && c < 127);
  }
};

using Letters = Characters<AddressKind>;
using Marks = Characters<MarkKind>;

}  // namespace cncsub
