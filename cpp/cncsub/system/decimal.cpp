#include "cncsub/system/decimal.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>
#include <utility>
#include <version>

namespace cncsub::system {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::size_t digits_from(std::string_view text, std::size_t at) {
  while (at < text.size() && is_digit(text[at])) ++at;
  return at;
}

/// Return where the number at the head of the text ends; 0 where there is none.
std::size_t end_of_number(std::string_view text, Decimal form) {
  const std::size_t first = text.starts_with('-') ? 1 : 0;
  std::size_t end = digits_from(text, first);
  std::size_t digits = end - first;
  if (end < text.size() && text[end] == '.') {
    const std::size_t behind = digits_from(text, end + 1);
    digits += behind - end - 1;
    if (digits > 0) end = behind;
  }
  if (digits == 0) return 0;
  if (form == Decimal::Fixed || end >= text.size() || (text[end] | 0x20) != 'e') return end;
  const bool sign = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-');
  const std::size_t exponent = end + (sign ? 2 : 1);
  const std::size_t last = digits_from(text, exponent);
  return last > exponent ? last : end;
}

std::string printed(double value, std::ios_base::fmtflags form, int digits) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.setf(form, std::ios_base::floatfield);
  out.precision(digits);
  out << value;
  return out.str();
}

bool reads_as(const std::string& text, double value) {
  double again = 0;
  return parse_by_stream(text, again, Decimal::General).number && again == value;
}

}  // namespace

Parsed parse_by_stream(std::string_view text, double& value, Decimal form) {
  const std::size_t end = end_of_number(text, form);
  if (end == 0) return {};
  std::istringstream in{std::string(text.substr(0, end))};
  in.imbue(std::locale::classic());
  double read = 0;
  in >> read;
  // A number that is too small becomes one that is not: std::from_chars refuses both.
  const std::string_view digits = text.substr(0, std::min(end, text.find_first_of("eE")));
  const bool nought = digits.find_first_of("123456789") == std::string_view::npos;
  if (!std::isfinite(read) || (read == 0 && !nought) || (in.fail() && std::fabs(read) >= 1))
    return {false, end};
  value = read;
  return {true, end};
}

namespace {

struct Shortest {
  std::string science, plain;
};

Shortest shortest_texts(double value) {
  if (!std::isfinite(value)) {
    const std::string text = value != value ? "nan" : value < 0 ? "-inf" : "inf";
    return {text, text};
  }
  constexpr int kMost = 17;
  std::string science;
  int digits = 1;
  for (; digits <= kMost; ++digits) {
    science = printed(value, std::ios_base::scientific, digits - 1);
    if (reads_as(science, value)) break;
  }
  const int exponent = std::stoi(science.substr(science.find('e') + 1));
  std::string plain =
      printed(value, std::ios_base::fixed, digits - 1 > exponent ? digits - 1 - exponent : 0);
  return {std::move(science), std::move(plain)};
}

}  // namespace

std::string shortest_by_stream(double value) {
  Shortest text = shortest_texts(value);
  return text.plain.size() <= text.science.size() ? text.plain : text.science;
}

std::string shortest_fixed_by_stream(double value) { return shortest_texts(value).plain; }

Parsed parse(std::string_view text, double& value, Decimal form) {
#ifdef __cpp_lib_to_chars
  const auto how = form == Decimal::Fixed ? std::chars_format::fixed : std::chars_format::general;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value, how);
  return {read.ec == std::errc(), static_cast<std::size_t>(read.ptr - text.data())};
#else
  return parse_by_stream(text, value, form);
#endif
}

std::string shortest(double value) {
#ifdef __cpp_lib_to_chars
  std::array<char, 32> text{};
  auto* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
#else
  return shortest_by_stream(value);
#endif
}

std::string shortest_fixed(double value) {
#ifdef __cpp_lib_to_chars
  std::array<char, 400> text{};  // the largest double has 309 digits
  auto* const end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed).ptr;
  return {text.data(), end};
#else
  return shortest_fixed_by_stream(value);
#endif
}

}  // namespace cncsub::system
