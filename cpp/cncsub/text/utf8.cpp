#include "cncsub/text/utf8.hpp"

namespace cncsub {

bool is_ascii(std::string_view text) {
  unsigned char any = 0;
  for (const char c : text) any |= static_cast<unsigned char>(c);
  return any < 0x80;
}

std::size_t utf8_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead < 0xc2 || lead > 0xf4) return 0;
  const std::size_t length = lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
  if (text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0U) != 0x80) return 0;
  const unsigned least = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
  const unsigned most = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
  return byte(1) >= least && byte(1) <= most ? length : 0;
}

bool is_utf8(std::string_view text, const std::function<bool(std::size_t)>& stopped) {
  constexpr std::size_t kOnce = 1 << 16;
  while (!text.empty() && !stopped(kOnce)) {
    const std::string_view piece = text.substr(0, kOnce);
    std::size_t at = is_ascii(piece) ? piece.size() : 0;
    while (at < piece.size()) {
      const std::size_t length = utf8_character(text.substr(at));
      if (length == 0) return false;
      at += length;
    }
    text.remove_prefix(at);
  }
  return true;
}

}  // namespace cncsub
