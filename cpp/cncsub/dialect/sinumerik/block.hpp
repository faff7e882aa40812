// The compiler of a block of words, assignments and a message, of a call or of a statement.
#pragma once

#include <string>

#include "cncsub/dialect/plain_words.hpp"
#include "cncsub/dialect/sinumerik/declarations.hpp"
#include "cncsub/dialect/sinumerik/open_block.hpp"

namespace cncsub::sinumerik {

class BlockReader {
 public:
  explicit BlockReader(Builder& to);

  /// Forget the variables of the program before.
  void begin_program() {
    open_.definitions.clear();
    declarations_.begin_definitions();
  }

  /// Compile a line into `block`, whose text and line are set, and set its label, in capitals.
  /// Return false if the line is empty.
  bool read(std::string_view text, Block& block, std::string& label, Link& link);

 private:
  void prepare_plain_words();
  bool plain(std::string_view text, Block& block);
  void skip_level(Block& block);
  bool number(Block& block);
  void take_label(std::string& label);

  OpenBlock open_;
  DeclarationReader declarations_;
  PlainTable plain_;
  std::uint32_t marked_at_ = 0, marked_width_ = 1;  // the slash, or the label, of the block
};

}  // namespace cncsub::sinumerik
