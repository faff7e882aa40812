// Blocks such as `N10 G90 G1 X10.5 Y-3. F200` or `S500 M3`. Most blocks are of this kind, and every
// language writes them alike: they are read in one pass, by a table of what the control takes. What
// is not that plain is left to the reader of the language, which compiles the same from a plain
// one.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <bitset>
#include <cstdint>
#include <span>
#include <string_view>

#include "cncsub/code/builder.hpp"
#include "cncsub/system/compiler.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

constexpr std::ptrdiff_t kLongestPlain = 200;  // bytes; a plain block is short
constexpr int kMostPlainWords = 20;

/// What the plain blocks of a control hold. A table without kinds leaves all to the other reader.
struct PlainTable {
  enum class Kind : std::uint8_t { No, Comment, End, Value, G, M, N };
  static constexpr std::uint8_t kPoint = 1, kMinus = 2, kIncrements = 4;
  static constexpr std::size_t kDwell = 4;  // for G04 it matters whether a value has a point

  void set(std::string_view characters, Kind kind) {
    for (const char c : characters) kinds[static_cast<unsigned char>(c)] = kind;
  }
  Kind kind_of(char c) const { return kinds[static_cast<unsigned char>(c)]; }

  std::array<Kind, 256> kinds{};             // what a character begins
  std::array<std::uint8_t, 256> of_value{};  // of the letter of a value: what it takes
  std::bitset<1000> g;  // the codes that are executed, whatever else the block holds
  int max_digits = 0;
  int max_n = 0;
  bool cuts_fine_digits = false;
  bool dwells = false;
};

/// The words of a plain block.
struct PlainWords {
  std::array<Cell, 26> values;  // NOLINT: written where the mask says so
  std::uint32_t mask = 0;
  Cell::Extra extra{};    // `whole`: the words that count in increments
  std::array<int, 12> g;  // NOLINT: the first of them
  std::size_t g_count = 0;
  bool dwell = false;
  int m = -1;
  std::int32_t n = -1;
  int count = 0;

  bool any() const { return mask != 0 || g_count != 0 || m >= 0; }
  std::span<const int> codes() const { return {g.data(), g_count}; }
};

/// Reads plain blocks. `Language` says of a code with `takes_m(m)` whether it leaves the order of
/// blocks as it is, and takes a value that is no number with `computed(words, letter, at)`; `at` is
/// then after it.
template <class Language>
class PlainWordReader {
 public:
  PlainWordReader(const PlainTable& table, Language& language)
      : table_(table), language_(language) {}

  /// Take the words from `p` to `end`, whose character must be readable. Return false where the
  /// block is not plain.
  CNCSUB_ALWAYS_INLINE inline bool read(const char* p, const char* end, PlainWords& words) {
    for (;;) {
      while (*p == ' ') ++p;
      if (p >= end) return true;  // the character there is in no word
      const char letter = *p++;
      const PlainTable::Kind kind = table_.kind_of(letter);
      if (kind == PlainTable::Kind::Comment && pass_comment(p, end)) continue;
      if (kind == PlainTable::Kind::End) return true;
      if (kind <= PlainTable::Kind::End || ++words.count > kMostPlainWords) return false;
      const char* const value = p;
      const bool negative = *p == '-';
      p += negative ? 1 : 0;
      const Mantissa number = scan_mantissa(p);
      const bool taken = fits(number) ? take(words, kind, letter, negative, number)
                                      : kind == PlainTable::Kind::Value && number.whole == 0 &&
                                            language_.computed(words, letter, p = value);
      if (!taken) return false;
    }
  }

  bool fits(const Mantissa& number) const {
    const auto digits = number.whole + number.decimals;
    return digits != 0 && digits <= kMostDigits &&
           number.whole + (number.point ? 3 : 0) <= table_.max_digits;
  }

  bool take_n(PlainWords& words, const Mantissa& number) const {
    if (words.count > 1 || number.value == 0 ||
        number.value > static_cast<std::uint64_t>(table_.max_n))
      return false;
    words.n = static_cast<std::int32_t>(number.value);
    return true;
  }

 private:
  static constexpr std::uint64_t kMostM = 1000;

  /// Pass over a comment with its closing bracket; false if it is not closed.
  static bool pass_comment(const char*& at, const char* end) {
    at = std::find(at, end, ')');
    return at++ != end;
  }

  bool take(PlainWords& words, PlainTable::Kind kind, char letter, bool negative,
            const Mantissa& number) const {
    if (kind == PlainTable::Kind::Value) return take_value(words, letter, negative, number);
    if (number.point || negative) return false;
    return kind == PlainTable::Kind::G   ? take_g(words, number)
           : kind == PlainTable::Kind::M ? take_m(words, number)
                                         : take_n(words, number);
  }

  bool take_value(PlainWords& words, char letter, bool negative, const Mantissa& number) const {
    if (number.decimals > 3 && table_.cuts_fine_digits) return false;
    const std::uint8_t takes = table_.of_value[static_cast<unsigned char>(letter)];
    const bool counts =
        ((takes & PlainTable::kIncrements) != 0) & !number.point & (number.value != 0);
    const bool refused = (negative & ((takes & PlainTable::kMinus) == 0)) |
                         (number.point & ((takes & PlainTable::kPoint) == 0));
    const std::uint32_t mark = bit(letter);
    if (refused || (words.mask & mark) != 0) return false;
    // Signs follow no pattern: nothing branches on them.
    const double value = static_cast<double>(static_cast<std::int64_t>(number.value)) /
                         kPowersOfTen[number.decimals];
    words.values[static_cast<std::size_t>(letter - 'A')].value = std::bit_cast<double>(
        std::bit_cast<std::uint64_t>(value) ^ static_cast<std::uint64_t>(negative) << 63);
    words.mask |= mark;
    words.extra.whole |= counts ? mark : 0;
    return true;
  }

  bool take_g(PlainWords& words, const Mantissa& number) const {
    if (words.g_count == words.g.size() || number.value >= table_.g.size()) return false;
    if (!table_.g[number.value]) {
      if (number.value != PlainTable::kDwell || !table_.dwells) return false;
      words.dwell = true;
    }
    words.g[words.g_count++] = static_cast<int>(number.value);
    return true;
  }

  bool take_m(PlainWords& words, const Mantissa& number) const {
    if (words.m >= 0 || number.value >= kMostM) return false;
    const int m = static_cast<int>(number.value);
    if (!language_.takes_m(m)) return false;
    words.m = m;
    return true;
  }

  const PlainTable& table_;
  Language& language_;
};

}  // namespace cncsub
