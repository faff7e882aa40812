#include "cncsub/dialect/iso/expression_scanner.hpp"

#include <string>

namespace cncsub {

void ExpressionScanner::pass_gap() {
  if (s_.at == s_.end) return;
  if (*s_.at == ' ' && !begins_gap(s_.at[1])) {
    ++s_.at;
    return;
  }
  comments_ = true;
  s_.pass_gap();
}

bool ExpressionScanner::opens_behind_gap() {
  const bool here = peek() == '[';
  const std::uint32_t at = offset();
  if (!here) {
    out_.refuse(Cause::BracketNotOpened, at, "an opening bracket is missing here");
    return false;
  }
  ++s_.at;
  ++brackets_;
  if (brackets_ <= rules_.most_brackets) return true;
  out_.refuse(Cause::BracketsTooDeep, at,
              "more than " + std::to_string(rules_.most_brackets) + " brackets inside each other");
  return false;
}

/// Take a closing bracket after a gap, or refuse the text that stands in its place.
bool ExpressionScanner::not_closed() {
  const char c = peek();
  if (c == ']') return closes();
  if (c == '\0')
    out_.refuse(Cause::BracketNotClosed, offset(), "a closing bracket is missing");
  else
    out_.refuse(Cause::ExpressionFormat, offset(),
                "an operator or a closing bracket is missing here");
  return false;
}

}  // namespace cncsub
