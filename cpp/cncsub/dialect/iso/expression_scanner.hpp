// The text of an expression as it is read: gaps, digits and brackets.
#pragma once

#include <cstdint>

#include "cncsub/code/builder.hpp"
#include "cncsub/dialect/iso/value_writer.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

/// The place where an expression is read, the brackets open there, and its instructions.
class ExpressionScanner {
 protected:
  ExpressionScanner(Builder& to, const ExpressionRules& rules)
      : rules_(rules), out_(to, rules), written_(out_.instructions()) {}

  void begin(const Scanner& s, char address = 0) {
    s_ = s;
    out_.begin(address);
    brackets_ = nots_ = 0;
    comments_ = false;
  }
  std::uint32_t offset() const { return s_.offset(); }

  /// Pass over blanks and comments.
  void gap() {
    if (begins_gap(*s_.at)) [[unlikely]]
      pass_gap();
  }
  char peek() {
    gap();
    return s_.at == s_.end ? '\0' : upper(*s_.at);
  }
  bool take(char c) { return peek() == c && (++s_.at, true); }
  /// Return whether a number that was read up to `at` goes on, after a gap or with another point.
  bool number_goes_on(const char* at) const;
  /// Read the number after a # if it consists of digits only.
  bool digits_of_variable(std::uint32_t& number);
  /// Take the bracket that opens or closes here; false if it is missing, which is reported.
  bool opens();
  bool closes();
  void put(Ins op, std::uint32_t at) { written_.put(ExpressionCell::of(op, out_.address(), at)); }

  const ExpressionRules& rules_;
  ValueWriter out_;
  OpenInstructions& written_;
  Scanner s_;
  int brackets_ = 0;      // open brackets
  int nots_ = 0;          // NOT whose condition is still to come
  bool comments_ = true;  // may stand in the text that was read, or after it

 private:
  void pass_gap();
  bool opens_behind_gap();
  bool not_closed();
};

inline bool ExpressionScanner::number_goes_on(const char* at) const {
  if (at >= s_.end) return at > s_.end;
  if (!begins_gap(*at)) [[likely]]
    return *at == '.';
  Scanner ahead{at, s_.end, s_.file};
  const char next = ahead.peek();
  return is_digit(next) || next == '.';
}

inline bool ExpressionScanner::digits_of_variable(std::uint32_t& number) {
  const char* at = s_.at;
  for (std::uint32_t digit = 0; (digit = static_cast<std::uint32_t>(*at - '0')) <= 9; ++at)
    number = number * 10 + digit;
  if (at == s_.at || at - s_.at > ExpressionRules::kMostVariableDigits || number_goes_on(at))
      [[unlikely]]
    return false;
  s_.at = at;
  return true;
}

inline bool ExpressionScanner::opens() {
  if (s_.at < s_.end && *s_.at == '[' && brackets_ < rules_.most_brackets) [[likely]] {
    ++s_.at;
    ++brackets_;
    return true;
  }
  return opens_behind_gap();
}

inline bool ExpressionScanner::closes() {
  if (s_.at >= s_.end || *s_.at != ']') return not_closed();
  ++s_.at;
  --brackets_;
  return true;
}

}  // namespace cncsub
