#include "cncsub/text/words.hpp"

#include <cmath>

namespace cncsub {

bool set_number(WrittenWord& word, const Number& number) {
  word.known = number.any && number.points < 2 && std::fabs(number.value) < kLargest;
  word.value = number.value;
  return number.any;
}

bool take_number(Scanner& s, WrittenWord& word) {
  if (!begins_number(s.peek())) return false;
  return set_number(word, scan_number(s));
}

const char* place_word(WrittenWord& word, std::string_view block, const char* from,
                       const char* to) {
  to = block.data() + end_of_character(block, static_cast<std::size_t>(to - block.data()));
  const char* end = from + 1;
  bool comment = false;
  word.text.clear();
  for (const char* c = from; c < to; ++c) {
    if (*c == '(') comment = true;
    if (!comment && !is_blank(*c)) {
      word.text += *c;
      end = c + 1;
    }
    if (*c == ')') comment = false;
  }
  word.at = static_cast<std::uint32_t>(from - block.data());
  word.width = static_cast<std::uint32_t>(end - from);
  return to;
}

}  // namespace cncsub
