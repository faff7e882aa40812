#include "cncsub/trace/kept_memory.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>

#include "cncsub/system/memory.hpp"

namespace cncsub {

namespace {

// A sanitizer is to see the end of each piece.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(CNCSUB_FUZZ)
constexpr std::size_t kMost = 0;
#else
constexpr std::size_t kMost = kMostKept;
#endif

constexpr std::size_t kRegion =
    system::kLargePage;  // a few that are kept hold no more than this each
constexpr std::size_t kSmall = std::size_t{1} << 20;  // a run of less touches no large page

/// Memory in large pages that pieces are cut from. It is given back with the last of them.
struct Region {
  std::atomic<std::uint32_t> pieces = 1;  // those that are in use or kept, and one for `cutting`
  std::size_t cut = sizeof(Region);

  void let_go() {
    if (pieces.fetch_sub(1, std::memory_order_acq_rel) == 1) system::free_pages(this);
  }
};

/// What stands before each piece.
struct alignas(std::max_align_t) Head {
  Region* region;  // null: the piece stands alone
};

struct Free {
  Free* next;
};
struct Size {  // the pieces of one size
  std::size_t bytes = 0;
  Free* first = nullptr;
};
struct Kept {
  std::mutex mutex;       // never waited for: a fork may have left it locked
  std::size_t bytes = 0;  // that are kept
  std::size_t taken = 0;  // that were made and not given back, as far as is known
  Region* cutting = nullptr;
  std::array<Size, 16> sizes;  // there are fewer kinds of chunks

  Size* of(std::size_t wanted) {
    for (Size& size : sizes) {
      if (size.bytes == 0) size.bytes = wanted;
      if (size.bytes == wanted) return &size;
    }
    return nullptr;
  }
  void* reuse(std::size_t wanted) {
    Size* const size = of(wanted);
    if (size == nullptr || size->first == nullptr) return nullptr;
    Free* const piece = size->first;
    size->first = piece->next;
    bytes -= wanted;
    return piece;
  }
  /// A piece of a region; null where the system has no room for one.
  void* cut(std::size_t wanted) {
    const std::size_t whole =
        sizeof(Head) + (wanted + alignof(Head) - 1) / alignof(Head) * alignof(Head);
    if (cutting == nullptr || cutting->cut + whole > kRegion) {
      void* const memory = system::allocate_pages(kRegion);
      if (memory == nullptr) return nullptr;
      if (cutting != nullptr) cutting->let_go();
      cutting = new (memory) Region;
    }
    auto* const head =
        new (reinterpret_cast<std::byte*>(cutting) + cutting->cut) Head{cutting};  // NOLINT
    cutting->cut += whole;
    cutting->pieces.fetch_add(1, std::memory_order_relaxed);
    return head + 1;
  }
};

/// Never destroyed: runs may end after it would be.
Kept& kept() {
  static Kept& all = *new Kept;
  return all;
}

void* alone(std::size_t bytes) {
  return new (::operator new(sizeof(Head) + bytes)) Head{nullptr} + 1;
}

}  // namespace

void* take_memory(std::size_t bytes) {
  if (kMost == 0) return ::operator new(bytes);
  Kept& all = kept();
  const std::unique_lock lock(all.mutex, std::try_to_lock);
  if (!lock) return alone(bytes);
  if (void* const piece = all.reuse(bytes)) return piece;
  all.taken += bytes;
  void* const piece = all.taken > kSmall && bytes < kRegion / 8 ? all.cut(bytes) : nullptr;
  return piece != nullptr ? piece : alone(bytes);
}

void give_memory(void* memory, std::size_t bytes) noexcept {
  if (kMost == 0) return ::operator delete(memory);
  Head* const head = static_cast<Head*>(memory) - 1;
  {
    Kept& all = kept();
    const std::unique_lock lock(all.mutex, std::try_to_lock);
    if (Size* const size = lock ? all.of(bytes) : nullptr;
        size != nullptr && all.bytes + bytes <= kMost) {
      size->first = new (memory) Free{size->first};
      all.bytes += bytes;
      return;
    }
    if (lock) all.taken -= bytes < all.taken ? bytes : all.taken;
  }
  if (head->region != nullptr)
    head->region->let_go();
  else
    ::operator delete(head);
}

}  // namespace cncsub
