#include "cncsub/text/scan.hpp"

#include <algorithm>

namespace cncsub {

namespace {

constexpr std::uint32_t kPlainDigits = 15;  // a double holds every such number

/// The digits of a number as they come; the first 18 count.
struct Digits {
  std::uint64_t mantissa = 0;
  std::uint32_t decimals = 0;
  std::uint32_t kept = 0;
  double scale = 1;  // the factor of the digits beyond those of the mantissa

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

/// Pass over blanks and comments inside a number, if it goes on after them.
bool pass_gap(Scanner& s) {
  Scanner ahead = s;
  const char next = ahead.peek();
  if (!is_digit(next) && next != '.') return false;
  s.at = ahead.at;
  return true;
}

/// Return whether a number may go on here, after a gap or with another point.
bool may_go_on(const char* at, const char* end) {
  while (at != end && *at == ' ') ++at;
  return at != end && (is_digit(*at) || *at == '.' || *at == '(' || is_blank(*at));
}

/// Take leading zeros out of the counts of a number's digits.
void drop_zeros(const char* first, const char* end, Number& number) {
  for (; first != end && (*first == '0' || *first == '.'); ++first) {
    if (*first == '.') continue;
    --number.digits;
    if (number.whole_digits > 0) --number.whole_digits;
  }
}

/// Read a number in its usual form: perhaps a sign, then digits and one point, with nothing between
/// them. Return false if it has another form, or may go on after a gap.
bool scan_plain(Scanner& s, Number& number) {
  const char* at = s.at;
  const bool sign = at != s.end && (*at == '-' || *at == '+');
  const bool negative = sign && *at == '-';
  at += sign ? 1 : 0;
  if (at == s.end || (!is_digit(*at) && *at != '.')) return false;
  const char* const first = at;
  const Mantissa m = scan_mantissa(at);
  const auto written = static_cast<std::uint32_t>(m.whole + m.decimals);
  if (at > s.end || written == 0 || written > kPlainDigits || may_go_on(at, s.end)) return false;
  number.digits = number.written = written;
  number.whole_digits = static_cast<std::uint32_t>(m.whole);
  drop_zeros(first, at, number);
  number.decimals = static_cast<std::uint32_t>(m.decimals);
  number.points = m.point ? 1 : 0;
  number.has_sign = sign;
  number.negative = negative;
  number.any = true;
  const double value =
      static_cast<double>(static_cast<std::int64_t>(m.value)) / kPowersOfTen[m.decimals];
  number.value = negative ? -value : value;
  s.at = at;
  return true;
}

}  // namespace

Number scan_number(Scanner& s) {
  Number number;
  if (scan_plain(s, number)) return number;
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
