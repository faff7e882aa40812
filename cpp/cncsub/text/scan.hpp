// The characters of a block: gaps, digits and letters, names and numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "cncsub/text/number.hpp"

namespace cncsub {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_letter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
constexpr char upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }
/// Return whether a character is a digit, a point or a sign.
inline bool begins_number(char c) { return is_digit(c) || c == '.' || c == '-' || c == '+'; }
/// Return whether a byte belongs to a character without beginning it.
inline bool is_inside_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }
/// Return the end of the character that `end` bytes of a text end in.
inline std::size_t end_of_character(std::string_view text, std::size_t end) {
  while (end < text.size() && is_inside_character(text[end])) ++end;
  return end;
}
/// Return the character that begins a text, with all its bytes.
inline std::string_view first_character(std::string_view text) {
  return text.substr(0, end_of_character(text, text.empty() ? 0 : 1));
}
/// Return whether a character is blank, or one of punched tape that means nothing: NUL and DEL.
inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\0' || c == '\x7f' || c == '\v' || c == '\f';
}

/// The characters that begin a gap: blanks, and the bracket of a comment.
inline constexpr auto kGaps = [] {
  std::array<bool, 256> gaps{};
  for (const char c : {' ', '\t', '\0', '\x7f', '\v', '\f', '('})
    gaps[static_cast<unsigned char>(c)] = true;
  return gaps;
}();
inline bool begins_gap(char c) { return kGaps[static_cast<unsigned char>(c)]; }

inline std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  return text;
}

/// Return a text with capitals in place of its small letters.
inline std::string capitals(std::string_view text) {
  std::string capital(text);
  for (char& c : capital) c = upper(c);
  return capital;
}
/// Return whether two texts are the same but for small letters and capitals.
inline bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return upper(x) == upper(y); });
}
/// Return what stands after the last sign of a path that parts its names.
inline std::string_view last_of_path(std::string_view path, std::string_view signs = "/\\") {
  const std::size_t slash = path.find_last_of(signs);
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

/// A place in a block's text. The text ends where the block ends, and comments are passed over like
/// blanks.
struct Scanner {
  const char* at = nullptr;
  const char* end = nullptr;
  const char* file = nullptr;  // the file's first character

  std::uint32_t offset() const { return static_cast<std::uint32_t>(at - file); }
  void blanks() {
    if (at != end && begins_gap(*at)) pass_gap();
  }
  void pass_gap() {
    while (at != end) {
      if (is_blank(*at)) {
        ++at;
      } else if (*at == '(') {
        while (at != end && *at != ')') ++at;
        if (at != end) ++at;
      } else {
        return;
      }
    }
  }
  char peek() {
    blanks();
    return at == end ? '\0' : upper(*at);
  }
  bool take(char c) {
    if ((at == end || *at != c) && peek() != c) return false;
    ++at;
    return true;
  }
  /// Pass over the rest of a comment with brackets of its own: the `)` after its end.
  void rest_of_comment() {
    while (at != end && *at == ')') {
      const char* before = at;
      while (before != file && is_blank(before[-1])) --before;
      if (before == file || before[-1] != ')') return;
      while (at != end && (*at == ')' || is_blank(*at))) ++at;
      blanks();
    }
  }

  /// Take a word if it stands here, even with gaps between its letters.
  bool take_word(std::string_view word) {
    const char* start = at;
    for (const char c : word) {
      if (peek() != c) {
        at = start;
        return false;
      }
      ++at;
    }
    return true;
  }
  /// Take the name of a variable: letters, digits and _.
  std::string take_name() {
    std::string name;
    for (char c = peek(); is_letter(c) || is_digit(c) || c == '_'; c = peek()) {
      name += c;
      ++at;
    }
    return name;
  }
};

/// A number as written.
struct Number {
  double value = 0;                // at most kLargest: whoever takes long numbers checks `digits`
  std::uint32_t digits = 0;        // without leading zeros
  std::uint32_t whole_digits = 0;  // of these, those before the point
  std::uint32_t decimals = 0;
  std::uint32_t written = 0;  // digits with leading zeros
  std::uint8_t points = 0;
  bool negative = false;
  bool has_sign = false;
  bool any = false;  // at least one digit
};

/// The digits of a number without its sign, all of them as one whole number.
struct Mantissa {
  std::uint64_t value = 0;
  std::ptrdiff_t whole = 0, decimals = 0;  // how many digits
  bool point = false;
};

/// Read digits, perhaps a point, and digits. The first character after them must be readable, and
/// the value does not hold more than 15 digits. (Eight characters at a time take longer: most
/// numbers are alike in length, so the branches of the loops are predicted.)
inline Mantissa scan_mantissa(const char*& at) {
  Mantissa m;
  const char* first = at;
  for (; is_digit(*at); ++at) m.value = m.value * 10 + static_cast<std::uint64_t>(*at - '0');
  m.whole = at - first;
  m.point = *at == '.';
  if (!m.point) return m;
  first = ++at;
  for (; is_digit(*at); ++at) m.value = m.value * 10 + static_cast<std::uint64_t>(*at - '0');
  m.decimals = at - first;
  return m;
}

/// Powers of ten that are exact.
inline constexpr double kPowersOfTen[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                          1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                          1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// Read sign, digits and points, with blanks allowed inside; leave the scanner after them.
Number scan_number(Scanner& s);

}  // namespace cncsub
