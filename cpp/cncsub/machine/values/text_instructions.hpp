// The computations of the instructions of texts.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>

#include "cncsub/machine/values/instructions.hpp"
#include "cncsub/machine/values/texts.hpp"
#include "cncsub/system/decimal.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub::instruction {

/// Return an axis by its letter; nothing where it is none.
inline std::string axis_letter(double axis) {
  constexpr std::string_view kLetters = "XYZABCUVW";
  const bool known = axis >= 1 && axis <= static_cast<double>(kLetters.size());
  return known ? std::string(1, kLetters[to_whole<std::size_t>(axis) - 1]) : std::string();
}

/// Return the character of a code in UTF-8.
inline std::string text_of_code(unsigned code) {
  if (code < 0x80) return std::string(1, static_cast<char>(code));
  return {static_cast<char>(0xC0 | code >> 6), static_cast<char>(0x80 | (code & 0x3F))};
}

/// Write a value as << does: a number with the digits it has.
inline std::string written_as(E e, double value, WrittenAs how) {
  constexpr double kPlain = 1e15;  // whole numbers below it have no exponent
  char digits[40];
  switch (how) {
    case WrittenAs::Text:
      return text_of(e.run, value);
    case WrittenAs::Truth:
      return value != 0 ? "1" : "0";
    case WrittenAs::Character:
      return text_of_code(to_whole<unsigned>(std::clamp(value, 0.0, 255.0)));
    case WrittenAs::Axis:
      return axis_letter(value);
    case WrittenAs::Number:
      break;
  }
  const bool whole = value == std::trunc(value) && std::fabs(value) < kPlain;
  std::snprintf(digits, sizeof digits, whole ? "%.0f" : "%.10g", value == 0 ? 0.0 : value);
  return digits;
}

inline double written_as_text(E e, I at, double a) {
  return keep_text(e.run, written_as(e, a, static_cast<WrittenAs>(to_whole<int>(at.value()))));
}
// Longer texts are no values: a block could make a very long one of each of its parts.
constexpr std::size_t kLongestText = 1000;

inline Fallible join_texts(E e, I at, double a, double b) {
  const int both = to_whole<int>(at.value());
  std::string text = written_as(e, a, static_cast<WrittenAs>(both / 16));
  text += written_as(e, b, static_cast<WrittenAs>(both % 16));
  if (text.size() <= kLongestText) return keep_text(e.run, std::move(text));
  return fails(e, at, Cause::CodeNotComputed, "a text of more than 1,000 characters");
}

/// Return how many characters of a text a value counts.
inline std::size_t characters(const std::string& text, double count) {
  return whole_characters(text, to_whole<std::size_t>(std::clamp(
                                    std::round(count), 0.0, static_cast<double>(text.size()))));
}

/// Write a value as a field of SPRINT says.
inline double format_text(E e, I at, double a) {
  const TextFormat format = TextFormat::of(at.value());
  const int decimals = format.decimals < 0 ? 6 : format.decimals;
  std::string text(TextFormat::kMost + 400, '\0');
  const auto print = [&](const char* how, auto... values) {
    const int length = std::snprintf(text.data(), text.size(), how, values...);
    text.resize(static_cast<std::size_t>(std::max(length, 0)));
  };
  const auto whole = to_whole<long long>(std::clamp(std::round(a), -9e15, 9e15));
  switch (format.kind) {
    case 'S':
      text = text_of(e.run, a);
      if (format.decimals >= 0) text.resize(characters(text, decimals));
      break;
    case 'C':
      text = written_as(e, a, WrittenAs::Character);
      break;
    case 'B':
      text = a != 0 ? "TRUE" : "FALSE";
      break;
    case 'D':
      print("%lld", whole);
      break;
    case 'X':
      print("%X", static_cast<unsigned>(whole));
      break;
    case 'E':
      print("%.*E", decimals, a);
      break;
    case 'G':
      print("%.*G", decimals, a);
      break;
    default:
      print("%.*f", decimals, a);
      break;
  }
  const auto width = static_cast<std::size_t>(format.width);
  if (text.size() < width) text.insert(0, width - text.size(), ' ');
  return keep_text(e.run, std::move(text));
}

inline double text_length(E e, I, double a) {
  return static_cast<double>(text_of(e.run, a).size());
}
inline double changed_letters(E e, double a, char (*change)(char)) {
  std::string text = text_of(e.run, a);
  std::transform(text.begin(), text.end(), text.begin(), change);
  return keep_text(e.run, std::move(text));
}
inline double upper_text(E e, I, double a) {
  return changed_letters(e, a, [](char c) { return upper(c); });
}
inline double lower_text(E e, I, double a) {
  return changed_letters(
      e, a, [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
}

/// Return the number that a text is and nothing else: 1.5, -3, 2EX3.
inline Fallible number_of_text(const std::string& text) {
  std::string digits(text);
  const std::size_t exponent = digits.find("EX");
  if (exponent != std::string::npos) digits.erase(exponent + 1, 1);
  const bool plus = digits.size() > 1 && digits[0] == '+' && digits[1] != '-';
  const std::string unsigned_digits = plus ? digits.substr(1) : digits;
  double number = 0;
  const auto read = system::parse(unsigned_digits, number);
  if (!read.number || read.length != unsigned_digits.size() || std::fabs(number) > kLargest)
    return std::nullopt;
  return number;
}
inline Fallible number_in_text(E e, I at, double a) {
  const Fallible number = number_of_text(text_of(e.run, a));
  return number ? number : fails(e, at, Cause::ValueOutOfRange, "the text is no number");
}
inline double is_number_text(E e, I, double a) { return number_of_text(text_of(e.run, a)) ? 1 : 0; }
inline double code_of(char character) { return static_cast<unsigned char>(character); }
inline Fallible only_character(E e, I at, double a) {
  const std::string& text = text_of(e.run, a);
  if (text.size() == 1) return code_of(text[0]);
  return fails(e, at, Cause::ValueOutOfRange, "a CHAR is one character");
}
inline double text_from(E e, I, double a, double b) {
  const std::string& text = text_of(e.run, a);
  return keep_text(e.run, text.substr(characters(text, b)));
}
inline double text_up_to(E e, I, double a, double b) {
  const std::string& text = text_of(e.run, a);
  const std::size_t count = characters(text, b);
  return count == text.size() ? a : keep_text(e.run, text.substr(0, count));
}
inline double character_at(E e, I, double a, double b) {
  const std::string& text = text_of(e.run, a);
  const double place = std::round(b);
  const bool inside = place >= 0 && place < static_cast<double>(text.size());
  return inside ? code_of(text[to_whole<std::size_t>(place)]) : 0;
}
inline double place(std::size_t found) {
  return found == std::string::npos ? -1 : static_cast<double>(found);
}
inline char as_character(double a) {
  return static_cast<char>(to_whole<unsigned>(std::clamp(std::round(a), 0.0, 255.0)));
}
inline double first_place(E e, I, double a, double b) {
  return place(text_of(e.run, a).find(as_character(b)));
}
inline double last_place(E e, I, double a, double b) {
  return place(text_of(e.run, a).rfind(as_character(b)));
}
inline double first_place_of_any(E e, I, double a, double b) {
  return place(text_of(e.run, a).find_first_of(text_of(e.run, b)));
}
inline double find_text(E e, I, double a, double b) {
  return place(text_of(e.run, a).find(text_of(e.run, b)));
}

}  // namespace cncsub::instruction
