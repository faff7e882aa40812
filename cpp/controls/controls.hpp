// The controls of each maker, in listing order.
#pragma once

#include <vector>

#include "cncsub/control.hpp"

namespace cncsub {

std::vector<Control> gsk_controls();
std::vector<Control> mitsubishi_controls();
std::vector<Control> fanuc_controls();
std::vector<Control> hnc_controls();

/// Give a maker's controls their motion rules, parameters and alarms.
void add_gsk_motion(std::vector<Control>& controls);
void add_mitsubishi_motion(std::vector<Control>& controls);
void add_fanuc_motion(std::vector<Control>& controls);
void add_hnc_motion(std::vector<Control>& controls);

}  // namespace cncsub
