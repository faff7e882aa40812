#include "cncsub/code/sequence.hpp"

#include <algorithm>
#include <cstddef>

namespace cncsub {

/// Pieces are sorted, then merged, so that interruption is asked between. Of one number the first
/// address comes first, as it came.
void sort_numbers(Code& code, const Program& program, InterruptCheck& interrupt) {
  const auto by_number = [](const SequenceEntry& a, const SequenceEntry& b) { return a.n < b.n; };
  const std::size_t size = program.last_entry - program.first_entry;
  const auto at = [&](std::size_t i) {
    return code.sequence.begin() +
           static_cast<std::ptrdiff_t>(program.first_entry + std::min(i, size));
  };
  if (std::is_sorted(at(0), at(size), by_number)) return;
  std::size_t piece = 1 << 16;
  for (std::size_t i = 0; i < size && !interrupt.requested(piece * InterruptCheck::kBlock);
       i += piece)
    std::stable_sort(at(i), at(i + piece), by_number);
  for (; piece < size; piece *= 2)
    for (std::size_t i = 0;
         i + piece < size && !interrupt.requested(piece * InterruptCheck::kBlock); i += 2 * piece)
      std::inplace_merge(at(i), at(i + piece), at(i + 2 * piece), by_number);
}

}  // namespace cncsub
