#include "cncsub/code/word_uses.hpp"

#include <algorithm>

namespace cncsub {

namespace {

void put(std::vector<std::uint32_t>& letters, std::initializer_list<int> codes, std::uint32_t bit) {
  for (const int code : codes) {
    const auto place = static_cast<std::size_t>(code);
    letters.resize(std::max(letters.size(), place + 1));
    letters[place] |= bit;
  }
}

}  // namespace

WordUses::WordUses(std::span<const WordUse> uses) {
  for (const WordUse& use : uses) {
    const auto place = static_cast<std::size_t>(use.letter - 'A');
    checked_ |= 1u << place;
    texts_[place] = use.text;
    none_[place] = use.none;
    put(of_g_, use.g, 1u << place);
    put(of_m_, use.m, 1u << place);
  }
}

}  // namespace cncsub
