// Sets of G or M codes, as ten times their numbers.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "cncsub/text/literal.hpp"

namespace cncsub {

/// A G code that a language writes as a word.
struct WordCode {
  int code;  // ten times its number
  std::string_view word;
};
inline constexpr WordCode kWordCodes[] = {
#define WORD_CODE(code, word) {code, word},
#include "cncsub/control/word_codes.def"
#undef WORD_CODE
};

/// Return ten times the code that is written as this word, in capitals; -1 where none is.
constexpr int code_of_word(std::string_view word) {
  for (const WordCode& of : kWordCodes)
    if (of.word == word) return of.code;
  return -1;
}

/// Return the word of a code that is written as one; empty where none is.
constexpr std::string_view word_of_code(int tenfold) {
  for (const WordCode& of : kWordCodes)
    if (of.code == tenfold) return of.word;
  return {};
}

/// Return ten times a code such as 54, 54.1 or TRANS; nothing where the text is none.
constexpr std::optional<int> read_code(std::string_view text) {
  if (const int code = code_of_word(text); code >= 0) return code;
  int tenfold = 0;
  std::size_t digits = 0;
  std::size_t at = 0;
  for (; at < text.size() && text[at] >= '0' && text[at] <= '9'; ++at, ++digits) {
    tenfold = tenfold * 10 + (text[at] - '0');
    if (tenfold >= 1000) return std::nullopt;
  }
  tenfold *= 10;
  if (at < text.size()) {
    if (text[at] != '.' || at + 2 != text.size() || text[at + 1] < '0' || text[at + 1] > '9')
      return std::nullopt;
    tenfold += text[at + 1] - '0';
    ++digits;
  }
  return digits == 0 ? std::nullopt : std::optional(tenfold);
}

/// Return 54.1 for 541, and the word of a code that is written as one.
std::string code_text(int tenfold);

/// A set of codes. A literal such as "0 1 54.1" is checked when it is compiled.
class Codes {
 public:
  static constexpr int kEnd = 10'000;

  constexpr Codes() = default;
  consteval Codes(const char* literal) {  // NOLINT(misc-explicit-constructor)
    std::string_view text = literal;
    while (!text.empty()) {
      const std::size_t blank = text.find(' ') < text.size() ? text.find(' ') : text.size();
      if (blank > 0) {
        const std::optional<int> code = read_code(text.substr(0, blank));
        code ? put(*code) : literal_is_wrong();
      }
      text.remove_prefix(blank < text.size() ? blank + 1 : blank);
    }
  }

  constexpr bool has(int tenfold) const {
    return tenfold >= 0 && tenfold < kEnd && (words_[word(tenfold)] & bit(tenfold)) != 0;
  }
  constexpr void put(int tenfold) { words_[word(tenfold)] |= bit(tenfold); }
  constexpr bool empty() const { return *this == Codes(); }
  /// Call `use` for each code, by number.
  template <class Use>
  void for_each(Use&& use) const {
    for (std::size_t place = 0; place < words_.size(); ++place)
      for (std::uint64_t rest = words_[place]; rest != 0; rest &= rest - 1)
        use(static_cast<int>(place * 64) + std::countr_zero(rest));
  }
  /// Return the codes by number, separated by blanks.
  std::string text() const;
  constexpr bool operator==(const Codes&) const = default;

 private:
  static constexpr std::size_t word(int tenfold) { return static_cast<std::size_t>(tenfold) / 64; }
  static constexpr std::uint64_t bit(int tenfold) { return std::uint64_t{1} << (tenfold % 64); }

  std::array<std::uint64_t, (kEnd + 63) / 64> words_{};
};

}  // namespace cncsub
