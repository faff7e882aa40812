#include "cncsub/system/memory.hpp"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <ctime>

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
constexpr std::int64_t kSecond = 1'000'000'000;  // in nanoseconds
constexpr std::int64_t kSoon = 1'000'000;        // a few times what clearing a page takes

std::int64_t now(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return time.tv_sec * kSecond + time.tv_nsec;
}

std::atomic<std::int64_t> next_look = 0;

/// Return whether large pages come as soon as they can be cleared, and ask for this one. Time in
/// which others have the processor does not count. Pages that come late may come soon after a
/// second.
bool come_soon(char* page) {
  const std::int64_t when = now(CLOCK_MONOTONIC);
  if (when < next_look.load(std::memory_order_relaxed)) return false;
  const std::int64_t began = now(CLOCK_THREAD_CPUTIME_ID);
  madvise(page, kLargePage, MADV_HUGEPAGE);
  *static_cast<volatile char*>(page) = 0;
  if (now(CLOCK_THREAD_CPUTIME_ID) - began < kSoon) return true;
  next_look.store(when + kSecond, std::memory_order_relaxed);
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
