// Expressions of the ISO family, compiled into instructions.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cncsub/code/builder.hpp"
#include "cncsub/dialect/iso/operators.hpp"
#include "cncsub/dialect/iso/value_writer.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

/// Compiles what stands in brackets, behind an equals sign or behind an address. One reader reads
/// all of a tape, an expression after the other; what is read is passed over by the scanner.
class ExpressionReader {
 public:
  using Value = cncsub::Value;
  using Operator = IsoOperator;

  ExpressionReader(Builder& to, const ExpressionRules& rules)
      : rules_(rules), names_(to.names()), out_(to, rules), written_(out_.instructions()) {}

  const ExpressionRules& rules() const { return rules_; }
  /// An expression that gives a number; nothing where it is faulty (see `fault`). Reads as far as
  /// the expression goes.
  std::optional<std::uint32_t> number(Scanner& s);
  /// The value behind an address: `#1`, `-#1`, `[...]`, `-[...]`. In a word, ROUND rounds to the
  /// address's increment.
  std::optional<std::uint32_t> word_value(Scanner& s, char address);
  /// Whether the value of a word goes on here by arithmetic without brackets: `#1+10`.
  bool goes_on(const Scanner& s) const;
  /// The same value, from its beginning.
  std::optional<std::uint32_t> arithmetic_of_word(Scanner& s, char address);
  /// The condition of IF and WHILE, brackets included.
  std::optional<std::uint32_t> condition(Scanner& s);
  /// What stands behind the # of a variable, which is at `hash`: its number, or an expression that
  /// gives it.
  struct Variable {
    std::int64_t number = -1;
    std::uint32_t expression = 0;
  };
  std::optional<Variable> variable(Scanner& s, std::uint32_t hash) {
    s_ = s;
    std::uint32_t number = 0;
    const bool plain = digits_of_variable(number) && !is_indirect(number);
    const std::optional<Variable> read = plain ? Variable{number, 0} : read_target(s, hash);
    s.at = s_.at;
    return read;
  }

  /// Whether comments may stand in or behind the number that was read last.
  bool comments() const { return comments_; }
  /// What is wrong with the expression that was read last.
  const Fault& fault() const { return out_.fault(); }

  // The parts of an expression, for read_operators.
  Value operand();
  const IsoOperator* next_operator();
  template <class Left>
  int level_of(const IsoOperator& of, Value& value, Left& left);
  std::uint32_t offset() const { return s_.offset(); }
  void pass(const IsoOperator&) { s_.at = behind_operator_; }
  Value apply(const IsoOperator& of, std::uint32_t at, Value left, Value right) {
    return cncsub::apply(out_, of, at, left, right, offset());
  }

 private:
  static constexpr std::int64_t kComputed = -1;

  void begin(const Scanner& s, char address = 0) {
    s_ = s;
    out_.begin(address);
    brackets_ = nots_ = 0;
    comments_ = false;
  }
  Value value_of_word(std::uint32_t at);
  std::optional<std::uint32_t> read_condition();
  std::optional<Variable> read_target(const Scanner& s, std::uint32_t hash);
  std::optional<std::uint32_t> finished(Value value, std::uint32_t at, bool negative = false);

  Value values();
  Value one_operand();
  Value bracket();
  bool opens();
  bool opens_behind_gap();
  bool closes();
  bool not_closed();
  const IsoOperator* operator_of_name();
  bool is_indirect(std::int64_t number) const {
    return rules_.indirect && number >= 9000 && number <= 9999;
  }
  bool number_goes_on(const char* at) const;
  bool digits_of_variable(std::uint32_t& number);
  Value constant();
  Value other_constant();
  Value with_sign();
  Value negation(std::uint32_t at);
  Value word();
  Value other_word();
  Value arguments(const FunctionName& of, std::uint32_t at);
  Value arc_tangent(std::uint32_t at, bool two);
  Value programmed(std::uint32_t at);
  Refused no_operand();
  Value variable();
  Value written_variable();
  Value other_variable(std::uint32_t at);
  std::optional<std::int64_t> variable_number(std::uint32_t at);
  std::optional<std::int64_t> written_number();

  void gap() {
    if (begins_gap(*s_.at)) [[unlikely]]
      pass_gap();
  }
  void pass_gap();
  char peek() {
    gap();
    return s_.at == s_.end ? '\0' : upper(*s_.at);
  }
  bool take(char c) { return peek() == c && (++s_.at, true); }
  void put(Ins op, std::uint32_t at) { written_.put(ExpressionCell::of(op, out_.address(), at)); }

  const ExpressionRules& rules_;
  Names& names_;
  ValueWriter out_;
  OpenInstructions& written_;
  Scanner s_;
  const char* behind_operator_ = nullptr;  // behind the one that was found last
  int brackets_ = 0;                       // that are open
  int nots_ = 0;                           // that wait
  bool comments_ = true;
};

/// Whether a number that was read as far as `at` goes on, behind a gap or with another point.
inline bool ExpressionReader::number_goes_on(const char* at) const {
  if (at >= s_.end) return at > s_.end;
  if (!begins_gap(*at)) [[likely]]
    return *at == '.';
  Scanner ahead{at, s_.end, s_.file};
  const char next = ahead.peek();
  return is_digit(next) || next == '.';
}

/// Reads the number behind a #, where it is digits and nothing else.
inline bool ExpressionReader::digits_of_variable(std::uint32_t& number) {
  const char* at = s_.at;
  for (std::uint32_t digit = 0; (digit = static_cast<std::uint32_t>(*at - '0')) <= 9; ++at)
    number = number * 10 + digit;
  if (at == s_.at || at - s_.at > ExpressionRules::kMostVariableDigits || number_goes_on(at))
      [[unlikely]]
    return false;
  s_.at = at;
  return true;
}

inline bool ExpressionReader::opens() {
  if (s_.at < s_.end && *s_.at == '[' && brackets_ < rules_.most_brackets) [[likely]] {
    ++s_.at;
    ++brackets_;
    return true;
  }
  return opens_behind_gap();
}

inline bool ExpressionReader::closes() {
  if (s_.at >= s_.end || *s_.at != ']') return not_closed();
  ++s_.at;
  --brackets_;
  return true;
}

}  // namespace cncsub
