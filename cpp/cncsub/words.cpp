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

WrittenWord WordReader::made(WrittenWord word, const char* from, const char* to) const {
  while (to > from + 1 && is_blank(to[-1])) --to;
  word.at = static_cast<std::uint32_t>(from - block_.data());
  word.width = static_cast<std::uint32_t>(to - from);
  return word;
}

std::optional<WrittenWord> WordReader::next() {
  Scanner s{at_, block_.data() + block_.size(), block_.data()};
  const char c = s.peek();
  if (s.at == s.end) return std::nullopt;
  const char* start = s.at;
  WrittenWord word;
  Scanner behind = s;
  ++behind.at;
  const char second = behind.peek();
  const bool statement = is_letter(c) && is_letter(second);
  if (statement || c == '#') {  // the rest of the block is one
    if (!statement) word.address = "#";
    word.text = squeezed(start, s.end);
    at_ = s.end;
    return made(std::move(word), start, s.end);
  }
  ++s.at;
  if (c == '<') {
    word.address = "<";
    while (s.at != s.end && *s.at != '>') ++s.at;
    if (s.at != s.end) ++s.at;
    word.text = std::string(start, s.at);
    at_ = s.at;
    return made(std::move(word), start, s.at);
  }
  if (c == ',' && is_letter(second)) {
    word.address = std::string(",") + second;
    s.peek();
    ++s.at;
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
  at_ = s.at;
  return made(std::move(word), start, end);
}

std::vector<WrittenWord> written_words(std::string_view block) {
  std::vector<WrittenWord> words;
  WordReader reader(block);
  while (auto word = reader.next()) words.push_back(std::move(*word));
  return words;
}

}  // namespace cncsub
