// The expressions that fill most programs, read at once: one value, or two that + - * or / joins,
// locals, commons and numbers without blanks. What is more is the general reader's.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "cncsub/code/code.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

struct PlainExpression {
  std::array<Instruction, 3> steps;  // NOLINT: the first `count`
  std::size_t count = 0;
  const char* end = nullptr;  // where it ends in the text
  bool writable = false;      // one variable that programs write

  void add(Ins op, std::uint32_t at, double value = 0) { steps[count++] = {op, 0, at, value}; }
  bool may_be_vacant() const { return count == 1 && steps[0].op != Ins::Constant; }
};

/// The whole expression from here to the bracket behind it, or to the end of the block.
std::optional<PlainExpression> plain_expression(const Code& code, const Scanner& s);
/// The same in brackets, which end the block.
std::optional<PlainExpression> plain_bracket(const Code& code, const Scanner& s);
/// The variable whose # is at `hash`, where its number ends without doubt.
std::optional<PlainExpression> plain_variable(const Code& code, const Scanner& s,
                                              std::uint32_t hash);

}  // namespace cncsub
