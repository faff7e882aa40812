#include "cncsub/system/memory.hpp"

#include <cstdlib>
#include <memory>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif
#ifdef _WIN32
#include <malloc.h>
#endif

namespace cncsub::system {

void* allocate_pages(std::size_t bytes) {
  const std::size_t whole = (bytes + kLargePage - 1) / kLargePage * kLargePage;
#ifdef _WIN32
  void* const memory = _aligned_malloc(whole, kLargePage);
#else
  void* const memory = std::aligned_alloc(kLargePage, whole);
#endif
  if (memory != nullptr) advise_large_pages(memory, whole);
  return memory;
}

void free_pages(void* memory) {
#ifdef _WIN32
  _aligned_free(memory);
#else
  std::free(memory);
#endif
}

void advise_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  void* from = memory;
  std::size_t left = bytes;
  if (std::align(kLargePage, kLargePage, from, left) != nullptr)
    madvise(from, left / kLargePage * kLargePage, MADV_HUGEPAGE);
#endif
}

}  // namespace cncsub::system
