// The compiler of a block of words, assignments and a message, of a call or of a statement.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cncsub/dialect/plain_words.hpp"
#include "cncsub/dialect/sinumerik/declarations.hpp"
#include "cncsub/dialect/sinumerik/iso_mode.hpp"
#include "cncsub/dialect/sinumerik/open_block.hpp"

namespace cncsub::sinumerik {

class BlockReader {
 public:
  BlockReader(Builder& to, std::vector<std::string> called_in_iso_mode);

  /// Return whether calls in ISO mode mean the program of this name.
  bool is_called_in_iso_mode(std::string_view name) const {
    return sinumerik::is_called_in_iso_mode(open_.called_in_iso_mode, name);
  }
  /// Begin a program, in ISO mode or not, and forget the variables of the one before.
  void begin_program(bool in_iso_mode) {
    open_.definitions.clear();
    open_.iso_mode = began_in_iso_mode_ = in_iso_mode;
    declarations_.begin_definitions();
  }
  /// Return whether the next block is in ISO mode.
  bool is_in_iso_mode() const { return open_.iso_mode; }

  /// Compile a line into `block`, whose text and line are set, and set its label, in capitals.
  /// Return false if the line is empty.
  bool read(std::string_view text, Block& block, std::string& label, Link& link);

 private:
  void prepare_plain_words();
  bool plain(std::string_view text, Block& block);
  void read_own(Block& block, std::string& label, Link& link);
  void hold_mode(Block& block);
  void refuse_mode(Block& block);
  void skip_level(Block& block);
  bool number(Block& block);
  void take_label(std::string& label);

  OpenBlock open_;
  DeclarationReader declarations_;
  PlainTable plain_;
  bool began_in_iso_mode_ = false;                  // the program
  std::uint32_t marked_at_ = 0, marked_width_ = 1;  // the slash, or the label, of the block
};

}  // namespace cncsub::sinumerik
