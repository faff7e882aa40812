#include "cncsub/code/fault_words.hpp"

#include <cmath>
#include <string_view>

#include "cncsub/text/words.hpp"

namespace cncsub {
namespace {

/// Return other addresses that may stand for these: with a comma before them, or increments of
/// their axes.
std::uint32_t others_of(std::uint32_t addresses) {
  std::uint32_t found = 0;
  for (const char letter : kCommaLetters)
    if ((addresses & bit(letter)) != 0) found |= 1u << comma_place(letter);
  for (std::size_t i = 0; i < 4; ++i)
    if ((addresses & bit("XYZC"[i])) != 0) found |= bit("UVWH"[i]);
  return found;
}

struct Finder {
  const std::vector<WrittenWord>& words;
  const Spelling& spelling;
  const GCodes* codes;

  /// Find a word. A code that is computed may be any.
  const WrittenWord* find(const WordName& name) const {
    for (const WrittenWord& word : words) {
      const int place = spelling.place_of(word.address);
      if (place >= 0 && (name.addresses >> place & 1) != 0) return &word;
      const int own = code_of_word(word.address);
      if (word.address != "G" && own < 0) continue;
      if (name.code >= 0 &&
          (own >= 0 ? own == name.code : !word.known || std::lround(word.value * 10) == name.code))
        return &word;
      if ((group_of(word) & name.groups) != 0) return &word;
    }
    return find_code(name);
  }
  /// Find a G or an M by its letter, which has no place where the language lends it to a word.
  const WrittenWord* find_code(const WordName& name) const {
    const auto is_it = [&](const WrittenWord& word) {
      return (word.address == "G" && (name.addresses & bit('G')) != 0) ||
             (word.address == "M" && (name.addresses & bit('M')) != 0);
    };
    const auto found = std::find_if(words.begin(), words.end(), is_it);
    return found == words.end() ? nullptr : &*found;
  }
  /// Return the bit of the group of a G code that does something.
  std::uint32_t group_of(const WrittenWord& word) const {
    if (codes == nullptr) return 0;
    const int own = code_of_word(word.address);
    if (own < 0 && (!word.known || std::fabs(word.value) > 1000)) return 0;
    const GCode found =
        codes->find(own >= 0 ? own : static_cast<int>(std::lround(word.value * 10)));
    const bool acts = found.meaning > Meaning::Uncomputed && found.meaning != Meaning::Unknown;
    return acts ? bit(found.group) : 0;
  }
  /// Find the code by which the block acts, else what that moves, else a G code.
  const WrittenWord* acting() const {
    for (const WordName& name :
         {WordName{.groups = bit(Group::OneShot)}, WordName{.groups = bit(Group::Motion)},
          WordName{.groups = bit(Group::Cycle)}, WordName{.addresses = kAxisWords | bit('H')},
          WordName{.addresses = kCentreWords}, WordName{.addresses = bit('G')}})
      if (const WrittenWord* word = find(name)) return word;
    for (const WrittenWord& word : words)
      if (word.address != "N" && word.address != "/" && word.address != "O") return &word;
    return nullptr;
  }
};

}  // namespace

const WrittenWord* find_word(const WordName& name, const std::vector<WrittenWord>& words,
                             const Spelling& spelling, const GCodes* codes) {
  const Finder finder{words, spelling, codes};
  const WrittenWord* word = finder.find(name);
  return word != nullptr ? word : finder.find({.addresses = others_of(name.addresses)});
}

void point_at_word(const Code& code, const GCodes& codes, Fault& fault) {
  const Block& block = code.blocks[fault.block];
  const Program& program = code.programs[static_cast<std::size_t>(code.program_at(fault.block))];
  const std::vector<WrittenWord> words = code.words_of(block, program);
  const WrittenWord* word = find_word(fault.word, words, *code.spelling, &codes);
  if (word == nullptr) word = Finder{words, *code.spelling, &codes}.acting();
  fault.at = block.text + (word == nullptr ? 0 : word->at);
  const std::uint32_t all = words.empty() ? 1 : words.back().at + words.back().width;
  fault.width = word == nullptr ? all : word->width;
}

}  // namespace cncsub
