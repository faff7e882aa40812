#include "cncsub/scan.hpp"

#include <algorithm>

namespace cncsub {

Number scan_number(Scanner& s) {
  Number number;
  std::uint64_t mantissa = 0;
  std::uint32_t decimals = 0;
  std::uint32_t kept = 0;
  double scale = 1;  // of digits beyond what the mantissa holds
  for (;;) {
    if (s.at == s.end) break;
    const char c = *s.at;
    if (is_digit(c)) {
      number.any = true;
      ++number.written;
      if (mantissa != 0 || c != '0') {
        ++number.digits;
        if (number.points == 0) ++number.whole_digits;
      }
      if (kept < 18) {
        mantissa = mantissa * 10 + static_cast<std::uint64_t>(c - '0');
        if (mantissa != 0) ++kept;
        if (number.points != 0) ++decimals;
      } else if (number.points == 0) {
        scale *= 10;
      }
      ++s.at;
    } else if (c == '.') {
      if (number.points < 255) ++number.points;
      ++s.at;
    } else if ((c == '-' || c == '+') && !number.any && number.points == 0 && !number.has_sign) {
      number.negative = c == '-';
      number.has_sign = true;
      ++s.at;
    } else if (is_blank(c) || c == '(') {
      Scanner ahead = s;
      const char next = ahead.peek();
      if (!is_digit(next) && next != '.') break;
      s.at = ahead.at;
    } else {
      break;
    }
  }
  number.decimals = decimals;
  const double value = std::min(static_cast<double>(mantissa) * scale, kLargest);
  number.value = decimals <= 22 ? value / kPowersOfTen[decimals] : 0;
  if (number.negative) number.value = -number.value;
  return number;
}

}  // namespace cncsub
