// A value that was read, as an operand of a call and as one of a word.
#pragma once

#include "cncsub/code/builder.hpp"

namespace cncsub {

inline Operand operand_of(const ValueRead& value) {
  Operand operand;
  operand.kind = value.computed ? Operand::Kind::Expression : Operand::Kind::Constant;
  operand.value = value.number;
  operand.expression = value.expression;
  operand.at = value.at;
  operand.width = value.width;
  return operand;
}

inline WordValue word_of(const ValueRead& value) {
  return {value.computed, value.expression, value.number};
}

}  // namespace cncsub
