// The codes of the G groups by their places: G[8]=2 and $P_GG[8] count so.
#pragma once

#include <vector>

namespace cncsub::sinumerik {

inline constexpr int kNoCode = -1;  // a code that is not computed

/// The codes of a G group in their order, ten times each.
struct CodesOfGroup {
  int number;
  std::vector<int> codes;
};

/// Return the codes of a group on which a path depends; null for any other group.
const CodesOfGroup* codes_of_group(int number);

}  // namespace cncsub::sinumerik
