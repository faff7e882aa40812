// The lexemes of a block: its parts one after another, as they are written and whatever they mean.
// The engine and the words that people and tools see are both made of lexemes.
#pragma once

#include <cstdint>

#include "cncsub/text/scan.hpp"

namespace cncsub {

/// A lexeme as it is written, without its value if that is an expression.
struct Lexeme {
  enum class Kind : std::uint8_t {
    End,        // of the block
    Word,       // X10. or ,C5 or X1=10 or G: an address with its value
    Slash,      // / or /3
    Name,       // the < of <NAME>; the name follows it
    Statement,  // the # or the letter that begins an assignment, IF, GOTO: the rest of the block
    Other,      // a character that begins none of these
  };
  /// The value of a word.
  enum class Value : std::uint8_t {
    None,
    Number,      // has been read; it may have no digit (`X-`)
    Expression,  // follows the lexeme, with its sign: `#1`, `-[2*#1]`
  };

  Kind kind = Kind::End;
  Value value = Value::None;
  char address = 0;       // a capital
  bool comma = false;     // ,C
  std::uint8_t axis = 0;  // X1=10: the number of the axis
  std::uint8_t skip = 0;  // of a slash: the number of its switch, 0 if none is written
  Number number;
  const char* value_at = nullptr;  // where the number begins, with its sign
  const char* at = nullptr;        // its first character
};

/// Read the lexeme at `s` and leave the scanner after it. With `axes`, X1=10 is a word of the first
/// axis X, and not X with more text after it.
Lexeme read_lexeme(Scanner& s, bool axes);

}  // namespace cncsub
