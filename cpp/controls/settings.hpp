// How the controls' files add parameters. The rules that these set stand in
// cncsub/control/settings.hpp.
#pragma once

#include <span>

#include "cncsub/control/settings.hpp"

namespace cncsub {

/// Add a parameter and set its rules: the value of the parameter answers for them.
void add_parameter(Control& c, const Parameter& parameter);
void add_parameters(Control& c, std::span<const Parameter> parameters);

/// Add the parameters of G36 and G37 of FANUC and of the GSK 988.
void measuring_parameters(Control& c, const char* source, Evidence evidence);

}  // namespace cncsub
