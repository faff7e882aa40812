// Expressions that stand in no program: the conditions of breakpoints, and what a debugger shows.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "cncsub/code/code.hpp"

namespace cncsub {

/// What the value of an expression is.
enum class ValueType : std::uint8_t { Number, Text, Axis, Frame };

/// Expressions that were compiled beside the programs of a library.
struct ExpressionList {
  struct One {
    std::uint32_t expression = 0;  // of `code`
    ValueType type = ValueType::Number;
    Address block = 0;           // where its text stands
    std::optional<Fault> fault;  // why the text is no expression
  };

  std::shared_ptr<const Code> code;  // the programs, and one more that holds the texts
  std::vector<One> list;
};

}  // namespace cncsub
