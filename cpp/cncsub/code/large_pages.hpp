// Memory for tables of many megabytes. Where the system has large pages (Linux: madvise) they are
// asked for: a quarter of the time to read a large file goes into the first touch of small ones.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#include "cncsub/system/memory.hpp"

namespace cncsub {

template <class T>
struct LargePages {
  using value_type = T;

  LargePages() = default;
  template <class U>
  explicit LargePages(const LargePages<U>&) {}

  T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
    const std::size_t bytes = count * sizeof(T);
    if (bytes < system::kLargePage) return static_cast<T*>(::operator new(bytes));
    void* const memory = system::allocate_pages(bytes);
    if (memory == nullptr) throw std::bad_alloc();
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    if (count * sizeof(T) < system::kLargePage)
      ::operator delete(memory);
    else
      system::free_pages(memory);
  }
  bool operator==(const LargePages&) const { return true; }
};

/// A vector that may grow to many megabytes.
template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

}  // namespace cncsub
