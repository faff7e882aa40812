// The parts that the Mitsubishi controls share.
#pragma once

#include "controls/alarm_list.hpp"
#include "controls/facts.hpp"
#include "controls/settings.hpp"

namespace cncsub::mitsubishi {

using enum Evidence;

// Keys of sources.def.
inline const std::string k004 = "source 004, ";
inline const std::string kSM = "SM, ";
inline const std::string kM7 = "M7 ";
inline const std::string kSK = "SK ";
inline const std::string kIMD = "IMD, ";
inline const std::string kIMD2 = "IMD2, ";
inline const std::string kCW = "CW, ";
inline const std::string kOB = "OB, ";
inline const std::string kMZ = "MZ ";
inline const std::string kGeneral = "general knowledge";
// A default, to be changed where a machine is known to differ.
inline const std::string kPolicy = "policy: nobody says";

/// Return the M700, from which the others differ.
Control family();

/// Add the motion, which has a file of its own.
void add_family_motion(Control& c);

}  // namespace cncsub::mitsubishi
