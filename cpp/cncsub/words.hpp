// The words of a block as they are written, for people and tools; the engine itself reads blocks as
// code.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control.hpp"

namespace cncsub {

struct WrittenWord {
  std::string address;  // "X", ",C", "#", "/"; empty for a macro statement
  bool known = false;   // the value is written as a number
  double value = 0;
  std::string text;                 // "X10."
  std::uint32_t at = 0, width = 1;  // the bytes of the block
};

std::vector<WrittenWord> written_words(const Control& control, std::string_view block);

}  // namespace cncsub
