// A set of enumerators: the value of a rule that has several answers at once.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

namespace cncsub {

template <class E, std::size_t Most = 64>
class Set {
 public:
  constexpr Set() = default;
  constexpr Set(std::initializer_list<E> entries) {
    for (const E entry : entries) put(entry);
  }
  constexpr bool has(E entry) const { return (words_[word(entry)] >> place(entry) & 1) != 0; }
  constexpr void put(E entry, bool there = true) {
    const std::uint64_t mask = std::uint64_t{1} << place(entry);
    words_[word(entry)] = there ? words_[word(entry)] | mask : words_[word(entry)] & ~mask;
  }
  bool operator==(const Set&) const = default;

 private:
  static constexpr std::size_t word(E entry) { return static_cast<std::size_t>(entry) / 64; }
  static constexpr std::size_t place(E entry) { return static_cast<std::size_t>(entry) % 64; }

  std::array<std::uint64_t, Most / 64> words_{};
};

}  // namespace cncsub
