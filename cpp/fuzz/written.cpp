// The law of written words: the words that people and tools see in a block are those that the
// engine reads.
#include <algorithm>
#include <bit>
#include <cmath>
#include <string_view>
#include <vector>

#include "cncsub/code/spelling.hpp"
#include "cncsub/dialect/dialect.hpp"
#include "cncsub/text/number.hpp"
#include "cncsub/text/words.hpp"
#include "laws.hpp"

namespace cncsub::fuzz {
namespace {

/// Check that the words follow each other with nothing but blanks and comments between them.
void check_places(std::string_view text, const std::vector<WrittenWord>& words) {
  const bool comments = text.find_first_of("(;)\"") != std::string_view::npos;
  std::size_t end = 0;
  const auto blank_to = [&](std::size_t to) {
    for (; end < to && !comments; ++end)  // a block of a language with statements has several lines
      claim(is_blank(text[end]) || text[end] == '\n', "no character is lost");
  };
  for (const WrittenWord& word : words) {
    claim(word.at >= end && word.at + word.width <= text.size(), "words stand in their order");
    blank_to(word.at);
    end = word.at + word.width;
  }
  blank_to(text.size());
}

/// Return whether a word belongs to a place of a block's mask: X, X1 and AX[X] of an axis, and CR
/// or TURN of a language with longer addresses.
bool is_at(const WrittenWord& word, const Spelling& spelling, int place) {
  const std::string& name = word.address;
  if (const int own = spelling.place_of(name); own >= 0) return own == place;
  const auto letter = static_cast<char>('A' + place);
  const bool numbered = name.size() > 1 && is_digit(name.back());
  return numbered ? upper(name.front()) == letter : name.ends_with(std::string({'[', letter, ']'}));
}

/// Return the last word of a place, null where there is none.
const WrittenWord* last_word(const std::vector<WrittenWord>& words, const Spelling& spelling,
                             int place) {
  const WrittenWord* last = nullptr;
  for (const WrittenWord& word : words)
    if (is_at(word, spelling, place)) last = &word;
  return last;
}

/// Check that each number of the block is the one that is written.
void check_values(const Code& code, const Block& block, const std::vector<WrittenWord>& words) {
  if (block.mask == 0) return;
  // A language may tell fewer numbers apart than a person who reads the word.
  const double near = std::max(1e-12, find_dialect(code.control->dialect)->precision);
  const Cell* cell = code.cells.data() + block.data;
  std::uint32_t expressions = 0;
  if ((block.flags & Block::kHasExtra) != 0) expressions = (cell++)->extra.expressions;
  cell += block.code_cells();
  // FA[X]=500, a feed, has the place of another letter than its axis.
  const bool indexed = std::any_of(words.begin(), words.end(), [](const WrittenWord& word) {
    return word.text.find('[') != std::string::npos;
  });
  for (std::uint32_t left = block.mask; left != 0; left &= left - 1, ++cell) {
    const int place = std::countr_zero(left);
    if (place >= 26 || (expressions >> place & 1) != 0) continue;
    const WrittenWord* word = last_word(words, *code.spelling, place);
    if (word == nullptr && indexed) continue;
    claim(word != nullptr, "a word that counts is written");
    const bool exact = std::fabs(word->value - cell->value) <= near * std::fabs(word->value);
    // A word that counts takes the whole number that is meant: L0.99999. A language that tells
    // fewer numbers apart keeps eight bits of one without a sign: L300.
    const char letter = static_cast<char>('A' + place);
    const bool bits = near > 1e-12 && cell->value >= 0 && cell->value < 256 &&
                      code.spelling->unsigned_words.find(letter) != std::string_view::npos;
    claim(!word->known || exact || bits || nearly_whole(word->value) == cell->value,
          "a word has the value that is written");
  }
}

}  // namespace

void check_words(const Code& code) {
  for (const Program& program : code.programs)
    for (Address a = program.first; a < program.last; ++a) {
      const Block& block = code.blocks[a];
      const std::string_view text = code.text_of(block, program);
      if (text.size() >= kLookedAt) continue;
      const auto words = written_words(code.read_word, text);
      check_places(text, words);
      if (is_words(block.op)) check_values(code, block, words);
    }
}

}  // namespace cncsub::fuzz
