#include "cncsub/text/scan.hpp"

#include <algorithm>

namespace cncsub {

namespace {

/// The digits of a number as they come; the first 18 count.
struct Digits {
  std::uint64_t mantissa = 0;
  std::uint32_t decimals = 0;
  std::uint32_t kept = 0;
  double scale = 1;  // of digits beyond what the mantissa holds

  void add(char digit, Number& number) {
    const bool decimal = number.points != 0;
    ++number.written;
    if (mantissa != 0 || digit != '0') {
      ++number.digits;
      if (!decimal) ++number.whole_digits;
    }
    if (kept < 18) {
      mantissa = mantissa * 10 + static_cast<std::uint64_t>(digit - '0');
      if (mantissa != 0) ++kept;
      if (decimal) ++decimals;
    } else if (!decimal) {
      scale *= 10;
    }
  }
  double value() const {
    const double value = std::min(static_cast<double>(mantissa) * scale, kLargest);
    return decimals <= 22 ? value / kPowersOfTen[decimals] : 0;
  }
};

/// Passes over blanks and comments inside a number, if it goes on behind them.
bool pass_gap(Scanner& s) {
  Scanner ahead = s;
  const char next = ahead.peek();
  if (!is_digit(next) && next != '.') return false;
  s.at = ahead.at;
  return true;
}

}  // namespace

Number scan_number(Scanner& s) {
  Number number;
  Digits digits;
  while (s.at != s.end) {
    const char c = *s.at;
    if (is_digit(c)) {
      digits.add(c, number);
    } else if (c == '.') {
      if (number.points < 255) ++number.points;
    } else if ((c == '-' || c == '+') && number.written == 0 && number.points == 0 &&
               !number.has_sign) {
      number.negative = c == '-';
      number.has_sign = true;
    } else if ((is_blank(c) || c == '(') && pass_gap(s)) {
      continue;
    } else {
      break;
    }
    ++s.at;
  }
  number.any = number.written != 0;
  number.decimals = digits.decimals;
  number.value = number.negative ? -digits.value() : digits.value();
  return number;
}

}  // namespace cncsub
