// The values in the brackets of a call, and the parameters that the called program declares for
// them.
#pragma once

#include <optional>

#include "cncsub/code/code.hpp"

namespace cncsub {

/// Make the values of a call by name its arguments: each sets the local of its parameter. A
/// parameter that the call leaves out takes its own value. The programs are registered. Return why
/// the call is refused.
std::optional<Fault> pass_parameters(Code& code, CallRecord& call);

}  // namespace cncsub
