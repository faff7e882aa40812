// The part of the Haas controls that has a file of its own.
#pragma once

#include "cncsub/control/control.hpp"

namespace cncsub::haas {

/// Add the variables, by the operator's manual.
void add_family_variables(Control& c);

}  // namespace cncsub::haas
