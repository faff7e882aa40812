// Memory in whole large pages, from whichever system there is.
#pragma once

#include <cstddef>

namespace cncsub::system {

constexpr std::size_t kLargePage = std::size_t{2} << 20;

/// Allocate whole large pages of memory, asked for as such where there are many of them. Return
/// null where there is no such memory.
void* allocate_pages(std::size_t bytes);
void free_pages(void* memory);
/// Ask for large pages, at a place where one begins, in memory that was not touched yet. It is
/// advice: without them all goes on. The first page is touched, to see whether it pays: a virtual
/// machine may wait ten times as long for large pages as for small ones, where its host took back
/// what was not used. Then nobody asks for any more for a second.
void ask_for_large_pages(void* memory, std::size_t bytes);

}  // namespace cncsub::system
