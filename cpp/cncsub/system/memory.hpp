// Memory in whole large pages, from whichever system there is.
#pragma once

#include <cstddef>

namespace cncsub::system {

constexpr std::size_t kLargePage = std::size_t{2} << 20;

/// Whole large pages, asked for as such; null where there is no such memory.
void* allocate_pages(std::size_t bytes);
void free_pages(void* memory);
/// Asks for large pages where memory was not touched yet. It is advice: without them all goes on.
void advise_large_pages(void* memory, std::size_t bytes);

}  // namespace cncsub::system
