// Words that count something, or name it by its number.
#pragma once

#include <cmath>

#include "cncsub/motion/context.hpp"

namespace cncsub {

/// The value of such a word, made whole as the operands of calls are. What is written as a number
/// counts as what an expression gives: `flatten` writes one for the other.
inline double counted(MotionView m, const NcWords& words, char letter) {
  const bool rounds = m.facts.control->calls.call_values.value == CallValues::Rounded;
  return rounds ? std::round(words[letter]) : words[letter];
}

}  // namespace cncsub
