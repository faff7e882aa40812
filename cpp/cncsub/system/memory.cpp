#include "cncsub/system/memory.hpp"

#include <atomic>
#include <chrono>
#include <cstdlib>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif
#ifdef _WIN32
#include <malloc.h>
#endif

namespace cncsub::system {

namespace {

constexpr std::size_t kMany = 4 * kLargePage;  // worth a look at what the first of them takes

#ifdef MADV_HUGEPAGE
using Clock = std::chrono::steady_clock;

constexpr auto kSoon = std::chrono::milliseconds(1);  // four times what clearing a page takes
constexpr auto kLook = std::chrono::seconds(1);       // after which they may come soon again

std::atomic<Clock::rep> next_look = Clock::time_point::min().time_since_epoch().count();

/// Whether large pages come as soon as they can be cleared, this one as well.
bool come_soon(char* page) {
  const Clock::time_point began = Clock::now();
  if (began.time_since_epoch().count() < next_look.load(std::memory_order_relaxed)) return false;
  madvise(page, kLargePage, MADV_HUGEPAGE);
  *static_cast<volatile char*>(page) = 0;
  const Clock::time_point ended = Clock::now();
  if (ended - began < kSoon) return true;
  next_look.store((ended + kLook).time_since_epoch().count(), std::memory_order_relaxed);
  return false;
}
#endif

}  // namespace

void* allocate_pages(std::size_t bytes) {
  const std::size_t whole = (bytes + kLargePage - 1) / kLargePage * kLargePage;
#ifdef _WIN32
  void* const memory = _aligned_malloc(whole, kLargePage);
#else
  void* const memory = std::aligned_alloc(kLargePage, whole);
#endif
  if (memory != nullptr && whole >= kMany) ask_for_large_pages(memory, whole);
  return memory;
}

void free_pages(void* memory) {
#ifdef _WIN32
  _aligned_free(memory);
#else
  std::free(memory);
#endif
}

void ask_for_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  char* const first = static_cast<char*>(memory);
  if (come_soon(first) && bytes > kLargePage)
    madvise(first + kLargePage, bytes - kLargePage, MADV_HUGEPAGE);
#endif
}

}  // namespace cncsub::system
