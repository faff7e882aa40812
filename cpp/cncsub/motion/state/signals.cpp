#include "cncsub/motion/state/signals.hpp"

#include <algorithm>

namespace cncsub {

bool SkipLists::any() const {
  return lists != nullptr &&
         std::any_of(lists->begin(), lists->end(), [](const auto& list) { return !list.empty(); });
}

ReportedSkips SkipLists::take(SignalMask signals) {
  ReportedSkips reported{{}, signals};
  if (lists == nullptr) return reported;
  if (!taken) taken = *used;
  Next& next = *taken;
  for (std::size_t i = 0; i < next.size() && reported.open != 0; ++i) {
    const SignalMask of = i == 0 ? signals : signal_bit(static_cast<int>(i)) & signals;
    const auto& list = (*lists)[i];
    if (of == 0 || next[i] >= list.size()) continue;
    reported.reported.push_back(list[next[i]++]);
    reported.open &= ~of;
  }
  return reported;
}

}  // namespace cncsub
