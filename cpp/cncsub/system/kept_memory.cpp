#include "cncsub/system/kept_memory.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <new>
#include <utility>

namespace cncsub::system {

namespace {

constexpr std::size_t kRegion = kLargePage;  // a few that are kept hold no more than this each
constexpr std::size_t kSmall = std::size_t{1} << 20;     // a run of less touches no region
constexpr std::size_t kMiddling = std::size_t{8} << 20;  // and one of less asks for no large page

using Clock = std::chrono::steady_clock;
constexpr auto kUnused = std::chrono::seconds(10);

/// Memory in large pages that pieces are cut from. It is given back with the last piece.
struct Region {
  std::atomic<std::uint32_t> pieces = 1;  // those that are in use or kept, and one for `cutting`
  std::size_t cut = sizeof(Region);

  void let_go() {
    if (pieces.fetch_sub(1, std::memory_order_acq_rel) == 1) free_pages(this);
  }
};

/// The head that stands before each small piece.
struct alignas(std::max_align_t) Head {
  Region* region;  // null: the piece stands alone
};

/// The content of a kept piece.
struct Free {
  Free* next;
  Clock::time_point since;
};
/// The kept pieces of one size, those that were given last first.
struct Size {
  std::size_t bytes = 0;
  Free* first = nullptr;

  bool is_large() const { return bytes >= kLargePage; }
  void* take() {
    Free* const piece = first;
    first = piece->next;
    return piece;
  }
};

void* alone(std::size_t bytes) {
  return new (::operator new(sizeof(Head) + bytes)) Head{nullptr} + 1;
}
void free_small(void* memory) {
  Head* const head = static_cast<Head*>(memory) - 1;
  if (head->region != nullptr)
    head->region->let_go();
  else
    ::operator delete(head);
}
void free_piece(void* memory, bool large) { large ? free_pages(memory) : free_small(memory); }

/// Return the size of a piece; large pieces come in few sizes as well.
std::size_t whole_size(std::size_t bytes) {
  if (bytes < kLargePage) return bytes;
  const std::size_t unit = std::max(kLargePage, std::bit_floor(bytes) / 8);
  return (bytes + unit - 1) / unit * unit;
}

struct Kept {
  std::mutex mutex;       // never waited for: a fork may have left it locked
  std::size_t bytes = 0;  // that are kept
  std::size_t taken = 0;  // of small pieces that were made and not given back, as far as is known
  Region* cutting = nullptr;
  Clock::time_point looked{};  // for what nobody takes
  std::array<Size, 48> sizes;  // there are fewer kinds of chunks, and of large pieces that fit in

  Size* of(std::size_t wanted) {
    Size* empty = nullptr;
    for (Size& size : sizes) {
      if (size.bytes == wanted) return &size;
      if (size.first == nullptr && empty == nullptr) empty = &size;
      if (size.bytes == 0) break;
    }
    if (empty != nullptr) empty->bytes = wanted;
    return empty;
  }
  void* reuse(std::size_t wanted) {
    Size* const size = of(wanted);
    if (size == nullptr || size->first == nullptr) return nullptr;
    bytes -= wanted;
    return size->take();
  }
  bool keep(void* memory, std::size_t given) {
    Size* const size = bytes + given <= kMostKept ? of(given) : nullptr;
    if (size == nullptr) return false;
    const Clock::time_point now = Clock::now();
    size->first = new (memory) Free{size->first, now};
    bytes += given;
    if (now - looked > kUnused) let_go_of_what_nobody_takes(now);
    return true;
  }
  void let_go_of_what_nobody_takes(Clock::time_point now) {
    looked = now;
    // The last pieces of each size are those that are kept longest.
    for (Size& size : sizes) {
      Free** at = &size.first;
      while (*at != nullptr && now - (*at)->since <= kUnused) at = &(*at)->next;
      free_from(size, *at);
    }
  }
  void let_go_of_large() {
    for (Size& size : sizes)
      if (size.is_large()) free_from(size, size.first);
  }
  void free_from(const Size& size, Free*& first) {
    for (Free* piece = std::exchange(first, nullptr); piece != nullptr;) {
      Free* const next = piece->next;
      bytes -= size.bytes;
      free_piece(piece, size.is_large());
      piece = next;
    }
  }
  /// Cut a piece from a region; return null where the system has no room for one.
  void* cut(std::size_t wanted) {
    const std::size_t whole =
        sizeof(Head) + (wanted + alignof(Head) - 1) / alignof(Head) * alignof(Head);
    if (cutting == nullptr || cutting->cut + whole > kRegion) {
      void* const memory = allocate_pages(kRegion);
      if (memory == nullptr) return nullptr;
      if (taken > kMiddling) ask_for_large_pages(memory, kRegion);
      if (cutting != nullptr) cutting->let_go();
      cutting = new (memory) Region;
    }
    auto* const head =
        new (reinterpret_cast<std::byte*>(cutting) + cutting->cut) Head{cutting};  // NOLINT
    cutting->cut += whole;
    cutting->pieces.fetch_add(1, std::memory_order_relaxed);
    return head + 1;
  }
  void* take_small(std::size_t wanted) {
    taken += wanted;
    return taken > kSmall && wanted < kRegion / 8 ? cut(wanted) : nullptr;
  }
};

/// Return the kept memory. It is never destroyed: runs may end after it would be.
Kept& kept() {
  alignas(Kept) static std::array<std::byte, sizeof(Kept)> room;
  static Kept& all = *new (room.data()) Kept;
  return all;
}

}  // namespace

void* take_memory(std::size_t bytes) {
  const bool large = bytes >= kLargePage;
  const std::size_t whole = whole_size(bytes);
  if (kMostKept != 0) {
    Kept& all = kept();
    const std::unique_lock lock(all.mutex, std::try_to_lock);
    if (lock) {
      if (void* const piece = all.reuse(whole)) return piece;
      if (void* const piece = large ? nullptr : all.take_small(whole)) return piece;
    }
  }
  if (!large) return alone(bytes);
  void* const memory = allocate_pages(whole);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void give_memory(void* memory, std::size_t bytes) noexcept {
  const bool large = bytes >= kLargePage;
  if (kMostKept != 0) {
    Kept& all = kept();
    const std::unique_lock lock(all.mutex, std::try_to_lock);
    if (lock && all.keep(memory, whole_size(bytes))) return;
    if (lock && !large) all.taken -= std::min(bytes, all.taken);
  }
  free_piece(memory, large);
}

void give_back_large_memory() noexcept {
  Kept& all = kept();
  const std::unique_lock lock(all.mutex, std::try_to_lock);
  if (lock) all.let_go_of_large();
}

}  // namespace cncsub::system
