// A value that was read, as an operand of a call.
#pragma once

#include "cncsub/code/expression_writer.hpp"

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

}  // namespace cncsub
