#include "cncsub/analysis/groups.hpp"

#include <algorithm>
#include <limits>

namespace cncsub {

Arrows::Arrows(std::size_t nodes, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& all)
    : first_(nodes + 1, 0), to_(all.size()) {
  for (const auto& [from, to] : all) ++first_[from + 1];
  for (std::size_t i = 0; i < nodes; ++i) first_[i + 1] += first_[i];
  std::vector<std::size_t> place(first_.begin(), first_.end() - 1);
  for (const auto& [from, to] : all) to_[place[from]++] = to;
}

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Tarjan's algorithm without recursion, because chains may be long.
class Walk {
 public:
  Walk(const Arrows& arrows, Groups& to)
      : arrows_(arrows),
        to_(to),
        index_(arrows.nodes(), kNone),
        low_(arrows.nodes()),
        next_(arrows.nodes()) {}

  void from(std::uint32_t root) {
    if (index_[root] != kNone) return;
    enter(root);
    while (!open_.empty()) step();
  }

 private:
  void enter(std::uint32_t node) {
    index_[node] = low_[node] = count_++;
    next_[node] = arrows_.begin(node);
    open_.push_back(node);
    waiting_.push_back(node);
  }
  void step() {
    const std::uint32_t node = open_.back();
    while (next_[node] != arrows_.end(node)) {
      const std::uint32_t to = *next_[node]++;
      if (index_[to] == kNone) return enter(to);
      if (to_.of[to] == kNone) low_[node] = std::min(low_[node], index_[to]);
    }
    open_.pop_back();
    if (!open_.empty()) low_[open_.back()] = std::min(low_[open_.back()], low_[node]);
    if (low_[node] == index_[node]) close(node);
  }
  void close(std::uint32_t node) {
    const auto group = static_cast<std::uint32_t>(to_.groups.size());
    to_.groups.emplace_back();
    std::uint32_t member = kNone;
    while (member != node) {
      member = waiting_.back();
      waiting_.pop_back();
      to_.of[member] = group;
      to_.groups.back().push_back(member);
    }
    std::sort(to_.groups.back().begin(), to_.groups.back().end());
  }

  const Arrows& arrows_;
  Groups& to_;
  std::uint32_t count_ = 0;
  std::vector<std::uint32_t> index_, low_;
  std::vector<const std::uint32_t*> next_;
  std::vector<std::uint32_t> open_, waiting_;
};

}  // namespace

Groups::Groups(const Arrows& arrows) : of(arrows.nodes(), kNone) {
  Walk walk(arrows, *this);
  for (std::uint32_t node = 0; node < arrows.nodes(); ++node) walk.from(node);
}

}  // namespace cncsub
