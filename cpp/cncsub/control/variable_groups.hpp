// The groups in which variables are shown.
#pragma once

#include <string_view>

#include "cncsub/control/control.hpp"

namespace cncsub {

/// Return the group in which a variable of a kind is shown: "locals", "work offsets", ...
std::string_view group_of(VariableKind kind);

}  // namespace cncsub
