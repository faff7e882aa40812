#include "cncsub/motion/state/signals.hpp"

#include <algorithm>

namespace cncsub {

bool SkipLists::any() const {
  return lists != nullptr &&
         std::any_of(lists->begin(), lists->end(), [](const auto& list) { return !list.empty(); });
}

SkipsTold SkipLists::take(SignalMask signals) {
  SkipsTold told{{}, signals};
  if (lists == nullptr) return told;
  if (!taken) taken = *used;
  Next& next = *taken;
  for (std::size_t i = 0; i < next.size() && told.open != 0; ++i) {
    const SignalMask of = i == 0 ? signals : signal_bit(static_cast<int>(i)) & signals;
    const auto& list = (*lists)[i];
    if (of == 0 || next[i] >= list.size()) continue;
    told.told.push_back(list[next[i]++]);
    told.open &= ~of;
  }
  return told;
}

}  // namespace cncsub
