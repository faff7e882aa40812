// Lengths that are written without a decimal point, which many controls count in increments.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/control/g_codes.hpp"
#include "cncsub/text/interrupt_check.hpp"

namespace cncsub {

/// A whole length below this looks like millimetres, and may be meant so.
inline constexpr double kFewIncrements = 1000;

/// The lengths of a block that are written with a point, and the small ones that are not.
struct Points {
  std::uint32_t with = 0, without = 0;
};

/// Return them, as far as the words of the block show what is a length.
Points points_of(const Code& code, const Block& block, const GCodes& g_codes, MachineType machine);

/// Return whether the control counts whole lengths in its least increment.
inline bool counts_increments(const Code& code) {
  return code.control->reading.whole_numbers.value == WholeNumbers::Increments;
}

/// The lengths without a point of some programs: how many there are, and the first of them.
struct WithoutPoint {
  std::int64_t count = 0;
  Address block = kNowhere;
  char address = 0;
  double value = 0;
};

/// Count them in the marked programs; none where the control does not count them in increments.
WithoutPoint lengths_without_point(const Code& code, const std::vector<bool>& programs,
                                   const std::string& machine, InterruptCheck& interrupt);

}  // namespace cncsub
