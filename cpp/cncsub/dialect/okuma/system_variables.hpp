// The system variables that a run knows: VZOFX[3], VTOFH[5], VDIN[34].
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "cncsub/control/control.hpp"

namespace cncsub::okuma {

/// The number of V1 less 1, and of VC1.
inline constexpr std::int32_t kCommons = 0, kCommonsC = 1000;

/// A system variable. Those with an index begin at 1, or VDIN and VDOUT at their number.
struct SystemVariable {
  std::string_view name;
  std::int32_t first = 0;  // the variable of index 1, or the variable itself
  std::int32_t step = 0;   // from an index to the next one; 0: it has none
  bool readable = true, writable = true;
};

/// Return the one of this name, in capitals; null where a run does not know it.
const SystemVariable* find_system_variable(std::string_view name);
/// Return a variable as programs write it.
std::string name_of_variable(const Control& control, std::int64_t number);

}  // namespace cncsub::okuma
