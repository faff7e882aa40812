// Groups of nodes of a graph that lead to each other, each group after those that it leads to.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

namespace cncsub {

/// Nodes from 0 and the arrows between them, the arrows of a node in one sequence.
class Arrows {
 public:
  explicit Arrows(std::size_t nodes) : first_(nodes + 1, 0) {}
  /// Take the arrows in any order.
  Arrows(std::size_t nodes, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& all);

  std::size_t nodes() const { return first_.size() - 1; }
  const std::uint32_t* begin(std::size_t node) const { return to_.data() + first_[node]; }
  const std::uint32_t* end(std::size_t node) const { return to_.data() + first_[node + 1]; }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> to_;
};

/// The groups of nodes that lead to each other.
struct Groups {
  explicit Groups(const Arrows& arrows);

  std::vector<std::uint32_t> of;                   // by node
  std::vector<std::vector<std::uint32_t>> groups;  // each after the groups that it leads to
};

}  // namespace cncsub
