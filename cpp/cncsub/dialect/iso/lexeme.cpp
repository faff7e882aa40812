#include "cncsub/dialect/iso/lexeme.hpp"

namespace cncsub {

namespace {

bool begins_expression(char c) { return c == '#' || c == '['; }

/// Return the next character. The text is searched for it only if a gap stands here.
char next_of(Scanner& s) {
  const char c = s.at == s.end ? '\0' : *s.at;
  return is_blank(c) || c == '(' ? s.peek() : c;
}

/// Return the character after the next one.
char behind_next(Scanner s) {
  ++s.at;
  return s.peek();
}

/// Return whether the number after an address is that of an axis and a part of it: X1=, Y2=.
bool is_axis(const Lexeme& word, char behind) {
  const Number& number = word.number;
  return word.address >= 'X' && word.axis == 0 && !word.comma && number.any && number.points == 0 &&
         number.value >= 1 && number.value <= 2 && behind == '=';
}

/// Read the value after the address.
void read_value(Scanner& s, Lexeme& word, bool axes) {
  const char c = next_of(s);
  const bool sign = c == '-' || c == '+';
  if (begins_expression(sign ? behind_next(s) : c)) {
    word.value = Lexeme::Value::Expression;
    return;
  }
  if (!begins_number(c)) return;
  word.value = Lexeme::Value::Number;
  word.value_at = s.at;
  word.number = scan_number(s);
  if (!axes || !is_axis(word, s.peek())) return;
  word.axis = to_whole<std::uint8_t>(word.number.value);
  word.value = Lexeme::Value::None;
  s.take('=');
  read_value(s, word, false);
}

void read_slash(Scanner& s, Lexeme& slash) {
  slash.kind = Lexeme::Kind::Slash;
  const char c = s.peek();
  if (c < '1' || c > '9') return;
  slash.skip = static_cast<std::uint8_t>(c - '0');
  ++s.at;
}

/// Return whether two letters begin a statement. After a bare G, which some controls read as G00,
/// the next word may stand: only GO begins a statement then.
bool begins_statement(char first, char behind) {
  return is_letter(behind) && (first != 'G' || behind == 'O');
}

}  // namespace

Lexeme read_lexeme(Scanner& s, bool axes) {
  Lexeme read;
  const char c = s.peek();
  if (s.at == s.end) return read;
  read.at = s.at++;
  read.address = c;
  if (is_letter(c)) {
    read.kind = Lexeme::Kind::Word;
    read_value(s, read, axes);
    if (read.value == Lexeme::Value::None && read.axis == 0 && begins_statement(c, s.peek()))
      read.kind = Lexeme::Kind::Statement;
  } else if (c == ',' && is_letter(s.peek())) {
    read.kind = Lexeme::Kind::Word;
    read.comma = true;
    read.address = s.peek();
    ++s.at;
    read_value(s, read, axes);
  } else if (c == '/') {
    read_slash(s, read);
  } else {
    read.kind = c == '#'   ? Lexeme::Kind::Statement
                : c == '<' ? Lexeme::Kind::Name
                           : Lexeme::Kind::Other;
  }
  return read;
}

}  // namespace cncsub
