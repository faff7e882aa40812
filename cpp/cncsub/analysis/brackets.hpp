// Logic in an expression as it is written: what it stands beside, and the brackets that show the
// order of evaluation.
#pragma once

#include <string>
#include <string_view>

#include "cncsub/code/spelling.hpp"

namespace cncsub {

struct WrittenLogic {
  bool beside_other = false;  // logic joins, or is joined by, another operation without brackets
  bool and_after_or = false;  // AND joins what OR or XOR before it has joined
  std::string bracketed;      // the expression with brackets at such places; may be empty
};

/// Read an expression. `order` says how operators bind. Where `apart` is set, logic beside other
/// logic gets brackets too. There are none to offer where the text has more than operators and
/// plain values, or where brackets would stand more than `most` deep.
WrittenLogic read_logic(std::string_view written, const Spelling& spelling, LogicOrder order,
                        bool apart = false, int most = 0);

}  // namespace cncsub
