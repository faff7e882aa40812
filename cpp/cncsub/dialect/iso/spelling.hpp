// What the reader of the engine and the words that tools see decide alike about the spelling of a
// word.
#pragma once

#include "cncsub/text/scan.hpp"

namespace cncsub {

/// X1= and Y2=: whether the number behind a letter is that of an axis and a part of the address.
/// `behind` is the character behind the number; the value stands behind the equals sign.
inline bool is_axis_number(char letter, const Number& number, char behind) {
  return letter >= 'X' && number.any && number.points == 0 && number.value >= 1 &&
         number.value <= 2 && behind == '=';
}

}  // namespace cncsub
