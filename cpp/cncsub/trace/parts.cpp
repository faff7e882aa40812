#include "cncsub/trace/parts.hpp"

#include <algorithm>
#include <atomic>

#include "cncsub/system/cores.hpp"
#include "cncsub/text/helpers.hpp"

namespace cncsub {

namespace {

constexpr std::size_t kRowBytes = 8;  // that computing a row counts as, between two questions

}  // namespace

void in_parts(std::size_t rows, InterruptCheck* interrupt,
              const std::function<void(std::size_t, std::size_t)>& work) {
  const std::size_t pieces = (rows + kPieceRows - 1) / kPieceRows;
  if (pieces == 0) return;
  std::atomic<std::size_t> next = 0;
  const auto one = [&] {  // false where none is left
    const std::size_t piece = next.fetch_add(1, std::memory_order_relaxed);
    if (piece >= pieces) return false;
    work(piece * kPieceRows, std::min(rows, (piece + 1) * kPieceRows));
    return true;
  };
  const Helpers helpers(std::min(system::cores(), pieces) - 1, [&] {
    while (one()) {
    }
  });
  while (one())
    if (interrupt != nullptr && interrupt->requested(kPieceRows * kRowBytes)) next = pieces;
}

}  // namespace cncsub
