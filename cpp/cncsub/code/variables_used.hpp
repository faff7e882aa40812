// Finds the variables that a block reads and writes, from its code.
#pragma once

#include <cstdint>

#include "cncsub/code/references.hpp"

namespace cncsub {

class VariablesUsed {
 public:
  VariablesUsed(const Code& code, References& to) : code_(code), to_(to) {}

  /// List the variables that an expression reads.
  void reads(std::uint32_t expression);
  void operand(const Operand& operand);
  /// List the variables in the words of a block.
  void words(const Block& block);
  /// List the variable that an assignment writes.
  void written(const Statement& statement);
  /// List the variable that an operand names as written.
  void named_by(const Operand& operand);

  TextPlace place_of(std::uint32_t expression) const {
    const Expression of = code_.expression(expression);
    return {of.at(), of.width()};
  }

 private:
  VariableReference variable(const Instruction& of, bool local, TextPlace place) const;
  VariableReference variable(bool common, std::int32_t index, TextPlace place) const;

  const Code& code_;
  References& to_;
};

}  // namespace cncsub
