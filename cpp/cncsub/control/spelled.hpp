// Texts for users in the words of a control.
#pragma once

#include <string>
#include <string_view>

#include "cncsub/control/control.hpp"

namespace cncsub {

/// Write a text of a list with the words of a control in the place of what stands in braces:
/// `{end}`, what ends a main program; `{return}`, what ends a subprogram; `{end-or-return}`, all of
/// them; `{macro-call}`; `{or-vacant}`, a way out by a vacant value, or nothing where the control
/// has none.
std::string spelled(std::string_view text, const Control& control);

/// Return the code that ends a subprogram; empty where the control has none.
std::string return_code(const Control& control);

}  // namespace cncsub
