// Writes the instructions of expressions.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cncsub/code/code.hpp"

namespace cncsub {

class ExpressionWriter {
 public:
  explicit ExpressionWriter(Code& code) : code_(code) {}

  /// The place of the next instruction; those of one expression follow each other.
  std::uint32_t next() const { return static_cast<std::uint32_t>(code_.instructions.size()); }
  void emit(const Instruction& instruction) { code_.instructions.push_back(instruction); }
  Instruction& instruction(std::size_t place) { return code_.instructions[place]; }
  /// Takes away the instructions from this place on.
  void take_back(std::uint32_t from) { code_.instructions.resize(from); }
  /// Where it stands: what is written from there on can be taken back.
  struct Place {
    std::size_t instructions, expressions;
  };
  Place place() const { return {code_.instructions.size(), code_.expressions.size()}; }
  void take_back(const Place& from) {
    code_.instructions.resize(from.instructions);
    code_.expressions.resize(from.expressions);
  }
  /// Ends the expression that began with instruction `first`: its number.
  std::uint32_t end(std::uint32_t first, std::uint32_t at, std::uint32_t width);
  /// An expression of one instruction: its number.
  std::uint32_t one(const Instruction& only, std::uint32_t at, std::uint32_t width);

 private:
  Code& code_;
};

}  // namespace cncsub
