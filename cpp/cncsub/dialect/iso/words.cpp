// The words of a block as the ISO family writes them: its lexemes, each with its whole value.
#include "cncsub/text/words.hpp"

#include <string_view>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/iso/lexeme.hpp"
#include "cncsub/dialect/iso/operators.hpp"

namespace cncsub {

namespace {

/// Pass over the name of an operator, or of a function after an arithmetic operator: `#1 MOD 2`,
/// `#1+SIN[30]`.
bool pass_named(Scanner& s, char before) {
  for (const std::string_view name : {"MOD", "AND", "XOR", "OR"})
    if (s.take_word(name)) return true;
  if (std::string_view("+-*/").find(before) == std::string_view::npos) return false;
  Scanner ahead = s;
  while (is_letter(ahead.peek())) ++ahead.at;
  if (ahead.peek() != '[') return false;
  s.at = ahead.at;
  return true;
}

/// Return whether a slash divides: it does before a variable and before brackets.
bool divides(Scanner s) {
  ++s.at;
  return s.peek() == '#' || s.peek() == '[';
}

/// Pass over a value that is no number, up to the next word outside brackets.
void pass_value(Scanner& s) {
  int brackets = 0;
  char before = '\0';
  for (char c = s.peek(); c != '\0'; before = c, c = s.peek()) {
    if (brackets == 0 && is_letter(c)) {
      if (!pass_named(s, before)) return;
      continue;
    }
    if (brackets == 0 && (c == ',' || c == '<' || (c == '/' && !divides(s)))) return;
    if (c == '[') ++brackets;
    if (c == ']') --brackets;
    ++s.at;
  }
}

/// Return whether arithmetic goes on after a number: `10+#1`.
bool goes_on(Scanner s) {
  const char c = s.peek();
  return c == '+' || c == '-' || c == '*' || (c == '/' && divides(s));
}

/// Return the address: X, `,C`, or X1 of an axis.
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

/// Pass over a character that begins no word and may have several bytes, and over its value.
void pass_other(Scanner& s, const char* at, WrittenWord& word) {
  word.address = first_character({at, static_cast<std::size_t>(s.end - at)});
  s.at = at + word.address.size();
  if (!take_number(s, word)) pass_value(s);
}

/// Passes over what is left of a statement, from its first character on: all of the block. Of an IF
/// with words, `IF[#1 EQ 2] THEN M98 P3`, only to the words.
void pass_statement(Scanner& s, const char* first) {
  Scanner words{first, s.end, s.file};
  s.at = s.end;
  if (!words.take_word("IF") || words.peek() != '[') return;
  int open = 0;
  for (char c = words.peek(); c != '\0'; c = words.peek()) {
    open += c == '[' ? 1 : c == ']' ? -1 : 0;
    ++words.at;
    if (open == 0) break;
  }
  words.take_word("THEN");
  Scanner ahead = words;
  if (read_lexeme(ahead, true).kind == Lexeme::Kind::Word) s.at = words.at;
}

void complete(Scanner& s, const Lexeme& read, WrittenWord& word) {
  switch (read.kind) {
    case Lexeme::Kind::Word:
      word.address = address_of(read);
      if (read.value != Lexeme::Value::Number || goes_on(s) || !set_number(word, read.number))
        pass_value(s);
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
      pass_statement(s, read.at);
  }
}

}  // namespace

// The rules that the ISO family asks.
const std::string_view iso_rules;  // empty: all rules, for they were made for it

const double iso_precision = 0;  // a number has 64 bits

const std::span<const WordUse> iso_word_uses;
const Spelling iso_spelling{.comment = {"(", ")"},
                            .value = {"[", "]"},
                            .message = {},  // statements print
                            .head = {"O", ""},
                            .operators = iso_operators,
                            .unsigned_words = "LPT",
                            .signs_by_rule = true,
                            .small_letters = false,
                            .ignores_words = true,
                            .open_comments = true};

std::optional<WrittenWord> iso_word(std::string_view block, std::size_t& from) {
  Scanner s{block.data() + from, block.data() + block.size(), block.data()};
  const Lexeme read = read_lexeme(s, true);
  if (read.kind == Lexeme::Kind::End) return std::nullopt;
  WrittenWord word;
  complete(s, read, word);
  s.at = place_word(word, block, read.at, s.at);
  if (read.kind == Lexeme::Kind::Name) word.text.assign(read.at, s.at);  // blanks are a part of it
  if (!word.address.empty()) word.text[0] = upper(word.text[0]);
  from = static_cast<std::size_t>(s.at - block.data());
  return word;
}

}  // namespace cncsub
