// Brackets around the operations that an expression joins first, which show the order of
// evaluation.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cncsub/code/spelling.hpp"

namespace cncsub {

/// Return the expression with brackets wherever logic stands beside another operation, or, where
/// `apart` is set, beside other logic. `order` says how operators bind. Returns nothing where the
/// text is no plain expression, or where brackets would stand more than `most` deep.
std::optional<std::string> with_brackets(std::string_view written, const Spelling& spelling,
                                         LogicOrder order, bool apart, int most);

}  // namespace cncsub
