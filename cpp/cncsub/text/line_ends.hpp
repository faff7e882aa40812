// The ends of the lines of a text.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace cncsub {

/// A walk through a text from one end of line to the next. It looks at 64 characters at once,
/// because lines are too short for memchr to be worth its call.
class LineEnds {
 public:
  LineEnds(const char* at, const char* end) : window_(at), end_(end) { look(); }

  /// Return the next '\n', or the end of the text.
  const char* next() {
    while (found_ == 0) {
      if (end_ - window_ <= kWindow) return end_;
      window_ += kWindow;
      look();
    }
    const char* const at = window_ + std::countr_zero(found_);
    found_ &= found_ - 1;
    return at;
  }

 private:
  static constexpr std::ptrdiff_t kWindow = 64;

  void look() {
    if (end_ - window_ >= kWindow) {
      found_ = ends_in(window_);
      return;
    }
    found_ = 0;
    for (const char* at = window_; at < end_; ++at)
      if (*at == '\n') found_ |= std::uint64_t{1} << (at - window_);
  }

  /// Return a bit for each of 64 characters: whether it ends a line.
#ifdef __SSE2__
  static std::uint64_t ends_in(const char* at) {
    const __m128i end = _mm_set1_epi8('\n');
    std::uint64_t found = 0;
    for (std::ptrdiff_t i = 0; i < kWindow; i += 16) {
      const __m128i part = _mm_loadu_si128(reinterpret_cast<const __m128i*>(at + i));
      const auto bits = static_cast<std::uint32_t>(_mm_movemask_epi8(_mm_cmpeq_epi8(part, end)));
      found |= std::uint64_t{bits} << i;
    }
    return found;
  }
#else
  static std::uint64_t ends_in(const char* at) {
    constexpr std::uint64_t kEach = 0x0101010101010101U, kLow = 0x7f * kEach;
    std::uint64_t found = 0;
    for (std::ptrdiff_t i = 0; i < kWindow; i += 8) {
      std::uint64_t part = 0;
      std::memcpy(&part, at + i, sizeof part);
      if constexpr (std::endian::native == std::endian::big) part = reversed(part);
      part ^= kEach * '\n';
      const std::uint64_t zeros = ~(((part & kLow) + kLow) | part | kLow) >> 7;
      found |= (zeros * 0x0102040810204080U >> 56) << i;
    }
    return found;
  }
  static std::uint64_t reversed(std::uint64_t part) {
    std::uint64_t turned = 0;
    for (int i = 0; i < 8; ++i) turned |= (part >> 8 * i & 0xffU) << (56 - 8 * i);
    return turned;
  }
#endif

  const char *window_, *end_;
  std::uint64_t found_ = 0;  // in the window, and not yet returned
};

}  // namespace cncsub
