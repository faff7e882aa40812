// The words of a block as they are written, for messages, people and tools. The engine itself runs
// code.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/text/scan.hpp"

namespace cncsub {

struct WrittenWord {
  std::string address;  // "X", ",C", "#", "/"; empty for a macro statement
  bool known = false;   // the value is written as a number
  double value = 0;
  std::string text;                 // "X10."
  std::uint32_t at = 0, width = 1;  // its bytes in the block
};

/// The function of a dialect that reads the word of a block at `from` or after it, and leaves
/// `from` after the word. It returns nothing if the block has no more words.
using ReadWord = std::optional<WrittenWord> (*)(std::string_view block, std::size_t& from);

/// Give a word the value of a number; return false if the number has no digit.
bool set_number(WrittenWord& word, const Number& number);
/// Read the number that stands here as the value of a word; return false if it has no digit.
bool take_number(Scanner& s, WrittenWord& word);

/// Give a word its text and its place: the characters of its block from `from` to `to`, without
/// blanks and comments. Return where the word ends, which is never inside a character.
const char* place_word(WrittenWord& word, std::string_view block, const char* from, const char* to);

inline std::vector<WrittenWord> written_words(ReadWord read, std::string_view block) {
  std::vector<WrittenWord> words;
  std::size_t from = 0;
  while (auto word = read(block, from)) words.push_back(std::move(*word));
  return words;
}

}  // namespace cncsub
