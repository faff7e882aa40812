// Work on many rows, shared out to threads.
#pragma once

#include <cstddef>
#include <functional>

#include "cncsub/text/interrupt_check.hpp"

namespace cncsub {

/// The rows of a piece: whole chunks of any column, and enough that sharing them out costs nothing.
constexpr std::size_t kPieceRows = std::size_t{1} << 15;

/// Call `work(first, last)` for pieces that make up all `rows`, each once: in this thread and,
/// where there are several pieces, in as many others as there are cores left. `work` writes to
/// places of its own and throws nothing. Only this thread asks `interrupt`, after each of its
/// pieces; interrupted, it leaves the rest undone.
void in_parts(std::size_t rows, InterruptCheck* interrupt,
              const std::function<void(std::size_t, std::size_t)>& work);

}  // namespace cncsub
