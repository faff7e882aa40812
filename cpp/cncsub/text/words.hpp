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

/// A piece of a block: a word, or what stands between two words. The tokens of a block one after
/// the other are its text, byte by byte.
struct BlockToken {
  enum class Kind : std::uint8_t { Word, Comment, Blank, Ignored } kind = Kind::Word;
  std::uint32_t at = 0, width = 0;  // the bytes of the block
  WrittenWord word;                 // of Kind::Word
};
std::string_view to_string(BlockToken::Kind kind);

/// Cuts a block into its tokens, one at a time.
class TokenReader {
 public:
  TokenReader(ReadWord read, std::string_view block) : read_(read), block_(block) {}

  /// Return the next token; nothing at the end of the block.
  std::optional<BlockToken> next();

 private:
  ReadWord read_;
  std::string_view block_;
  std::size_t from_ = 0;             // where the next word is looked for
  std::size_t done_ = 0;             // the end of the last token
  std::optional<WrittenWord> word_;  // the next word, where it was read already
  bool ended_ = false;               // there is no further word
};

inline std::vector<WrittenWord> written_words(ReadWord read, std::string_view block) {
  std::vector<WrittenWord> words;
  std::size_t from = 0;
  while (auto word = read(block, from)) words.push_back(std::move(*word));
  return words;
}

}  // namespace cncsub
