// A search for marks that most lines of a text do not have.
#pragma once

#include <cstddef>
#include <cstring>

namespace cncsub {

/// The next place of a character in a text that is read from front to back. Each place is found
/// once.
class NextMark {
 public:
  NextMark() = default;
  NextMark(char mark, const char* at, const char* end) : end_(end), mark_(mark) { seek(at); }

  bool in(const char* at, const char* end) { return from(at) < end; }
  /// Return the next mark from `at` on, or the end of the text.
  const char* from(const char* at) {
    if (next_ < at) seek(at);
    return next_;
  }

 private:
  void seek(const char* at) {
    const void* found = std::memchr(at, mark_, static_cast<std::size_t>(end_ - at));
    next_ = found == nullptr ? end_ : static_cast<const char*>(found);
  }

  const char* next_ = nullptr;
  const char* end_ = nullptr;
  char mark_ = 0;
};

}  // namespace cncsub
