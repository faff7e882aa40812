// How the controls' files add parameters; what these set stands in cncsub/control/settings.hpp.
#pragma once

#include <span>

#include "cncsub/control/settings.hpp"

namespace cncsub {

/// Adds a parameter and lets it set its rules: what its value answers comes from it.
void add_parameter(Control& c, const Parameter& parameter);
void add_parameters(Control& c, std::span<const Parameter> parameters);

/// G36 and G37 of FANUC and of the GSK 988.
void measuring_parameters(Control& c, const char* source, Evidence evidence);

}  // namespace cncsub
