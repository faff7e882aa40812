#include "cncsub/dialect/okuma/line.hpp"

#include <algorithm>

namespace cncsub::okuma {

std::string_view name_in(std::string_view text) {
  const auto* const end = std::find_if_not(text.begin(), text.end(),
                                           [](char c) { return is_letter(c) || is_digit(c); });
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

void Line::set(std::string_view text, std::uint32_t at) {
  text_ = text;
  at_ = at;
  next_ = end_ = 0;
  open_ = text.size();
}

char Line::peek() {
  while (next_ < text_.size()) {
    if (is_blank(text_[next_])) {
      ++next_;
    } else if (text_[next_] == '(') {
      const std::size_t close = text_.find(')', next_);
      if (close == std::string_view::npos) open_ = next_;
      next_ = close == std::string_view::npos ? text_.size() : close + 1;
    } else {
      return upper(text_[next_]);
    }
  }
  return '\0';
}

std::string_view Line::take_number() {
  const std::string_view here = rest();
  const auto* const end =
      std::find_if_not(here.begin(), here.end(), [](char c) { return is_digit(c) || c == '.'; });
  const std::string_view number = here.substr(0, static_cast<std::size_t>(end - here.begin()));
  if (!number.empty()) pass(number.size());
  return number;
}

bool Line::take_up_to(char close, std::string_view& text) {
  const std::size_t end = rest().find(close);
  if (end == std::string_view::npos) return false;
  text = rest().substr(0, end);
  pass(end + 1);
  return true;
}

}  // namespace cncsub::okuma
