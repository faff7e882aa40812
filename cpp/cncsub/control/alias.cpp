#include "cncsub/control/alias.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>

namespace cncsub {

namespace {

constexpr std::size_t kLongest = 40;  // letters of a name that may be near another one
constexpr std::size_t kMost = 3;      // names that are suggested

/// Return how many letters must be put in, taken out or changed to make one name the other.
std::size_t edits(std::string_view one, std::string_view other) {
  std::array<std::size_t, kLongest + 1> row{};
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < one.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i + 1);
    for (std::size_t k = 0; k < other.size(); ++k) {
      const std::size_t changed = diagonal + (one[i] == other[k] ? 0 : 1);
      diagonal = row[k + 1];
      row[k + 1] = std::min({changed, diagonal + 1, row[k] + 1});
    }
  }
  return row[other.size()];
}

}  // namespace

const Control* find_control(std::string_view name) {
  for (const Alias& alias : all_aliases())
    if (alias.name == name) return find_control(alias.control);
  for (const Control& control : all_controls())
    if (control.name == name) return &control;
  return nullptr;
}

std::vector<std::string_view> names_near(std::string_view name) {
  std::vector<std::pair<std::size_t, std::string_view>> near;
  const auto take = [&](std::string_view known) {
    if (name.size() > kLongest || known.size() > kLongest) return;
    const std::size_t apart = edits(name, known);
    if (2 * apart <= std::min(name.size(), known.size())) near.emplace_back(apart, known);
  };
  for (const Control& control : all_controls()) take(control.name);
  for (const Alias& alias : all_aliases()) take(alias.name);
  std::stable_sort(near.begin(), near.end(),
                   [](const auto& one, const auto& other) { return one.first < other.first; });
  std::vector<std::string_view> names;
  for (const auto& [apart, known] : near)
    if (names.size() < kMost) names.push_back(known);
  return names;
}

}  // namespace cncsub
