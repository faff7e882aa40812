#include "cncsub/dialect/sinumerik/line.hpp"

#include <algorithm>

namespace cncsub::sinumerik {

std::string_view name_in(std::string_view text) {
  if (text.empty() || is_digit(text[0])) return {};
  const auto ends = [](char c) { return !is_letter(c) && !is_digit(c) && c != '_'; };
  const auto* const end = std::find_if(text.begin(), text.end(), ends);
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

std::size_t before_comment(std::string_view text) {
  if (text.find(';') == std::string_view::npos) return text.size();
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '"') quoted = !quoted;
    if (text[i] == ';' && !quoted) return i;
  }
  // A quote that is not closed hides no comment.
  return quoted ? std::min(text.find(';'), text.size()) : text.size();
}

bool Line::pass_brackets(char open, char close) {
  int depth = 0;
  for (char c = peek(); c != '\0'; c = peek()) {
    if (c == '"') {
      pass_quoted();
      continue;
    }
    pass(1);
    depth += c == open ? 1 : c == close ? -1 : 0;
    if (depth == 0) return true;
  }
  return false;
}

std::string_view Line::take_digits() {
  const std::string_view here = rest();
  const auto* const end = std::find_if_not(here.begin(), here.end(), is_digit);
  const std::string_view digits = here.substr(0, static_cast<std::size_t>(end - here.begin()));
  if (!digits.empty()) pass(digits.size());
  return digits;
}

std::string Line::take_number() {
  std::string number(take_digits());
  if (ahead(0) == '.') {
    pass(1);
    number += '.';
    number += take_digits();
  }
  if (number.empty() || number == ".") return {};
  if (ahead(0) != 'E' || ahead(1) != 'X') return number;
  pass(2);
  number += 'e';
  const char sign = ahead(0);
  if (sign == '-' || sign == '+') pass(1);
  if (sign == '-') number += '-';
  number += take_digits();
  return number;
}

bool Line::take_up_to(char close, std::string& text) {
  const std::size_t end = rest().find(close);
  if (end == std::string_view::npos) return false;
  text = rest().substr(0, end);
  pass(end + 1);
  return true;
}

}  // namespace cncsub::sinumerik
