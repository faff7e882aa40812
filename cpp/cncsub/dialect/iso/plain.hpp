// The reader of plain blocks, and of assignments such as `#101=[#102+1.5]`.
#pragma once

#include "cncsub/dialect/iso/block_rules.hpp"
#include "cncsub/dialect/iso/statement.hpp"
#include "cncsub/dialect/plain_words.hpp"

namespace cncsub {

class PlainReader {
 public:
  PlainReader(Builder& to, const BlockRules& rules, ExpressionReader& expressions);
  /// Compile a block if it is that plain. Return false if it is not: the scanner then stands where
  /// it stood, and the general reader, which gives the same code, reads the block.
  bool read(Scanner& s, Block& block) {
    if (*s.at != '#' || !assigns_ || s.end - s.at >= kLongestPlain) return read_words(s, block);
    StatementReader(to_, expressions_, s, block).assign();
    return true;
  }

 private:
  struct Language;

  bool read_words(Scanner& s, Block& block);
  bool read_skipped(Scanner& s, Block& block);
  bool numbered_assignment(Scanner& s, Block& block);
  static bool is_plain_dwell(const Scanner& s, const PlainWords& words);

  Builder& to_;
  const BlockRules& rules_;
  ExpressionReader& expressions_;
  PlainTable table_;
  bool assigns_ = false;
  bool whole_dwell_ = false;  // for G04 it matters whether a value has a point
};

}  // namespace cncsub
