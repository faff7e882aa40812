#include "cncsub/text/text_start.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

namespace cncsub {

namespace {

using namespace std::string_view_literals;

// First bytes of files that people keep beside their programs.
constexpr std::string_view kOtherStarts[] = {"PK\x03\x04"sv,
                                             "PK\x05\x06"sv,
                                             "%PDF-"sv,
                                             "\x89PNG"sv,
                                             "\xff\xd8\xff"sv,
                                             "GIF8"sv,
                                             "\x7f"
                                             "ELF"sv,
                                             "MZ\x90"sv,
                                             "\x1f\x8b"sv,
                                             "BZh"sv,
                                             "\xfd"
                                             "7zXZ"sv,
                                             "7z\xbc\xaf"sv,
                                             "Rar!"sv,
                                             "SQLite format"sv,
                                             "\xd0\xcf\x11\xe0"sv};
constexpr std::string_view kMarks[] = {kMarkOfBytes, "\xff\xfe"sv, "\xfe\xff"sv, "\0\0\xfe\xff"sv};

/// Return how many of these bytes belong to no text and to no punched tape. Those have NUL, tab,
/// line ends, SO, SI, DC1 to DC4 but DLE, the DOS end of file and ESC. The bytes are compared and
/// added up, which is done for many of them at once.
std::size_t strange_bytes(std::string_view bytes) {
  const auto between = [](char c, int first, int last) {
    return static_cast<unsigned char>(c - first) <= last - first ? 1U : 0U;
  };
  unsigned strange = 0;
  for (const char c : bytes)
    strange += between(c, 0x01, 0x08) + between(c, 0x10, 0x10) + between(c, 0x15, 0x19) +
               between(c, 0x1c, 0x1f);
  return strange;
}

bool starts_like(std::string_view bytes, std::span<const std::string_view> starts) {
  return std::any_of(starts.begin(), starts.end(),
                     [&](std::string_view start) { return bytes.starts_with(start); });
}

}  // namespace

bool looks_like_text(std::string_view bytes) {
  constexpr std::size_t kSample = 4096;
  if (starts_like(bytes, kOtherStarts)) return false;
  if (starts_like(bytes, kMarks)) return true;
  const std::string_view sample = bytes.substr(0, kSample);
  return strange_bytes(sample) * 20 <= sample.size();
}

}  // namespace cncsub
