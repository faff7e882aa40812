// The OSP controls of Okuma.
#pragma once

#include "cncsub/control/control.hpp"

namespace cncsub::okuma {

/// Return the control that those of machining centers begin with.
Control family();

}  // namespace cncsub::okuma
