// The reader of blocks: it compiles their text into code by the control's lexical rules.
#pragma once

#include <cstddef>
#include <optional>

#include "cncsub/code/builder.hpp"
#include "cncsub/dialect/iso/block_rules.hpp"
#include "cncsub/dialect/iso/plain.hpp"
#include "cncsub/dialect/iso/word_scanner.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

class BlockReader {
 public:
  explicit BlockReader(Builder& to, const IsoVariant& variant = {})
      : to_(to),
        control_(to.control()),
        rules_(to.code(), variant),
        expressions_(to, rules_.expressions),
        plain_(to, rules_, expressions_) {}
  /// Compile the text between the scanner and its end into `block`, whose text and line are set.
  /// An interrupt leaves `block` unfinished.
  void read(Scanner& scanner, Block& block) {
    block.op = Op::Words;
    if (!plain_.read(scanner, block)) read_any(scanner, block);
  }

  /// Let blocks of a structured program with this text come next.
  /// `types`: those of its variables, as they are known at each block.
  void begin_text(std::string_view written, const std::unordered_map<std::int64_t, bool>& types) {
    rules_.expressions.written = written.data();
    rules_.expressions.types = &types;
  }
  ExpressionReader& expressions() { return expressions_; }

 private:
  void read_any(Scanner& s, Block& block);
  void conditional_return(Scanner& s, Block& block);
  void words_or_more(Scanner& s, Block& block);
  Tokens without_return(const Tokens& tokens) const;
  std::optional<Block> words_behind(Scanner& s, Block& block,
                                    const std::optional<Statement>& assigned);
  void write(Block& block, const Tokens& tokens, bool calls);
  void write_slash(Block& block, const Tokens& tokens, std::size_t slash, bool calls);

  Builder& to_;
  const Control& control_;
  BlockRules rules_;
  ExpressionReader expressions_;
  PlainReader plain_;
  Tokens tokens_;
};

}  // namespace cncsub
