// Memory for what is large: tables and texts of what is read, columns of what ran, arrays for
// users. A piece that one gave back the next one takes: the first touch of fresh pages costs more
// than what is written there.
#pragma once

#include <bit>
#include <cstddef>
#include <memory>
#include <new>
#include <vector>

#include "cncsub/system/memory.hpp"

namespace cncsub::system {

/// Take a piece of memory that may have been used before. One of large pages begins where a page
/// does.
void* take_memory(std::size_t bytes);
/// Keep a piece for the next taker, up to `kMostKept` bytes in all. A piece that nobody took for
/// ten seconds goes back to the system, when a later piece comes here.
void give_memory(void* memory, std::size_t bytes) noexcept;
/// Give the large pieces that are kept back to the system now: a table has grown out of them, and
/// the next reading is far away.
void give_back_large_memory() noexcept;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(CNCSUB_FUZZ)
constexpr std::size_t kMostKept = 0;  // a sanitizer is to see the end of each piece
#else
constexpr std::size_t kMostKept = std::size_t{64} << 20;
#endif

/// Pieces of fewer bytes than `kLeast` are left to malloc. `kGrows`: they come in all sizes.
template <class T, std::size_t kLeast, bool kGrows = false>
struct KeptMemory {
  using value_type = T;
  template <class U>
  struct rebind {                                 // NOLINT(readability-identifier-naming)
    using other = KeptMemory<U, kLeast, kGrows>;  // NOLINT(readability-identifier-naming)
  };

  KeptMemory() = default;
  template <class U>
  KeptMemory(const KeptMemory<U, kLeast, kGrows>&) {}  // NOLINT(misc-explicit-constructor)

  T* allocate(std::size_t count) {
    if (count > static_cast<std::size_t>(-1) / 2 / sizeof(T)) throw std::bad_array_new_length();
    const std::size_t bytes = size(count);
    return static_cast<T*>(bytes < kLeast ? ::operator new(bytes) : take_memory(bytes));
  }
  void deallocate(T* memory, std::size_t count) noexcept {
    const std::size_t bytes = size(count);
    if (bytes < kLeast)
      ::operator delete(memory);
    else
      give_memory(memory, bytes);
  }
  bool operator==(const KeptMemory&) const { return true; }

 private:
  /// Return one of few sizes, so that one piece fits for another: what is never written costs
  /// nothing.
  static std::size_t size(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    return kGrows && bytes >= kLeast && bytes < kLargePage ? std::bit_ceil(bytes) : bytes;
  }
};

/// For chunks, of which there are few sizes.
template <class T>
using ChunkMemory = KeptMemory<T, std::size_t{8} << 10>;
/// For tables that may grow to many megabytes.
template <class T>
using TableMemory = KeptMemory<T, std::size_t{64} << 10, true>;
template <class T>
using LargeVector = std::vector<T, TableMemory<T>>;

}  // namespace cncsub::system
