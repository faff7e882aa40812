// Words that count something, or name it by its number.
#pragma once

#include <cmath>

#include "cncsub/motion/context.hpp"

namespace cncsub {

/// The value of such a word. What an expression gives is made whole as the operands of calls are.
inline double counted(MotionView m, const NcWords& words, char letter) {
  const bool rounds = m.facts.control->calls.call_values.value == CallValues::Rounded;
  const bool computed = (words.computed & bit(letter)) != 0;
  return computed && rounds ? std::round(words[letter]) : words[letter];
}

}  // namespace cncsub
