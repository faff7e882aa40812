// Named variables that the interpreter answers itself.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "cncsub/dialect/ngc_values.hpp"

namespace cncsub::linuxcnc {

/// Return the variable of this name; null if it is none that is answered here.
const BuiltIn* find_built_in(std::string_view name);
/// Return the names of the variables that are answered here, and of those that tell about a
/// machine.
std::vector<std::string_view> names_of_built_ins();
std::span<const std::string_view> names_of_machine();
/// Return whether the variable of this name tells about a machine, and is not answered here.
bool tells_of_machine(std::string_view name);
/// Return whether the variable of this name is either: it cannot be assigned to.
bool is_read_only(std::string_view name);

}  // namespace cncsub::linuxcnc
