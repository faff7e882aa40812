// A block as it is read from left to right. Blanks part words, and say nothing beside operators.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "cncsub/text/scan.hpp"

namespace cncsub::sinumerik {

/// Letters, digits and _ that begin with no digit: the name that stands at the head of a text.
std::string_view name_in(std::string_view text);
/// A name in capitals: the language does not tell small letters from them. [SONE p.42]
std::string capitals(std::string_view name);
/// How many bytes of a block stand before its comment; a ; between quotes begins none.
std::size_t before_comment(std::string_view text);

class Line {
 public:
  /// `at`: where the text stands in its file.
  void set(std::string_view text, std::uint32_t at) {
    set_uncut(text.substr(0, before_comment(text)), at);
    stop_ = '\0';
  }

  /// The same without a look for the comment: it ends at the first ; that is met outside of what
  /// was passed over between quotes.
  void set_uncut(std::string_view text, std::uint32_t at) {
    text_ = text;
    at_ = at;
    next_ = end_ = 0;
    stop_ = ';';
  }

  /// What stands behind blanks, as a capital; 0 at the end.
  char peek() {
    while (next_ < text_.size() && is_blank(text_[next_])) ++next_;
    return next_ < text_.size() && text_[next_] != stop_ ? upper(text_[next_]) : '\0';
  }
  /// What stands between quotes, with them; the quote alone where no other one follows.
  void pass_quoted() {
    const std::size_t close = text_.find('"', next_ + 1);
    pass(close == std::string_view::npos ? 1 : close + 1 - next_);
  }
  bool at_end() { return peek() == '\0'; }
  /// What stands so many characters further on, blanks too.
  char ahead(std::size_t by) const {
    return next_ + by < text_.size() ? upper(text_[next_ + by]) : '\0';
  }
  bool take(char c) { return peek() == c && (pass(1), true); }
  /// Takes these characters, which stand together.
  bool take(std::string_view characters);
  void pass(std::size_t characters) { end_ = next_ += characters; }
  /// The name that stands here, which stays.
  std::string_view name() { return peek() == '\0' ? std::string_view() : name_in(rest()); }
  std::string_view take_digits();
  /// What stands up to `close`, which is taken too; nothing where it is missing.
  bool take_up_to(char close, std::string& text);
  std::string_view rest() const { return text_.substr(next_); }

  std::uint32_t offset() { return peek(), at_ + static_cast<std::uint32_t>(next_); }
  /// How wide what was taken from a place on is.
  std::uint32_t width_from(std::uint32_t at) const {
    const std::uint32_t end = at_ + static_cast<std::uint32_t>(end_);
    return end > at ? end - at : 1;
  }

 private:
  std::string_view text_;
  std::uint32_t at_ = 0;
  std::size_t next_ = 0;
  char stop_ = '\0';     // where it ends before its text does
  std::size_t end_ = 0;  // behind the last character that was taken
};

}  // namespace cncsub::sinumerik
