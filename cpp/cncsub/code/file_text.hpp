// The text of a file: many megabytes, perhaps, that are allocated once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string_view>

#include "cncsub/system/kept_memory.hpp"

namespace cncsub {

/// A text with a zero after its last byte, as a string has: readers look one byte ahead.
class FileText {
 public:
  FileText() = default;
  /// Allocate so many bytes that are not written yet. Whoever touches memory first waits for it, so
  /// several threads may write.
  explicit FileText(std::size_t size)
      : bytes_(Memory().allocate(size + 1), GiveBack{size + 1}), size_(size) {
    bytes_[size] = '\0';
  }
  explicit FileText(std::string_view text) : FileText(text.size()) {
    std::copy(text.begin(), text.end(), bytes_.get());
  }
  FileText(const FileText& other) : FileText(other.view()) {}
  FileText(FileText&& other) noexcept = default;
  FileText& operator=(const FileText& other) { return *this = FileText(other); }
  FileText& operator=(FileText&& other) noexcept = default;
  ~FileText() = default;

  char* data() { return bytes_.get(); }
  std::size_t size() const { return size_; }
  std::string_view view() const {
    return bytes_ == nullptr ? "" : std::string_view(bytes_.get(), size_);
  }
  /// Keep only the first bytes of the text.
  void shorten(std::size_t size) {
    if (size >= size_) return;
    size_ = size;
    bytes_[size] = '\0';
  }

 private:
  using Memory = system::KeptMemory<char, system::kLargePage>;
  struct GiveBack {
    std::size_t bytes;
    void operator()(char* memory) const { Memory().deallocate(memory, bytes); }
  };

  std::unique_ptr<char[], GiveBack> bytes_;  // NOLINT: bytes
  std::size_t size_ = 0;
};

}  // namespace cncsub
