// The controls of each maker, in listing order.
#pragma once

#include <vector>

#include "cncsub/control.hpp"

namespace cncsub {

std::vector<Control> gsk_controls();
std::vector<Control> mitsubishi_controls();
std::vector<Control> fanuc_controls();
std::vector<Control> hnc_controls();

}  // namespace cncsub
