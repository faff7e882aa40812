// The reader of blocks such as `N10 G90 G1 X10.5 Y-3. F200` or `S500 M3`, and of assignments such
// as `#101=[#102+1.5]`. Most blocks are of this kind and every control reads them alike: they are
// compiled in one pass.
#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>

#include "cncsub/code/builder.hpp"
#include "cncsub/dialect/iso/block_rules.hpp"
#include "cncsub/dialect/iso/statement.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

class PlainReader {
 public:
  PlainReader(Builder& to, const BlockRules& rules, ExpressionReader& expressions);
  /// Compile a block if it is that plain. Return false if it is not: the scanner then stands where
  /// it stood, and the general reader, which gives the same code, reads the block.
  bool read(Scanner& s, Block& block) {
    if (*s.at != '#' || !assigns_ || s.end - s.at >= kLongest) return read_words(s, block);
    StatementReader(to_, expressions_, s, block).assign();
    return true;
  }

 private:
  static constexpr int kLongest = 200;  // bytes; a plain block is short

  enum class Kind : std::uint8_t { No, Comment, Value, G, M, N };
  struct Words;

  bool fits(const Mantissa& number) const;
  bool take(Words& words, char letter, bool negative, const Mantissa& number) const;
  bool take_value(Words& words, char letter, bool negative, const Mantissa& number) const;
  bool take_g(Words& words, const Mantissa& number) const;
  bool take_m(Words& words, const Mantissa& number) const;
  bool take_n(Words& words, const Mantissa& number) const;
  bool read_words(Scanner& s, Block& block);
  bool read_skipped(Scanner& s, Block& block);
  bool numbered_assignment(Scanner& s, Block& block);
  bool take_words(Scanner& s, Words& words);
  bool take_computed(Words& words, char letter, const char*& at, Scanner& s);
  static bool is_plain_dwell(const Scanner& s, const Words& words);

  Builder& to_;
  const BlockRules& rules_;
  ExpressionReader& expressions_;
  std::array<Kind, 256> kinds_{};  // what a character begins
  std::bitset<1000> g_;            // the codes that are executed, whatever else the block holds
  int max_digits_;
  int max_n_;
  bool cuts_fine_digits_;
  bool assigns_ = false, dwells_ = false;
  bool whole_dwell_ = false;  // for G04 it matters whether a value has a point
};

}  // namespace cncsub
