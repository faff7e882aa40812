#include "cncsub/code/sequence.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace cncsub {

namespace {

/// Puts entries in the order of some bits of their numbers. Of one number the first stays the
/// first.
void sort_by(std::span<SequenceEntry> entries, int from_bit, int bits) {
  const auto part = [=](const SequenceEntry& entry) {
    return static_cast<std::uint32_t>(entry.n) >> from_bit & ((1U << bits) - 1);
  };
  const LargeVector<SequenceEntry> before(entries.begin(), entries.end());
  std::vector<std::uint32_t> places((std::size_t{1} << bits) + 1);
  for (const SequenceEntry& entry : before) ++places[part(entry) + 1];
  std::partial_sum(places.begin(), places.end(), places.begin());
  for (const SequenceEntry& entry : before) entries[places[part(entry)]++] = entry;
}

}  // namespace

/// By counting, in as few rounds as there are entries for: numbers mostly rise, again and again, so
/// that what is counted and moved lies close together.
void sort_numbers(Code& code, const Program& program, InterruptCheck& interrupt) {
  const std::span entries(code.sequence.data() + program.first_entry,
                          code.sequence.data() + program.last_entry);
  std::uint32_t numbers = 0;
  bool sorted = true;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    numbers |= static_cast<std::uint32_t>(entries[i].n);
    sorted = sorted && (i == 0 || entries[i - 1].n <= entries[i].n);
  }
  if (sorted) return;
  const int bits = std::min(static_cast<int>(std::bit_width(entries.size())), 20);
  const int all = static_cast<int>(std::bit_width(numbers));
  for (int bit = 0; bit < all && !interrupt.requested(entries.size_bytes()); bit += bits)
    sort_by(entries, bit, std::min(bits, all - bit));
}

}  // namespace cncsub
