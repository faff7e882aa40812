#include "cncsub/text/look_alikes.hpp"

#include "cncsub/text/scan.hpp"

namespace cncsub {

std::string full_width_of(std::string_view character) {
  constexpr std::string_view kBlank = "\u3000";
  if (character == kBlank) return ": it is a full-width blank, type a plain one";
  if (character.size() != 3 || character[0] != '\xEF') return "";
  const auto middle = static_cast<unsigned char>(character[1]);
  const auto last = static_cast<unsigned char>(character[2]);
  // U+FF01 to U+FF5E are the characters 21 to 7E of ASCII.
  const int plain = middle == 0xBC ? last - 0x60 : middle == 0xBD ? last - 0x20 : 0;
  if (plain < '!' || plain > '~') return "";
  return std::string(": it is a full-width ") + static_cast<char>(plain) + ", type the plain one";
}

bool has_letter_for_zero(std::string_view text, std::size_t at) {
  const auto is_o = [text](std::size_t i) { return i < text.size() && upper(text[i]) == 'O'; };
  const auto of_number = [text](std::size_t i) {
    return i < text.size() && (is_digit(text[i]) || text[i] == '.');
  };
  if (is_o(at)) return of_number(at + 1) || (at > 0 && of_number(at - 1));
  return at < text.size() && is_letter(text[at]) && is_o(at + 1);
}

}  // namespace cncsub
