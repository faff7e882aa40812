// Named variables that the control answers itself.
#pragma once

#include <span>
#include <string_view>

#include "cncsub/dialect/ngc_values.hpp"

namespace cncsub::grblhal {

std::span<const BuiltIn> built_ins();
/// Return the names of those that tell about a machine.
std::span<const std::string_view> names_of_machine();
/// Return the variable of this name; null if it is none that is answered here.
const BuiltIn* find_built_in(std::string_view name);
/// Return whether the variable of this name tells about a machine, and is not answered here.
bool tells_of_machine(std::string_view name);
/// What the last subprogram returned, and whether it did: variables that programs write too.
inline constexpr std::string_view kReturned[] = {"_value", "_value_returned"};

}  // namespace cncsub::grblhal
