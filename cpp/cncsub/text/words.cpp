#include "cncsub/text/words.hpp"

#include <cmath>

namespace cncsub {

std::optional<Number> take_number(Scanner& s, WrittenWord& word) {
  const char first = s.peek();
  if (!is_digit(first) && first != '.' && first != '-' && first != '+') return std::nullopt;
  const Number number = scan_number(s);
  word.known = number.any && number.points < 2 && std::fabs(number.value) < kLargest;
  word.value = number.value;
  if (!number.any) return std::nullopt;
  return number;
}

void place_word(WrittenWord& word, std::string_view block, const char* from, const char* to) {
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
}

}  // namespace cncsub
