// A block as it is read from left to right. Blanks separate words and mean nothing at operators.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "cncsub/text/scan.hpp"

namespace cncsub::sinumerik {

/// Return the name at the head of a text: letters, digits and _ that begin with no digit.
std::string_view name_in(std::string_view text);
// Names are compared in capitals: the language does not tell small letters from them. [SONE p.42]

/// Return how many bytes of a block stand before its comment; a ; between quotes begins none.
std::size_t before_comment(std::string_view text);

class Line {
 public:
  /// Set the text of the block, which stands at `at` in its file.
  void set(std::string_view text, std::uint32_t at) {
    set_uncut(text.substr(0, before_comment(text)), at);
    stop_ = '\0';
  }

  /// Set the text without a search for its comment. It ends at the first ; outside of the quotes
  /// that were passed over.
  void set_uncut(std::string_view text, std::uint32_t at) {
    text_ = text;
    at_ = at;
    next_ = end_ = 0;
    stop_ = ';';
  }

  /// Return the character after any blanks, as a capital; 0 at the end.
  char peek() {
    while (next_ < text_.size() && is_blank(text_[next_])) ++next_;
    return next_ < text_.size() && text_[next_] != stop_ ? upper(text_[next_]) : '\0';
  }
  /// Pass over a text between quotes, with them, or over the quote alone if no other one follows.
  void pass_quoted() {
    const std::size_t close = text_.find('"', next_ + 1);
    pass(close == std::string_view::npos ? 1 : close + 1 - next_);
  }
  /// Pass over brackets, of which the first stands here, with all between them; return false if one
  /// is not closed.
  bool pass_brackets(char open, char close);
  bool at_end() { return peek() == '\0'; }
  /// Return the character so many characters further on, which may be a blank.
  char ahead(std::size_t by) const {
    return next_ + by < text_.size() ? upper(text_[next_ + by]) : '\0';
  }
  /// Return how many characters further on the blanks end that may stand there.
  std::size_t past_blanks(std::size_t by) const {
    while (next_ + by < text_.size() && is_blank(text_[next_ + by])) ++by;
    return by;
  }
  bool take(char c) { return peek() == c && (pass(1), true); }
  void pass(std::size_t characters) { end_ = next_ += characters; }
  /// Return whether a name of two letters or more stands here: DEF, CR, and not X10.
  bool begins_word() {
    const char first = peek(), second = ahead(1);
    return (is_letter(first) || first == '_') && (is_letter(second) || second == '_') &&
           next_ + 1 < text_.size();
  }
  /// Return the name that stands here, which is not taken.
  std::string_view name() { return peek() == '\0' ? std::string_view() : name_in(rest()); }
  std::string_view take_digits();
  /// Take 10, 10.5, .5 or 1.5EX3, and return it with e for EX; no digit, no number.
  std::string take_number();
  /// Take the text up to `close`, and `close` too; return false if it is missing.
  bool take_up_to(char close, std::string& text);
  std::string_view rest() const { return text_.substr(next_); }

  std::uint32_t offset() { return peek(), at_ + static_cast<std::uint32_t>(next_); }
  /// Return how wide the text is that was taken from a place on.
  std::uint32_t width_from(std::uint32_t at) const {
    const std::uint32_t end = at_ + static_cast<std::uint32_t>(end_);
    return end > at ? end - at : 1;
  }

 private:
  std::string_view text_;
  std::uint32_t at_ = 0;
  std::size_t next_ = 0;
  char stop_ = '\0';     // the character that ends it before its text does
  std::size_t end_ = 0;  // after the last character that was taken
};

}  // namespace cncsub::sinumerik
