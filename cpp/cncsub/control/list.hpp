// Lists of entries of one kind. The kind says how an entry is written and when two are the same.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cncsub/text/literal.hpp"

namespace cncsub {

/// Take the next entry off a text of entries with blanks between; return an empty one at its end.
constexpr std::string_view take_entry(std::string_view& text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  const std::string_view entry = text.substr(0, std::min(text.find(' '), text.size()));
  text.remove_prefix(entry.size());
  return entry;
}

/// Return the enumerator whose name a word is; nothing where it is none.
template <class E, std::size_t Count>
constexpr std::optional<E> named(const std::string_view (&names)[Count], std::string_view word) {
  for (std::size_t i = 0; i < Count; ++i)
    if (names[i] == word) return static_cast<E>(i);
  return std::nullopt;
}

/// Entries of one kind, each once, in the order in which they were given. A literal is checked
/// when it is compiled.
template <class Kind>
class List {
 public:
  using Entry = typename Kind::Entry;

  constexpr List() = default;
  consteval List(const char* literal) {  // NOLINT(misc-explicit-constructor)
    std::string_view text = literal;
    for (auto word = take_entry(text); !word.empty(); word = take_entry(text)) {
      const std::optional<Entry> entry = Kind::read(word);
      if (!entry || has(*entry) || !put(*entry)) literal_is_wrong();
    }
  }

  /// Put an entry in the place of the same one, or after the others; return false where these are
  /// too many.
  constexpr bool put(const Entry& entry) {
    std::size_t place = 0;
    while (place < size_ && !Kind::same(list_[place], entry)) ++place;
    if (place == list_.size()) return false;
    if (place == size_) ++size_;
    list_[place] = entry;
    return true;
  }
  constexpr bool has(const Entry& entry) const {
    for (const Entry& one : *this)
      if (Kind::same(one, entry)) return true;
    return false;
  }
  constexpr bool empty() const { return size_ == 0; }
  constexpr const Entry* begin() const { return list_.data(); }
  constexpr const Entry* end() const { return list_.data() + size_; }
  /// Return the text as a literal is written.
  std::string text() const {
    std::string text;
    for (const Entry& entry : *this) text += (text.empty() ? "" : " ") + Kind::text(entry);
    return text;
  }
  bool operator==(const List&) const = default;

 private:
  // No gap between entries and their number: Clang 16 loses a literal that has one.
  static_assert(Kind::kMost < 256);
  std::array<Entry, Kind::kMost> list_{};
  std::uint8_t size_ = 0;
};

}  // namespace cncsub
