#include "cncsub/analysis/name_pieces.hpp"

#include <algorithm>
#include <charconv>

#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

bool is_of_name(char c) { return is_letter(c) || is_digit(c) || c == '_' || c == '$'; }

class PieceReader {
 public:
  PieceReader(const Spelling& spelling, std::string_view text) : spelling_(spelling), text_(text) {}

  std::vector<NamePiece> read() {
    while (at_ < text_.size())
      if (!passed()) one();
    return std::move(pieces_);
  }

 private:
  char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void pass_to(char end) {
    const std::size_t found = text_.find(end, at_ + 1);
    at_ = found == std::string_view::npos ? text_.size() : found + 1;
  }
  void blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }
  /// Pass over a comment or a text between quotes.
  bool passed() {
    const char c = peek();
    if (c == ';') {
      at_ = text_.size();
    } else if (c == '"') {
      pass_to('"');
    } else if (c == '(' && spelling_.comment.before == "(") {
      pass_to(')');
    } else {
      return false;
    }
    return true;
  }
  std::size_t end_of_name(std::size_t from) const {
    while (from < text_.size() && is_of_name(text_[from])) ++from;
    return from;
  }
  void add(NamePiece::Kind kind, std::size_t from, std::size_t name, std::size_t name_end) {
    NamePiece piece{kind};
    piece.at = static_cast<std::uint32_t>(from);
    piece.name_at = static_cast<std::uint32_t>(name);
    piece.name_width = static_cast<std::uint32_t>(name_end - name);
    piece.width = static_cast<std::uint32_t>(at_ - from);
    if (kind == NamePiece::Kind::Number)
      std::from_chars(text_.data() + name, text_.data() + name_end, piece.number);
    pieces_.push_back(piece);
  }
  /// Read what stands after the sign of variables: #100, #ABC, #<abc>.
  void variable() {
    const std::size_t from = at_++;
    blanks();
    const std::size_t name = at_;
    if (is_digit(peek())) {
      while (is_digit(peek())) ++at_;
      add(NamePiece::Kind::Number, from, name, at_);
    } else if (peek() == '<') {
      pass_to('>');
      add(NamePiece::Kind::Variable, from, name + 1, std::max(name + 1, at_ - 1));
    } else if (is_letter(peek()) || peek() == '_') {
      at_ = end_of_name(at_);
      add(NamePiece::Kind::Variable, from, name, at_);
    }
  }
  void one() {
    const std::string_view sign = spelling_.variable;
    if (sign == "#" && peek() == '#') return variable();
    if (!is_letter(peek()) && peek() != '_' && peek() != '$') {
      // A number, so that no name begins inside it.
      if (!is_digit(peek())) return static_cast<void>(++at_);
      while (is_digit(peek())) ++at_;
      return;
    }
    const std::size_t from = at_;
    at_ = end_of_name(at_);
    const std::string_view name = text_.substr(from, at_ - from);
    const bool numbered = sign != "#" && name.size() > sign.size() &&
                          same_letters(name.substr(0, sign.size()), sign) &&
                          std::all_of(name.begin() + std::ssize(sign), name.end(), is_digit);
    if (numbered)
      add(NamePiece::Kind::Number, from, from + sign.size(), at_);
    else
      add(NamePiece::Kind::Name, from, from, at_);
  }

  const Spelling& spelling_;
  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<NamePiece> pieces_;
};

}  // namespace

std::vector<NamePiece> name_pieces(const Spelling& spelling, std::string_view text) {
  return PieceReader(spelling, text).read();
}

std::optional<TextPlace> digits_in(std::string_view file, TextPlace place, std::int64_t number) {
  const std::size_t end = std::min<std::size_t>(file.size(), std::size_t{place.at} + place.width);
  Scanner s;
  s.file = file.data();
  s.at = s.file + place.at;
  s.end = s.file + end;
  while (s.peek() != '\0' && !is_digit(*s.at)) ++s.at;
  const std::uint32_t from = s.offset();
  std::uint32_t behind = from;
  std::int64_t value = 0;
  for (; s.at != s.end; ++s.at) {
    if (is_digit(*s.at)) {
      value = std::min<std::int64_t>(value, 1'000'000'000'000) * 10 + (*s.at - '0');
      behind = s.offset() + 1;
    } else if (!is_blank(*s.at)) {
      break;
    }
  }
  if (behind == from || value != number) return std::nullopt;
  return TextPlace{from, behind - from};
}

}  // namespace cncsub
