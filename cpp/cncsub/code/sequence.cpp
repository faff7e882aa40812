#include "cncsub/code/sequence.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <new>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "cncsub/system/cores.hpp"
#include "cncsub/text/helpers.hpp"

namespace cncsub {

namespace {

using Entries = std::span<SequenceEntry>;

constexpr std::size_t kFew = 64;                     // entries that are sorted by comparing
constexpr std::size_t kNear = std::size_t{1} << 15;  // that stay in the processor's cache meanwhile
// So many that a copy is much of what reading keeps, and a further thread worth its start. (Sorted
// in their place, they take twice as long.)
constexpr std::size_t kMany = std::size_t{1} << 21;

/// Sorts entries by number, then by address, as numbers of some bits. They are sorted in their
/// place: a copy of millions would be most of what reading keeps at its peak.
class Sorting {
 public:
  Sorting(std::uint32_t numbers, Address first, Address last)
      : first_(first), address_bits_(std::bit_width(last - first)) {
    bits_ = static_cast<int>(std::bit_width(numbers)) + address_bits_;
  }

  void sort(Entries entries, InterruptCheck& interrupt) const {
    Room room(entries.size() < kMany ? entries.size() : kNear);
    // They come by address. Few are sorted stably, so the bits of the address need no look.
    if (entries.size() < kMany) return sort_near(entries, address_bits_, bits_, room);
    const int bits = std::max(bits_ - kSplit, 0);
    const Ends ends = split(entries, bits);
    std::atomic<std::size_t> next = 0;
    const auto one = [&](Room& own) {  // false where none is left
      const std::size_t part = next.fetch_add(1, std::memory_order_relaxed);
      if (part >= kParts) return false;
      sort(entries.subspan(ends[part], ends[part + 1] - ends[part]), bits, own);
      return true;
    };
    const Helpers helpers(system::cores() - 1, [&] {
      try {
        Room own(kNear);
        while (one(own)) {
        }
      } catch (const std::bad_alloc&) {  // NOLINT: who has room does it
      }
    });
    while (one(room))
      if (interrupt.requested(entries.size_bytes() / kParts)) next = kParts;
  }

 private:
  static constexpr int kSplit = 7;  // bits by which entries are put into parts
  static constexpr std::size_t kParts = std::size_t{1} << kSplit;
  using Ends = std::array<std::size_t, kParts + 1>;
  using Room = LargeVector<SequenceEntry>;  // for as many as stay near

  std::uint64_t key(const SequenceEntry& entry) const {
    return static_cast<std::uint64_t>(entry.n) << address_bits_ | (entry.address - first_);
  }
  std::size_t digit(const SequenceEntry& entry, int from_bit, int width) const {
    return key(entry) >> from_bit & ((std::uint64_t{1} << width) - 1);
  }

  /// Sort entries that are alike but for the last bits.
  void sort(Entries entries, int bits, Room& room) const {
    if (entries.size() <= kFew) {
      std::sort(entries.begin(), entries.end(),
                [this](const auto& a, const auto& b) { return key(a) < key(b); });
    } else if (entries.size() <= kNear) {
      sort_near(entries, 0, bits, room);
    } else {
      bits = std::max(bits - kSplit, 0);
      const Ends ends = split(entries, bits);
      for (std::size_t i = 0; i < kParts; ++i)
        sort(entries.subspan(ends[i], ends[i + 1] - ends[i]), bits, room);
    }
  }

  /// Put entries into parts by the bits above the last ones; within a part they are in any order.
  Ends split(Entries entries, int from_bit) const {
    Ends ends{};
    for (const SequenceEntry& entry : entries) ++ends[digit(entry, from_bit, kSplit) + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    Ends next = ends;
    for (std::size_t part = 0; part < kParts; ++part) {
      while (next[part] < ends[part + 1]) {
        SequenceEntry held = entries[next[part]];
        for (std::size_t to = 0; (to = digit(held, from_bit, kSplit)) != part;)
          std::swap(held, entries[next[to]++]);
        entries[next[part]++] = held;
      }
    }
    return ends;
  }

  /// Sort by counting some bits, the last first, in as few rounds as there are entries for. Entries
  /// that are alike there stay in their order.
  void sort_near(Entries entries, int from_bit, int bits, Room& room) const {
    constexpr int kWidest = 20;
    const int widest = std::min(static_cast<int>(std::bit_width(entries.size())), kWidest);
    Entries from = entries, to = Entries(room).first(entries.size());
    for (int bit = from_bit, width = 0; bit < bits; bit += width) {
      width = std::min(widest, bits - bit);
      std::vector<std::uint32_t> places((std::size_t{1} << width) + 1);
      for (const SequenceEntry& entry : from) ++places[digit(entry, bit, width) + 1];
      std::partial_sum(places.begin(), places.end(), places.begin());
      for (const SequenceEntry& entry : from) to[places[digit(entry, bit, width)]++] = entry;
      std::swap(from, to);
    }
    if (from.data() != entries.data()) std::copy(from.begin(), from.end(), entries.begin());
  }

  Address first_;
  int address_bits_;
  int bits_;
};

}  // namespace

void sort_numbers(Code& code, const Program& program, InterruptCheck& interrupt) {
  const Entries entries(code.sequence.data() + program.first_entry,
                        code.sequence.data() + program.last_entry);
  std::uint32_t numbers = 0;
  Address first = kNowhere, last = 0;
  bool sorted = true;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    numbers |= static_cast<std::uint32_t>(entries[i].n);
    first = std::min(first, entries[i].address);
    last = std::max(last, entries[i].address);
    sorted = sorted && (i == 0 || entries[i - 1].n <= entries[i].n);
  }
  if (!sorted) Sorting(numbers, first, last).sort(entries, interrupt);
}

}  // namespace cncsub
