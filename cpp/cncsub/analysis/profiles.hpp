// The blocks of the profiles that G70 to G73 of a lathe name by P and Q, found without a run.
#pragma once

#include <cstdint>

#include "cncsub/code/code.hpp"
#include "cncsub/control/g_codes.hpp"

namespace cncsub {

/// The profile that a cycle names: -1 for a word that is computed, kNowhere for a block that its
/// program does not have.
struct NamedProfile {
  std::int64_t p = -1, q = -1;
  Address first = kNowhere, last = kNowhere;
};

/// Return whether a block cuts along the blocks from that of P to that of Q.
bool cuts_profile(const Code& code, const GCodes& codes, const Block& block);
/// Return the profile of such a block: from the block of P, the nearest after the cycle, to that of
/// Q.
NamedProfile profile_of(const Code& code, const Program& program, Address at);

}  // namespace cncsub
