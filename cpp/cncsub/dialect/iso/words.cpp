// The words of a block as the ISO family writes them.
#include "cncsub/text/words.hpp"

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/iso/spelling.hpp"

namespace cncsub {

namespace {

/// What stands behind the character that stands here.
char second(Scanner s) {
  ++s.at;
  return s.peek();
}

/// Whether two letters begin a macro statement: GOTO, IF, WHILE. Behind a G by itself, which some
/// controls read as G00, the next word stands.
bool begins_statement(char first, char behind) {
  return is_letter(first) && is_letter(behind) && (upper(first) != 'G' || upper(behind) == 'O');
}

/// A macro statement or an assignment takes the rest of the block.
WrittenWord rest_of_block(Scanner& s) {
  WrittenWord word;
  if (*s.at == '#') word.address = "#";
  s.at = s.end;
  return word;
}

/// <NAME>
WrittenWord name(Scanner& s) {
  WrittenWord word;
  word.address = "<";
  while (s.at != s.end && *s.at != '>') ++s.at;
  if (s.at != s.end) ++s.at;
  return word;
}

/// X, `,C`, or a character that is no address, which may be of several bytes.
std::string address(Scanner& s) {
  const char* start = s.at;
  const char c = s.peek(), behind = second(s);
  ++s.at;
  if (c == ',' && is_letter(behind)) {
    s.take(behind);
    return {c, behind};
  }
  if (is_letter(c)) return {c};
  const std::string_view character = first_character({start, s.end});
  s.at = start + character.size();
  return std::string(character);
}

/// What stands behind an address that is no number: up to the next letter outside brackets.
void pass_value(Scanner& s) {
  int brackets = 0;
  for (char c = s.peek(); c != '\0'; c = s.peek()) {
    if (brackets == 0 && (is_letter(c) || c == ',' || c == '/')) return;
    if (c == '[') ++brackets;
    if (c == ']') --brackets;
    ++s.at;
  }
}

}  // namespace

const Spelling iso_spelling{{"(", ")"}, {"[", "]"}, {}};

std::optional<WrittenWord> iso_word(std::string_view block, std::size_t& from) {
  Scanner s{block.data() + from, block.data() + block.size(), block.data()};
  const char c = s.peek();
  if (s.at == s.end) return std::nullopt;
  const char* start = s.at;
  WrittenWord word;
  if (c == '#' || begins_statement(c, second(s))) {
    word = rest_of_block(s);
  } else if (c == '<') {
    word = name(s);
  } else {
    word.address = address(s);
    auto number = take_number(s, word);
    if (number && is_axis_number(word.address.front(), *number, s.peek())) {
      word.address += number->value == 1 ? '1' : '2';
      s.take('=');
      word.known = false;
      number = take_number(s, word);
    }
    if (!number) pass_value(s);
  }
  place_word(word, block, start, s.at);
  if (c == '<') word.text.assign(start, s.at);  // blanks are a part of a name
  if (!word.address.empty()) word.text[0] = upper(word.text[0]);
  from = static_cast<std::size_t>(s.at - block.data());
  return word;
}

}  // namespace cncsub
