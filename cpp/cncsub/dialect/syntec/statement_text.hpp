// Parts of the text of a statement.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "cncsub/code/expression.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub::syntec {

/// Take a word of letters that stands here whole.
bool take_whole(Scanner& s, std::string_view word);

/// Go to behind a word, or to the end of the statement where it does not come.
void go_behind(Scanner& s, std::string_view word);

/// Return the place of the semicolon that ends the statement here, or the end of the text.
const char* end_of_statement(const Scanner& s);

/// Return how wide the text from a place to here is.
std::uint32_t width_to(const Scanner& s, std::uint32_t from);

/// Return the value of an expression that is a number and nothing else.
std::optional<double> constant_of(const Expression& of);

}  // namespace cncsub::syntec
