// Memory for the chunks of columns. What one run gave back the next one takes: the first touch of
// fresh pages costs more than the rows that are written there.
#pragma once

#include <cstddef>
#include <memory>
#include <new>

namespace cncsub {

/// A piece of memory that may have been used before.
void* take_memory(std::size_t bytes);
/// Keeps it for the next one, up to `kMostKept` bytes in all.
void give_memory(void* memory, std::size_t bytes) noexcept;

constexpr std::size_t kMostKept = std::size_t{64} << 20;
constexpr std::size_t kLeastKept = std::size_t{8} << 10;  // smaller pieces are left to malloc

template <class T>
struct KeptMemory {
  using value_type = T;

  KeptMemory() = default;
  template <class U>
  KeptMemory(const KeptMemory<U>&) {}  // NOLINT(misc-explicit-constructor): as allocators are

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    return static_cast<T*>(bytes < kLeastKept ? ::operator new(bytes) : take_memory(bytes));
  }
  void deallocate(T* memory, std::size_t count) noexcept {
    const std::size_t bytes = count * sizeof(T);
    if (bytes < kLeastKept)
      ::operator delete(memory);
    else
      give_memory(memory, bytes);
  }
  bool operator==(const KeptMemory&) const { return true; }
};

}  // namespace cncsub
