// The values in the brackets of a call, and the parameters that the called program declares for
// them.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "cncsub/code/code.hpp"

namespace cncsub {

/// For what the locals are hidden that say which of its parameters a call gives, where a program
/// asks for them: one for each, of so many.
inline constexpr std::string_view kGivenParameters = "given parameters";
inline constexpr std::int32_t kMostGivenParameters = 127;

/// Make the values of a call by name its arguments: each sets the local of its parameter. A
/// parameter that the call leaves out takes its own value. `called`: the program, kNoProgram where
/// there is none. Return why the call is refused.
std::optional<Fault> pass_parameters(Code& code, CallRecord& call, std::int32_t called);

}  // namespace cncsub
