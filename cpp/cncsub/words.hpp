// The words of a block as they are written, for people and tools; the engine itself reads blocks as
// code.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cncsub {

struct WrittenWord {
  std::string address;  // "X", ",C", "#", "/"; empty for a macro statement
  bool known = false;   // the value is written as a number
  double value = 0;
  std::string text;                 // "X10."
  std::uint32_t at = 0, width = 1;  // the bytes of the block
};

/// The words of a block, one after the other.
class WordReader {
 public:
  explicit WordReader(std::string_view block) : at_(block.data()), block_(block) {}
  std::optional<WrittenWord> next();

 private:
  WrittenWord made(WrittenWord word, const char* from, const char* to) const;

  const char* at_;
  std::string_view block_;
};

std::vector<WrittenWord> written_words(std::string_view block);

}  // namespace cncsub
