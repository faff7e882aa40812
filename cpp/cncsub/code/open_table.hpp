// A table of the code that is written at its end before it is known which of the rows count.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>

#include "cncsub/system/kept_memory.hpp"

namespace cncsub {

template <class T>
class OpenTable {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  OpenTable() = default;
  OpenTable(const OpenTable& other) { append(other); }
  OpenTable(OpenTable&& other) noexcept { swap(other); }
  OpenTable& operator=(OpenTable other) noexcept {
    swap(other);
    return *this;
  }
  ~OpenTable() {
    if (data_ != nullptr) Memory().deallocate(data_, capacity_);
  }

  std::size_t size() const { return size_; }
  const T* data() const { return data_; }
  T& operator[](std::size_t index) { return data_[index]; }
  const T& operator[](std::size_t index) const { return data_[index]; }

  /// Return where the next rows go, with room for so many; it holds until more room is asked for.
  T* room(std::size_t count) {
    if (capacity_ - size_ < count) grow(size_ + count);
    return data_ + size_;
  }
  /// Make so many of the rows that were written there count.
  void add(std::size_t count) { size_ += count; }
  void append(const OpenTable& other) {
    if (other.size_ == 0) return;
    std::memcpy(static_cast<void*>(room(other.size_)), other.data_, other.size_ * sizeof(T));
    add(other.size_);
  }
  /// Forget the rows from this one on.
  void keep(std::size_t count) { size_ = count; }
  void clear() { size_ = 0; }
  void reserve(std::size_t count) {
    if (count > capacity_) move_to(count);
  }

 private:
  using Memory = system::TableMemory<T>;
  static constexpr std::size_t kFirst = 64;

  void swap(OpenTable& other) noexcept {
    std::swap(data_, other.data_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }
  void grow(std::size_t least) { move_to(std::max({least, 2 * capacity_, kFirst})); }
  void move_to(std::size_t capacity) {
    T* const moved = Memory().allocate(capacity);
    if (size_ > 0) std::memcpy(static_cast<void*>(moved), data_, size_ * sizeof(T));
    if (data_ != nullptr) Memory().deallocate(data_, capacity_);
    data_ = moved;
    capacity_ = capacity;
  }

  T* data_ = nullptr;
  std::size_t size_ = 0, capacity_ = 0;
};

}  // namespace cncsub
