// Memory for tables of many megabytes. Where the system has large pages (Linux: madvise) they are
// asked for: a quarter of the time to read a large file goes into the first touch of small ones.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <vector>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace cncsub {

constexpr std::size_t kLargePage = std::size_t{2} << 20;

/// Asks for large pages where memory was not touched yet. It is advice: without them all goes on.
inline void advise_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  void* from = memory;
  std::size_t left = bytes;
  if (std::align(kLargePage, kLargePage, from, left) != nullptr)
    madvise(from, left / kLargePage * kLargePage, MADV_HUGEPAGE);
#endif
}

template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class U>
  explicit LargePages(const LargePages<U>&) {}

  T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
    const std::size_t bytes = count * sizeof(T);
    if (bytes < kLarge) return static_cast<T*>(::operator new(bytes));
    const std::size_t whole = (bytes + kLargePage - 1) / kLargePage * kLargePage;
    void* const memory = std::aligned_alloc(kLargePage, whole);
    if (memory == nullptr) throw std::bad_alloc();
    advise_large_pages(memory, whole);
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    if (count * sizeof(T) < kLarge)
      ::operator delete(memory);
    else
      std::free(memory);
  }
  bool operator==(const LargePages&) const { return true; }

 private:
  static constexpr std::size_t kLarge = 4 * kLargePage;
};

/// A vector that may grow to many megabytes.
template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace cncsub
