// Expressions of the ISO family, compiled into instructions.
#pragma once

#include <cstdint>
#include <optional>

#include "cncsub/dialect/iso/open_expression.hpp"
#include "cncsub/dialect/iso/plain_expression.hpp"

namespace cncsub {

/// Compiles what stands in brackets, behind an equals sign or behind an address. One reader reads
/// all of a tape, an expression after the other; what is read is passed over by the scanner.
class ExpressionReader {
 public:
  ExpressionReader(Builder& to, const ExpressionRules& rules) : e_(to, rules), plain_(e_.out) {}

  const ExpressionRules& rules() const { return e_.rules; }
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
    e_.s = &s;
    std::uint32_t number = 0;
    const char* const end = e_.plain_number(s.at, number);
    if (end == nullptr) return other_target(s, hash);
    s.at = end;
    return Variable{number, 0};
  }

  /// Whether comments may stand in or behind the number that was read last.
  bool comments() const { return comments_; }
  /// What is wrong with the expression that was read last.
  const Fault& fault() const { return e_.out.fault(); }

 private:
  /// The value of what is that plain, which is passed over.
  static Value taken(Scanner& s, const PlainValue& plain) {
    if (plain.value) s.at = plain.at;
    return plain.value;
  }
  Value expression() { return values(e_.last, false); }
  Value operand_alone() { return values(e_.last, true); }
  Value bracket();
  Value values(const Waiting* base, bool alone);
  std::optional<Variable> other_target(Scanner& s, std::uint32_t hash);

  OpenExpression e_;
  PlainExpression plain_;
  bool comments_ = true;
};

inline std::optional<std::uint32_t> ExpressionReader::number(Scanner& s) {
  e_.out.begin(0);
  s.blanks();
  const std::uint32_t at = s.offset();
  Value value = taken(s, plain_.read(s));
  comments_ = !value || plain_.comments();
  if (!value) {
    e_.begin(s);
    value = expression();
  }
  if (!value) return std::nullopt;
  if (!e_.out.is_number(value))
    return e_.out.refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  return e_.out.finish(at, s.offset() - at);
}

}  // namespace cncsub
