// The computations of the instructions of texts.
#pragma once

#include <algorithm>
#include <cstdio>
#include <string>

#include "cncsub/code/foreign_text.hpp"
#include "cncsub/machine/values/instructions.hpp"
#include "cncsub/machine/values/reference_instructions.hpp"
#include "cncsub/machine/values/texts.hpp"
#include "cncsub/system/decimal.hpp"
#include "cncsub/text/axis_names.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub::instruction {

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
  if (at.value() == kForeignText)
    return keep_text(e.run, e.run.code->names[to_whole<std::size_t>(a)]);
  return keep_text(e.run, written_as(e, a, static_cast<WrittenAs>(to_whole<int>(at.value()))));
}
inline double tool_of_name(E e, I at, double a) {
  const double tool = e.run.motion.view().state.tables.tool_of(text_of(e.run, a));
  return tool > 0 ? tool : left_out(e, at);
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

/// Return how many bytes of a text so many characters are.
inline std::size_t bytes_of(const std::string& text, double characters) {
  const double most = static_cast<double>(text.size());
  return bytes_of_first(text, to_whole<std::size_t>(std::clamp(std::round(characters), 0.0, most)));
}
/// Return how many characters stand before a byte of a text.
inline double characters_before(const std::string& text, std::size_t byte) {
  const auto begins = [](char c) { return !is_inside_character(c); };
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(byte);
  return static_cast<double>(std::count_if(text.begin(), end, begins));
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
      if (format.decimals >= 0) text.resize(bytes_of(text, decimals));
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
  const std::string& text = text_of(e.run, a);
  return characters_before(text, text.size());
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
/// Return the code of the character at the head of a text: of Latin-1, or 0 where it has none.
inline double code_at_head(std::string_view text) {
  const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(text[at]); };
  if (text.empty() || byte(0) < 0x80) return text.empty() ? 0 : byte(0);
  return text.size() > 1 && byte(0) <= 0xC3 ? (byte(0) & 3U) << 6 | (byte(1) & 0x3FU) : 0;
}
inline Fallible only_character(E e, I at, double a) {
  const std::string& text = text_of(e.run, a);
  if (!text.empty() && bytes_of_first(text, 1) == text.size()) return code_at_head(text);
  return fails(e, at, Cause::ValueOutOfRange, "a CHAR is one character");
}
inline double text_from(E e, I, double a, double b) {
  const std::string& text = text_of(e.run, a);
  return keep_text(e.run, text.substr(bytes_of(text, b)));
}
inline double text_up_to(E e, I, double a, double b) {
  const std::string& text = text_of(e.run, a);
  const std::size_t count = bytes_of(text, b);
  return count == text.size() ? a : keep_text(e.run, text.substr(0, count));
}
inline double character_at(E e, I, double a, double b) {
  const std::string& text = text_of(e.run, a);
  return std::round(b) < 0 ? 0 : code_at_head(std::string_view(text).substr(bytes_of(text, b)));
}
inline double place(const std::string& text, std::size_t found) {
  return found == std::string::npos ? -1 : characters_before(text, found);
}
inline double first_place(E e, I, double a, double b) {
  const std::string& text = text_of(e.run, a);
  return place(text, text.find(written_as(e, b, WrittenAs::Character)));
}
inline double last_place(E e, I, double a, double b) {
  const std::string& text = text_of(e.run, a);
  return place(text, text.rfind(written_as(e, b, WrittenAs::Character)));
}
inline double first_place_of_any(E e, I, double a, double b) {
  const std::string& text = text_of(e.run, a);
  std::size_t first = std::string::npos;
  std::string_view character;
  for (std::string_view any = text_of(e.run, b); !any.empty();
       any.remove_prefix(character.size())) {
    character = first_character(any);
    first = std::min(first, text.find(character));
  }
  return place(text, first);
}
inline double find_text(E e, I, double a, double b) {
  const std::string& text = text_of(e.run, a);
  return place(text, text.find(text_of(e.run, b)));
}

}  // namespace cncsub::instruction
