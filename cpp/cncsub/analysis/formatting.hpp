// The layout of blocks: blanks between words, indentation, capitals and decimal points. A block
// says the same afterwards: its words are read again, and one that would be read otherwise stays as
// it is.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/text/interrupt_check.hpp"

namespace cncsub {

struct Layout {
  enum class Blanks : std::uint8_t {
    Keep,  // as they are
    One,   // one between two words
    None   // none, but around macro statements
  } blanks = Blanks::One;
  int indent = 2;  // blanks for each loop, branch and subprogram around a block; -1: as it is
  bool capitals = true;
  bool points = false;  // X10 becomes X10. in a block that moves, where that means the same
};

/// A change of a file's text: `width` bytes at `at` become `text`. It never reaches into a comment
/// between two words.
struct LayoutChange {
  std::uint32_t at = 0, width = 0;
  std::string text;
};

struct Formatted {
  std::vector<LayoutChange> changes;  // by their places
  std::vector<std::uint32_t> left;    // the lines of blocks that would be read otherwise
};

/// Return the changes of one file of the code.
Formatted format_file(const Code& code, std::uint32_t file, const Layout& layout,
                      InterruptCheck& interrupt);

}  // namespace cncsub
