// The words of a block as the ISO family writes them: its lexemes, each with all that belongs to
// it.
#include "cncsub/text/words.hpp"

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/iso/lexeme.hpp"

namespace cncsub {

namespace {

/// What stands behind an address that is no number: up to the next word outside brackets.
void pass_value(Scanner& s) {
  int brackets = 0;
  for (char c = s.peek(); c != '\0'; c = s.peek()) {
    if (brackets == 0 && (is_letter(c) || c == ',' || c == '/' || c == '<')) return;
    if (c == '[') ++brackets;
    if (c == ']') --brackets;
    ++s.at;
  }
}

/// X, `,C`, X1 of an axis.
std::string address_of(const Lexeme& read) {
  std::string address(read.comma ? "," : "");
  address += read.address;
  if (read.axis != 0) address += static_cast<char>('0' + read.axis);
  return address;
}

void pass_name(Scanner& s) {
  while (s.at != s.end && *s.at != '>') ++s.at;
  if (s.at != s.end) ++s.at;
}

/// A character that begins no word, which may be of several bytes, with what stands behind it.
void pass_other(Scanner& s, const char* at, WrittenWord& word) {
  word.address = first_character({at, s.end});
  s.at = at + word.address.size();
  if (!take_number(s, word)) pass_value(s);
}

void complete(Scanner& s, const Lexeme& read, WrittenWord& word) {
  switch (read.kind) {
    case Lexeme::Kind::Word:
      word.address = address_of(read);
      if (read.value != Lexeme::Value::Number || !set_number(word, read.number)) pass_value(s);
      return;
    case Lexeme::Kind::Slash:
      word.address = "/";
      word.known = read.skip != 0;
      word.value = read.skip;
      return;
    case Lexeme::Kind::Name:
      word.address = "<";
      return pass_name(s);
    case Lexeme::Kind::Other:
      return pass_other(s, read.at, word);
    case Lexeme::Kind::Statement:
    case Lexeme::Kind::End:
      if (read.address == '#') word.address = "#";
      s.at = s.end;
  }
}

}  // namespace

const Spelling iso_spelling{{"(", ")"}, {"[", "]"}, {}, {"O", ""}};

std::optional<WrittenWord> iso_word(std::string_view block, std::size_t& from) {
  Scanner s{block.data() + from, block.data() + block.size(), block.data()};
  const Lexeme read = read_lexeme(s, true);
  if (read.kind == Lexeme::Kind::End) return std::nullopt;
  WrittenWord word;
  complete(s, read, word);
  place_word(word, block, read.at, s.at);
  if (read.kind == Lexeme::Kind::Name) word.text.assign(read.at, s.at);  // blanks are a part of it
  if (!word.address.empty()) word.text[0] = upper(word.text[0]);
  from = static_cast<std::size_t>(s.at - block.data());
  return word;
}

}  // namespace cncsub
