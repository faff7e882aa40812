// The lexemes of a block: what stands in it one behind the other, as it is written and whatever it
// means. The engine and the words that people and tools see are both made of these.
#pragma once

#include <cstdint>

#include "cncsub/text/scan.hpp"

namespace cncsub {

/// What is written, without its value where that is an expression.
struct Lexeme {
  enum class Kind : std::uint8_t {
    End,        // of the block
    Word,       // X10. or ,C5 or X1=10 or G: an address with its value
    Slash,      // / or /3
    Name,       // < of <NAME>, which stands behind it
    Statement,  // the # or the letter that begins an assignment, IF, GOTO: the rest of the block
    Other,      // a character that begins none of these
  };
  /// Of a word.
  enum class Value : std::uint8_t {
    None,
    Number,      // is read; it may have no digit (`X-`)
    Expression,  // stands behind the lexeme with its sign: `#1`, `-[2*#1]`
  };

  Kind kind = Kind::End;
  Value value = Value::None;
  char address = 0;       // a capital
  bool comma = false;     // ,C
  std::uint8_t axis = 0;  // X1=10: the number of the axis
  std::uint8_t skip = 0;  // of a slash: the number of its switch, 0 where none is written
  Number number;
  const char* value_at = nullptr;  // where the number begins, with its sign
  const char* at = nullptr;        // its first character
};

/// Reads the lexeme that stands here, and leaves the scanner behind it. `axes`: X1=10 is a word of
/// the first of the axes X, not of X with something behind it.
Lexeme read_lexeme(Scanner& s, bool axes);

}  // namespace cncsub
