#include "cncsub/trace/kept_memory.hpp"

#include <array>
#include <mutex>

namespace cncsub {

namespace {

// A sanitizer is to see the end of each piece.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(CNCSUB_FUZZ)
constexpr std::size_t kMost = 0;
#else
constexpr std::size_t kMost = kMostKept;
#endif

struct Free {
  Free* next;
};
struct Size {  // the pieces of one size
  std::size_t bytes = 0;
  Free* first = nullptr;
};
struct Kept {
  std::mutex mutex;  // never waited for: a fork may have left it locked
  std::size_t bytes = 0;
  std::array<Size, 16> sizes;  // there are fewer kinds of chunks

  Size* of(std::size_t wanted) {
    for (Size& size : sizes) {
      if (size.bytes == 0) size.bytes = wanted;
      if (size.bytes == wanted) return &size;
    }
    return nullptr;
  }
};

/// Never destroyed: runs may end after it would be.
Kept& kept() {
  static Kept& all = *new Kept;
  return all;
}

}  // namespace

void* take_memory(std::size_t bytes) {
  if (kMost > 0) {
    Kept& all = kept();
    const std::unique_lock lock(all.mutex, std::try_to_lock);
    if (Size* const size = lock ? all.of(bytes) : nullptr;
        size != nullptr && size->first != nullptr) {
      Free* const piece = size->first;
      size->first = piece->next;
      all.bytes -= bytes;
      return piece;
    }
  }
  return ::operator new(bytes);
}

void give_memory(void* memory, std::size_t bytes) noexcept {
  if (kMost > 0) {
    Kept& all = kept();
    const std::unique_lock lock(all.mutex, std::try_to_lock);
    if (Size* const size = lock ? all.of(bytes) : nullptr;
        size != nullptr && all.bytes + bytes <= kMost) {
      size->first = new (memory) Free{size->first};
      all.bytes += bytes;
      return;
    }
  }
  ::operator delete(memory);
}

}  // namespace cncsub
