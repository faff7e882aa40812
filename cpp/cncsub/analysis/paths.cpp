#include "cncsub/analysis/paths.hpp"

#include <algorithm>
#include <cstddef>

namespace cncsub {

namespace {

/// The paths of a program from one block to its ends, and the blocks that all of them pass.
class Paths {
 public:
  Paths(const Checker& c, const ProgramFlow& flow, Address start)
      : c_(c), flow_(flow), from_(flow.size() + 1, kNowhere), on_path_(flow.size() + 1, kNowhere) {
    find_one(start);
  }
  std::vector<bool> passed();

 private:
  bool is_end(Address at) const {
    return at >= flow_.last() || flow_.returns(at) || flow_.ends(at);
  }
  Address& from(Address at) { return from_[place(at)]; }
  std::size_t place(Address at) const {
    return std::min<std::size_t>(at - flow_.first(), flow_.size());
  }
  void find_one(Address start);
  std::size_t reach_from(Address at);

  const Checker& c_;
  const ProgramFlow& flow_;
  std::vector<Address> from_;     // by block: the one before it, of the path that was found
  std::vector<Address> on_path_;  // by block: its place on that path
  std::vector<Address> path_;     // from the start to an end; empty: none ends
};

void Paths::find_one(Address start) {
  std::vector<Address> waiting{start};
  from(start) = start;
  while (!waiting.empty() && !c_.over()) {
    const Address at = waiting.back();
    waiting.pop_back();
    if (is_end(at)) {
      for (Address on = at;; on = from(on)) {
        path_.push_back(on);
        if (on == start) break;
      }
      std::reverse(path_.begin(), path_.end());
      for (std::size_t i = 0; i < path_.size(); ++i)
        on_path_[place(path_[i])] = static_cast<Address>(i);
      return;
    }
    for (const Exit* exit = flow_.begin(at); exit != flow_.end(at); ++exit)
      if (from(exit->to) == kNowhere) from(exit->to) = at, waiting.push_back(exit->to);
  }
}

/// Return how far along the path one comes from a block of it through blocks beside it, each of
/// which is passed once in all.
std::size_t Paths::reach_from(Address at) {
  constexpr Address kSeen = kNowhere - 1;
  std::size_t furthest = 0;
  std::vector<Address> waiting{at};
  while (!waiting.empty() && !c_.over()) {
    const Address block = waiting.back();
    waiting.pop_back();
    for (const Exit* exit = flow_.begin(block); exit != flow_.end(block); ++exit) {
      Address& on = on_path_[place(exit->to)];
      if (on < kSeen) {
        furthest = std::max<std::size_t>(furthest, on);
      } else if (is_end(exit->to)) {
        furthest = path_.size();
      } else if (on == kNowhere) {
        on = kSeen;
        waiting.push_back(exit->to);
      }
    }
  }
  return furthest;
}

std::vector<bool> Paths::passed() {
  std::vector<bool> all(flow_.size() + 1, path_.empty());
  std::size_t furthest = 0;
  for (std::size_t i = 0; i < path_.size(); ++i) {
    if (furthest <= i) all[place(path_[i])] = true;
    if (i + 1 < path_.size()) furthest = std::max(furthest, reach_from(path_[i]));
  }
  return all;
}

}  // namespace

std::vector<bool> passed_by_all(const Checker& c, const ProgramFlow& flow, Address start) {
  return Paths(c, flow, start).passed();
}

}  // namespace cncsub
