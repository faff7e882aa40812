#include "cncsub/dialect/bare_line.hpp"

#include <algorithm>

#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

void BareLine::set(std::string_view text, std::uint32_t at) {
  text_.resize(text.size());
  places_.resize(text.size() + 1);
  next_ = 0;
  nested_ = false;
  std::size_t kept = 0;
  bool comment = false, rest = false;  // inside ( ), after a semicolon
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (!comment && !rest && (c == ' ' || c == '\t' || c == '\r')) continue;
    if (c == ';' && !comment) rest = true;
    if (!rest && c == '(') {
      nested_ = nested_ || comment;
      comment = true;
    }
    text_[kept] = comment || rest ? c : lower(c);
    places_[kept++] = at + static_cast<std::uint32_t>(i);
    if (comment && c == ')') comment = false;
  }
  unclosed_ = comment;
  text_.resize(kept);
  places_.resize(kept);
  places_.push_back(at + static_cast<std::uint32_t>(text.size()));
}

bool BareLine::take(std::string_view word) {
  if (!rest().starts_with(word)) return false;
  next_ += word.size();
  return true;
}

bool BareLine::take_up_to(char close, std::string& text) {
  const std::size_t end = text_.find(close, next_);
  if (end == std::string::npos) return false;
  text = text_.substr(next_, end - next_);
  next_ = end + 1;
  return true;
}

std::string_view BareLine::take_digits() { return take_all("0123456789"); }

std::string_view BareLine::take_all(std::string_view characters) {
  const std::size_t end = std::min(text_.find_first_not_of(characters, next_), text_.size());
  const std::string_view taken = std::string_view(text_).substr(next_, end - next_);
  next_ = end;
  return taken;
}

std::uint32_t BareLine::offset(std::size_t place) const {
  return places_[std::min(place, places_.size() - 1)];
}

std::uint32_t BareLine::width_from(std::uint32_t at) const {
  const std::uint32_t end = next_ == 0 ? at : places_[next_ - 1] + 1;
  return end > at ? end - at : 1;
}

}  // namespace cncsub
