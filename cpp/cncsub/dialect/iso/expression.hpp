// Expressions of the ISO family, compiled into instructions.
#pragma once

#include <cstdint>
#include <optional>

#include "cncsub/dialect/iso/values.hpp"

namespace cncsub {

/// Compiles what stands in brackets, behind an equals sign or behind an address. One reader reads
/// all of a tape, an expression after the other; what is read is passed over by the scanner.
class ExpressionReader : private ValueReader {
 public:
  ExpressionReader(Builder& to, const ExpressionRules& rules) : ValueReader(to, rules) {}

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
    const bool plain = digits_of_variable(number) && !rules_.is_indirect(number);
    const std::optional<Variable> read = plain ? Variable{number, 0} : read_target(s, hash);
    s.at = s_.at;
    return read;
  }

  /// Whether comments may stand in or behind the number that was read last.
  bool comments() const { return comments_; }
  /// What is wrong with the expression that was read last.
  const Fault& fault() const { return out_.fault(); }

 private:
  Value value_of_word(std::uint32_t at);
  std::optional<std::uint32_t> read_condition();
  std::optional<Variable> read_target(const Scanner& s, std::uint32_t hash);
  std::optional<std::uint32_t> finished(Value value, std::uint32_t at, bool negative = false);
};

}  // namespace cncsub
