#include "cncsub/words.hpp"

#include <cmath>

#include "cncsub/scan.hpp"

namespace cncsub {

namespace {

/// What stands behind an address that is no number: up to the next letter outside brackets. The end
/// of it, `behind` where nothing stands there.
const char* pass_value(Scanner& s, const char* behind) {
  int brackets = 0;
  while (s.at != s.end) {
    const char c = s.peek();
    if (c == '\0') break;
    if (brackets == 0 && (is_letter(c) || c == ',' || c == '/')) break;
    if (c == '[') ++brackets;
    if (c == ']') --brackets;
    behind = ++s.at;
  }
  return behind;
}

std::string squeezed(const char* from, const char* to) {
  std::string text;
  bool comment = false;
  for (; from < to; ++from) {
    if (*from == '(') comment = true;
    if (!comment && !is_blank(*from)) text += *from;
    if (*from == ')') comment = false;
  }
  return text;
}

}  // namespace

std::vector<WrittenWord> written_words(const Control&, std::string_view block) {
  std::vector<WrittenWord> words;
  const auto add = [&](WrittenWord& word, const char* from, const char* to) {
    while (to > from + 1 && is_blank(to[-1])) --to;
    word.at = static_cast<std::uint32_t>(from - block.data());
    word.width = static_cast<std::uint32_t>(to - from);
    words.push_back(std::move(word));
  };
  Scanner s{block.data(), block.data() + block.size(), block.data()};
  for (;;) {
    const char c = s.peek();
    if (s.at == s.end) return words;
    const char* start = s.at;
    WrittenWord word;
    Scanner behind = s;
    ++behind.at;
    const char next = behind.peek();
    if (is_letter(c) && is_letter(next)) {  // a macro statement: the rest of the block is one
      word.text = squeezed(start, s.end);
      add(word, start, s.end);
      return words;
    }
    if (c == '#') {
      word.address = "#";
      word.text = squeezed(start, s.end);
      add(word, start, s.end);
      return words;
    }
    ++s.at;
    if (c == ',' && is_letter(next)) {
      word.address = std::string(",") + next;
      s.peek();
      ++s.at;
    } else if (c == '<') {
      word.address = "<";
      while (s.at != s.end && *s.at != '>') ++s.at;
      if (s.at != s.end) ++s.at;
      word.text = std::string(start, s.at);
      add(word, start, s.at);
      continue;
    } else {
      // A character of several bytes, which is no address, stays whole.
      while (s.at != s.end && (static_cast<unsigned char>(*s.at) & 0xC0U) == 0x80U) ++s.at;
      word.address = is_letter(c) ? std::string(1, c) : std::string(start, s.at);
    }
    const char* end = s.at;
    const char value = s.peek();
    if (is_digit(value) || value == '.' || value == '-' || value == '+') {
      const Number number = scan_number(s);
      word.known = number.any && number.points < 2 && std::fabs(number.value) < kLargest;
      word.value = number.value;
      end = number.any ? s.at : pass_value(s, s.at);
    } else {
      end = pass_value(s, end);
    }
    word.text = squeezed(start, s.at);
    if (!word.text.empty()) word.text[0] = upper(word.text[0]);
    add(word, start, end);
  }
}

}  // namespace cncsub
