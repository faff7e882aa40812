// The control's rules for the words of a block, prepared for use in every block.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "cncsub/code/code.hpp"
#include "cncsub/dialect/iso/calling_codes.hpp"
#include "cncsub/dialect/iso/expression_rules.hpp"
#include "cncsub/dialect/plain_words.hpp"

namespace cncsub {

/// The letters of lengths and angles. A whole number of them counts in increments where the control
/// says so.
constexpr std::string_view kLengths = "ABCHIJKQRUVWXYZ";

/// What a dialect that is built on this one reads in another way.
struct IsoVariant {
  bool structured = false;     // blocks of structured programs, see ExpressionRules
  bool after_blocks = false;   // G66.1 does not take the words of a block, it calls after it
  bool p_is_argument = false;  // P of a code that calls is #16
  // Return whether a word begins a statement of the other programs of the dialect, or null.
  bool (*is_other_statement)(std::string_view word) = nullptr;
};

struct BlockRules {
  explicit BlockRules(const Code& of, const IsoVariant& its = {});
  BlockRules(const BlockRules&) = delete;  // readers refer to it
  BlockRules& operator=(const BlockRules&) = delete;

  const Code& code;
  const Control& control;
  IsoVariant variant;
  ExpressionRules expressions;
  CallingCodes calling;
  CornerLetters corners_not_with_call;  // the chamfer and corner words that M98 refuses

  bool takes_point(char letter) const { return has(letter, PlainTable::kPoint); }
  bool takes_minus(char letter) const { return has(letter, PlainTable::kMinus); }
  /// Return whether a number of the letter without a point counts in increments, or in thousandths.
  bool in_increments(char letter) const { return has(letter, PlainTable::kIncrements); }
  /// Return all that the letter takes, as the table of plain words keeps it.
  std::uint8_t takes(char letter) const { return letters_[static_cast<unsigned char>(letter)]; }

 private:
  bool has(char letter, std::uint8_t what) const { return (takes(letter) & what) != 0; }

  std::array<std::uint8_t, 256> letters_{};
};

}  // namespace cncsub
