// A line as interpreters of RS274 read it: in small letters and without blanks, except in comments.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control/alarm.hpp"

namespace cncsub {

class BareLine {
 public:
  /// Set the text of the line, which stands at `at` in its file.
  void set(std::string_view text, std::uint32_t at);

  char peek(std::size_t ahead = 0) const {
    return next_ + ahead < text_.size() ? text_[next_ + ahead] : '\0';
  }
  bool at_end() const { return next_ >= text_.size(); }
  char take() { return at_end() ? '\0' : text_[next_++]; }
  bool take(char c) { return peek() == c && (++next_, true); }
  bool take(std::string_view word);
  /// Take the text up to `close`, and `close` too; return false if it is missing.
  bool take_up_to(char close, std::string& text);
  /// Take the digits that stand here.
  std::string_view take_digits();
  std::string_view take_all(std::string_view characters);
  std::string_view rest() const { return std::string_view(text_).substr(next_); }

  std::size_t place() const { return next_; }
  /// Return where in the file a place of the line is.
  std::uint32_t offset(std::size_t place) const;
  std::uint32_t offset() const { return offset(next_); }
  std::uint32_t width_from(std::uint32_t at) const;

  /// Return whether a comment is not closed, or stands inside another.
  bool unclosed() const { return unclosed_; }
  bool nested() const { return nested_; }

 private:
  std::string text_;
  std::vector<std::uint32_t> places_;  // of each character in the file, and of the end
  std::size_t next_ = 0;
  bool unclosed_ = false, nested_ = false;
};

}  // namespace cncsub
