// A growing column that never moves what it holds: rows are appended to chunks of a fixed size, so
// that memory stays what the rows need, and appending is one store.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace cncsub {

template <class T>
class Column {
 public:
  static constexpr std::size_t kChunk = sizeof(T) <= 16 ? 1 << 16 : 1 << 10;

  Column() = default;
  Column(Column&&) noexcept = default;
  Column& operator=(Column&&) noexcept = default;
  Column(const Column& other) { *this = other; }
  Column& operator=(const Column& other) {
    if (this == &other) return *this;
    chunks_.clear();
    next_ = end_ = nullptr;
    const std::size_t rows = other.size();
    for (std::size_t first = 0; first < rows; first += kChunk) {
      add_chunk();
      const std::size_t count = std::min(kChunk, rows - first);
      std::copy_n(other.chunks_[first / kChunk].get(), count, chunks_.back().get());
      next_ = chunks_.back().get() + count;
    }
    return *this;
  }

  std::size_t size() const {
    return chunks_.empty() ? 0 : chunks_.size() * kChunk - static_cast<std::size_t>(end_ - next_);
  }
  void push(T value) {
    if (next_ == end_) add_chunk();
    *next_++ = value;
  }
  void pop() {
    if (next_ == chunks_.back().get()) {
      chunks_.pop_back();
      end_ = chunks_.empty() ? nullptr : chunks_.back().get() + kChunk;
      next_ = end_;
    }
    --next_;
  }
  T operator[](std::size_t row) const { return chunks_[row / kChunk][row % kChunk]; }
  T& at(std::size_t row) { return chunks_[row / kChunk][row % kChunk]; }
  T& back() { return next_[-1]; }

  /// Calls `use(pointer, count)` for each run of rows that lie together, in order.
  template <class Use>
  void for_each_run(Use&& use) const {
    std::size_t left = size();
    for (const auto& chunk : chunks_) {
      const std::size_t count = std::min(kChunk, left);
      if (count == 0) return;
      use(chunk.get(), count);
      left -= count;
    }
  }
  void clear() {
    chunks_.clear();
    next_ = end_ = nullptr;
  }

 private:
  void add_chunk() {
    chunks_.push_back(std::unique_ptr<T[]>(new T[kChunk]));
    next_ = chunks_.back().get();
    end_ = next_ + kChunk;
  }

  std::vector<std::unique_ptr<T[]>> chunks_;
  T* next_ = nullptr;
  T* end_ = nullptr;
};

}  // namespace cncsub
