#include "cncsub/dialect/ngc_words.hpp"

#include <string>

#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

void pass_bracket(Scanner& s) {
  if (s.peek() != '[') return;
  int open = 0;
  for (char c = s.peek(); c != '\0'; c = s.peek()) {
    open += c == '[' ? 1 : c == ']' ? -1 : 0;
    ++s.at;
    if (open == 0) return;
  }
}

/// Pass over a number, #5, #<name>, [1 + 2] or SIN[30], with its signs.
void pass_value(Scanner& s) {
  while (s.peek() == '+' || s.peek() == '-' || s.peek() == '#') ++s.at;
  if (s.peek() == '<') {
    while (s.at != s.end && *s.at != '>') ++s.at;
    if (s.at != s.end) ++s.at;
    return;
  }
  if (is_letter(s.peek())) {
    while (is_letter(s.peek())) ++s.at;
    pass_bracket(s);
    if (s.take('/')) pass_bracket(s);  // ATAN
    return;
  }
  if (s.peek() == '[') return pass_bracket(s);
  while (is_digit(s.peek()) || s.peek() == '.') ++s.at;
}

}  // namespace

std::optional<WrittenWord> ngc_word(std::string_view block, std::size_t& from,
                                    std::string_view signs) {
  Scanner s{block.data() + from, block.data() + block.size(), block.data()};
  const char c = s.peek();
  if (s.at == s.end || c == ';') return std::nullopt;
  const char* start = s.at++;
  WrittenWord word;
  if (c == 'O') {
    while (s.at != s.end && *s.at != ';') ++s.at;
  } else if (c == '#') {
    word.address = "#";
    pass_value(s);
    if (s.take('=')) pass_value(s);
  } else if (is_letter(c) || signs.find(c) != std::string_view::npos) {
    word.address = std::string(1, c);
    Scanner ahead = s;
    take_number(ahead, word);
    pass_value(s);
  } else {
    word.address = first_character({start, static_cast<std::size_t>(s.end - start)});
    s.at = start + word.address.size();
  }
  s.at = place_word(word, block, start, s.at);
  for (char& of : word.text) of = upper(of);
  from = static_cast<std::size_t>(s.at - block.data());
  return word;
}

}  // namespace cncsub
