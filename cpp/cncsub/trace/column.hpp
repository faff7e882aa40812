// Growing columns that never move what they hold: rows are appended to chunks of a fixed size, so
// that memory stays what the rows need, and appending is one store. Copies share their chunks until
// one of them writes, so that copying a long column costs as much as copying a short one.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "cncsub/system/kept_memory.hpp"

namespace cncsub {

/// Return whether nobody else holds this. What another thread did with its copy before it let go of
/// it then comes before what is done here.
template <class T>
bool is_sole_owner(const std::shared_ptr<T>& pointer) {
  if (pointer.use_count() != 1) return false;
  std::atomic_thread_fence(std::memory_order_acquire);
  return true;
}

/// The chunks of a column. Copies share them; whoever writes asks for a chunk of its own.
template <class Chunk>
class Chunks {
 public:
  std::size_t size() const { return list_ ? list_->size() : 0; }
  const Chunk& operator[](std::size_t index) const { return *(*list_)[index]; }

  /// Return a chunk to write to. It is copied first where a copy of the column holds it as well.
  Chunk& own(std::size_t index) {
    std::shared_ptr<Chunk>& chunk = own_list()[index];
    if (!is_sole_owner(chunk))
      chunk = std::allocate_shared<Chunk>(system::ChunkMemory<Chunk>(), *chunk);
    return *chunk;
  }
  Chunk& add() {
    List& list = own_list();
    list.push_back(std::allocate_shared_for_overwrite<Chunk>(system::ChunkMemory<Chunk>()));
    return *list.back();
  }
  void keep(std::size_t count) {
    if (count < size()) own_list().resize(count);
  }

 private:
  using List = std::vector<std::shared_ptr<Chunk>>;

  List& own_list() {
    if (!list_)
      list_ = std::make_shared<List>();
    else if (!is_sole_owner(list_))
      list_ = std::make_shared<List>(*list_);
    return *list_;
  }

  std::shared_ptr<List> list_;
};

/// The rows of a chunk. Rows that are trivially copyable are not initialised: whoever appends a row
/// writes it.
template <class T, std::size_t Size, bool = std::is_trivially_copyable_v<T>>
struct ChunkRows {
  T rows[Size];
};
template <class T, std::size_t Size>
struct ChunkRows<T, Size, true> {
  ChunkRows() {}  // NOLINT(modernize-use-equals-default): a default one would be deleted
  union {
    T rows[Size];
  };
};

template <class T>
class Column {
 public:
#ifdef CNCSUB_FUZZ  // small, so that short runs reach the ends of chunks
  static constexpr std::size_t kChunk = 64;
#else
  static constexpr std::size_t kChunk = sizeof(T) <= 16 ? 1 << 13 : 1 << 8;
#endif

  Column() = default;
  Column(Column&& other) noexcept { swap(other); }
  Column& operator=(Column&& other) noexcept {
    swap(other);
    return *this;
  }
  /// The copy finds no room in the last chunk, which the other column goes on filling.
  Column(const Column& other)
      : chunks_(other.chunks_), tail_(other.tail_), next_(other.next_), end_(other.next_) {}
  Column& operator=(const Column& other) {
    if (this != &other) *this = Column(other);
    return *this;
  }
  ~Column() = default;

  std::size_t size() const {
    return chunks_.size() == 0
               ? 0
               : (chunks_.size() - 1) * kChunk + static_cast<std::size_t>(next_ - tail_);
  }
  bool empty() const { return chunks_.size() == 0; }
  void push(T value) {
    if (next_ == end_) grow();
    *next_++ = std::move(value);
  }
  /// Return the place of a new row, to be written by parts. A row that is put together elsewhere is
  /// read back with wider loads than it was stored, which store forwarding cannot serve.
  T& next() {
    if (next_ == end_) grow();
    return *next_++;
  }
  /// Forget the rows from `rows` on.
  void keep(std::size_t rows) {
    if (rows >= size()) return;
    chunks_.keep((rows + kChunk - 1) / kChunk);
    tail_ = next_ = end_ = nullptr;
    if (rows > 0) open_tail(rows - (chunks_.size() - 1) * kChunk);
  }
  const T& operator[](std::size_t row) const { return chunks_[row / kChunk].rows[row % kChunk]; }
  const T& back() const { return next_[-1]; }
  /// Return a row to write to.
  T& at(std::size_t row) {
    Chunk& chunk = chunks_.own(row / kChunk);
    if (row / kChunk == chunks_.size() - 1 && chunk.rows != tail_)
      open_tail(static_cast<std::size_t>(next_ - tail_));
    return chunk.rows[row % kChunk];
  }

  /// Call `use(pointer, count)` for each run of rows of [first, last) that lie together, in order.
  template <class Use>
  void for_each_run(std::size_t first, std::size_t last, Use&& use) const {
    while (first < last) {
      const std::size_t place = first % kChunk, count = std::min(kChunk - place, last - first);
      use(chunks_[first / kChunk].rows + place, count);
      first += count;
    }
  }
  std::size_t bytes() const { return chunks_.size() * sizeof(Chunk); }

 private:
  using Chunk = ChunkRows<T, kChunk>;

  void swap(Column& other) noexcept {
    std::swap(chunks_, other.chunks_);
    std::swap(tail_, other.tail_);
    std::swap(next_, other.next_);
    std::swap(end_, other.end_);
  }
  void open_tail(std::size_t rows) {
    tail_ = chunks_.own(chunks_.size() - 1).rows;
    next_ = tail_ + rows;
    end_ = tail_ + kChunk;
  }
  void grow() {
    const auto rows = static_cast<std::size_t>(next_ - tail_);
    if (chunks_.size() > 0 && rows < kChunk) {
      open_tail(rows);
    } else {
      chunks_.add();
      open_tail(0);
    }
  }

  Chunks<Chunk> chunks_;
  T* tail_ = nullptr;  // the last chunk
  T* next_ = nullptr;
  T* end_ = nullptr;
};

}  // namespace cncsub
