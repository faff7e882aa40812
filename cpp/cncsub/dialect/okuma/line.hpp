// A block as it is read from left to right. Blanks and comments part its words.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "cncsub/text/scan.hpp"

namespace cncsub::okuma {

/// Return the letters and digits at the head of a text.
std::string_view name_in(std::string_view text);

class Line {
 public:
  /// Set the text of the block, which stands at `at` in its file.
  void set(std::string_view text, std::uint32_t at);

  /// Return the character after any blanks and comments, as a capital; 0 at the end.
  char peek();
  bool at_end() { return peek() == '\0'; }
  /// Return the character so many characters further on, as a capital.
  char ahead(std::size_t by) const {
    return next_ + by < text_.size() ? upper(text_[next_ + by]) : '\0';
  }
  bool take(char c) { return peek() == c && (pass(1), true); }
  void pass(std::size_t characters) { end_ = next_ += characters; }
  /// Return the letters and digits that stand here, which are not taken.
  std::string_view name() { return peek() == '\0' ? std::string_view() : name_in(rest()); }
  /// Return whether a name of two letters or more stands here: CALL, PX, and not X10.
  bool begins_word() { return is_letter(peek()) && is_letter(ahead(1)); }
  /// Take a number without its sign: 10, 10.5, .5.
  std::string_view take_number();
  /// Take the text up to `close`, and `close` too; return false if it is missing.
  bool take_up_to(char close, std::string_view& text);
  std::string_view rest() const { return text_.substr(next_); }

  std::uint32_t offset() { return peek(), at_ + static_cast<std::uint32_t>(next_); }
  /// Return how wide the text is that was taken from a place on.
  std::uint32_t width_from(std::uint32_t at) const {
    const std::uint32_t end = at_ + static_cast<std::uint32_t>(end_);
    return end > at ? end - at : 1;
  }
  /// Return the same for a fault: 0, the word that stands there, where nothing was taken.
  std::uint32_t fault_width(std::uint32_t at) const {
    return at_ + static_cast<std::uint32_t>(end_) > at ? width_from(at) : 0;
  }
  /// Return where a comment stands that is not closed; the end of the text where all are.
  std::size_t open_comment() const { return open_; }
  bool has_open_comment() const { return open_ < text_.size(); }

 private:
  std::string_view text_;
  std::uint32_t at_ = 0;
  std::size_t next_ = 0;
  std::size_t end_ = 0;   // after the last character that was taken
  std::size_t open_ = 0;  // where a comment begins that is not closed
};

}  // namespace cncsub::okuma
