// Which words go with which codes, for a language that refuses a word none of the block's codes
// uses.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

namespace cncsub {

/// A letter, the codes that use it (G codes times ten), and what the control says where none does.
struct WordUse {
  char letter;
  std::initializer_list<int> g, m;
  std::string_view text;
  double none = std::numeric_limits<double>::quiet_NaN();  // a value that counts as no word
};

/// The uses of letters by code, a bit for each letter.
class WordUses {
 public:
  WordUses() = default;
  explicit WordUses(std::span<const WordUse> uses);

  /// Return the letters that need a code.
  std::uint32_t checked() const { return checked_; }
  std::uint32_t of_g(int tenfold) const { return of(of_g_, tenfold); }
  /// Return the letters of an M code. M codes of the user take any word. [LC m-code]
  std::uint32_t of_m(int code) const { return code >= 100 ? ~0u : of(of_m_, code); }
  /// Return the value of a letter that counts as no word; a NaN where there is none.
  double none(std::size_t letter) const { return none_[letter]; }
  /// Return what the control says of the first of these letters.
  std::string_view text(std::uint32_t letters) const {
    return texts_[static_cast<std::size_t>(std::countr_zero(letters)) % texts_.size()];
  }

 private:
  static std::uint32_t of(const std::vector<std::uint32_t>& letters, int code) {
    const auto place = static_cast<std::size_t>(code);
    return code >= 0 && place < letters.size() ? letters[place] : 0;
  }

  std::uint32_t checked_ = 0;
  std::vector<std::uint32_t> of_g_, of_m_;
  std::array<std::string_view, 32> texts_{};
  std::array<double, 32> none_{};
};

}  // namespace cncsub
