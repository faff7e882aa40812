// Brackets around what an expression joins first, so that it reads as it is done.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cncsub/code/spelling.hpp"

namespace cncsub {

/// The expression with brackets wherever logic stands beside another operation, or beside other
/// logic where `apart` says so. `order`: how operators bind. Nothing where it is no plain
/// expression, or where brackets would stand more than `most` deep.
std::optional<std::string> with_brackets(std::string_view written, const Spelling& spelling,
                                         LogicOrder order, bool apart, int most);

}  // namespace cncsub
