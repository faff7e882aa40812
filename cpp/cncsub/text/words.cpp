#include "cncsub/text/words.hpp"

#include <cmath>

namespace cncsub {

namespace {

/// Return the first token of a text that holds no word.
BlockToken between_words(std::string_view text, std::size_t at) {
  BlockToken token;
  token.at = static_cast<std::uint32_t>(at);
  const auto begins_other = [](char c) { return is_blank(c) || c == '(' || c == ';'; };
  std::size_t end = 1;
  if (is_blank(text[0])) {
    token.kind = BlockToken::Kind::Blank;
    while (end < text.size() && is_blank(text[end])) ++end;
  } else if (text[0] == '(') {
    token.kind = BlockToken::Kind::Comment;
    end = text.find(')');
    end = end == std::string_view::npos ? text.size() : end + 1;
  } else if (text[0] == ';') {
    token.kind = BlockToken::Kind::Comment;
    end = text.size();
  } else {
    token.kind = BlockToken::Kind::Ignored;
    while (end < text.size() && !begins_other(text[end])) ++end;
  }
  token.width = static_cast<std::uint32_t>(end);
  return token;
}

}  // namespace

std::string_view to_string(BlockToken::Kind kind) {
  switch (kind) {
    case BlockToken::Kind::Word:
      return "word";
    case BlockToken::Kind::Comment:
      return "comment";
    case BlockToken::Kind::Blank:
      return "blank";
    case BlockToken::Kind::Ignored:
      return "ignored";
  }
  return "";
}

std::optional<BlockToken> TokenReader::next() {
  if (!word_ && !ended_) {
    word_ = read_(block_, from_);
    ended_ = !word_;
  }
  const std::size_t word_at = word_ ? word_->at : block_.size();
  std::optional<BlockToken> token;
  if (done_ < word_at) {
    token = between_words(block_.substr(done_, word_at - done_), done_);
  } else if (word_) {
    token = BlockToken{BlockToken::Kind::Word, word_->at, word_->width, std::move(*word_)};
    word_.reset();
  }
  if (token) done_ = std::size_t{token->at} + token->width;
  return token;
}

bool set_number(WrittenWord& word, const Number& number) {
  word.known = number.any && number.points < 2 && std::fabs(number.value) < kLargest;
  word.value = number.value;
  return number.any;
}

bool take_number(Scanner& s, WrittenWord& word) {
  if (!begins_number(s.peek())) return false;
  return set_number(word, scan_number(s));
}

const char* place_word(WrittenWord& word, std::string_view block, const char* from,
                       const char* to) {
  to = block.data() + end_of_character(block, static_cast<std::size_t>(to - block.data()));
  const char* end = from + 1;
  bool comment = false;
  word.text.clear();
  for (const char* c = from; c < to; ++c) {
    if (*c == '(') comment = true;
    if (!comment && !is_blank(*c)) {
      word.text += *c;
      end = c + 1;
    }
    if (*c == ')') comment = false;
  }
  word.at = static_cast<std::uint32_t>(from - block.data());
  word.width = static_cast<std::uint32_t>(end - from);
  return to;
}

}  // namespace cncsub
