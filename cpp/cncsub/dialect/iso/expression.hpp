// Expressions of the ISO family, compiled into instructions.
#pragma once

#include <cstdint>
#include <optional>

#include "cncsub/dialect/iso/values.hpp"

namespace cncsub {

/// The compiler of expressions in brackets, after an equals sign or after an address. One reader
/// reads all expressions of a tape, one after the other, and moves the scanner past each.
class ExpressionReader : private ValueReader {
 public:
  ExpressionReader(Builder& to, const ExpressionRules& rules) : ValueReader(to, rules) {}

  const ExpressionRules& rules() const { return rules_; }
  /// Read an expression that gives a number, as far as it goes; nothing if it is faulty (see
  /// `fault`).
  std::optional<std::uint32_t> number(Scanner& s);
  /// Read the value after an address: `#1`, `-#1`, `[...]`, `-[...]`. In a word, ROUND rounds to
  /// the address's increment.
  std::optional<std::uint32_t> word_value(Scanner& s, char address);
  /// Return whether the value of a word goes on here by arithmetic without brackets: `#1+10`.
  bool goes_on(const Scanner& s) const;
  /// Read a value with such arithmetic, from its beginning.
  std::optional<std::uint32_t> arithmetic_of_word(Scanner& s, char address);
  /// Read the condition of IF or WHILE, brackets included.
  std::optional<std::uint32_t> condition(Scanner& s);
  /// Read the value that a counter takes next: the variable at `counter`, plus the step that is
  /// written at `step`, or 1.
  std::optional<std::uint32_t> counted(const Scanner& counter, const Scanner* step);
  /// Read the condition that a counter has not passed its last value, whatever the sign of its
  /// step.
  std::optional<std::uint32_t> not_passed(const Scanner& counter, const Scanner& last,
                                          const Scanner& step);
  /// Read a condition, and return the contrary one.
  std::optional<std::uint32_t> contrary(Scanner& s);
  /// Read a condition without the brackets around it, or an expression that gives a number.
  std::optional<std::uint32_t> condition_or_number(Scanner& s);
  /// The variable after a # (at `hash`): its number, or an expression that gives the number.
  struct Variable {
    std::int64_t number = -1;
    std::uint32_t expression = 0;
  };
  std::optional<Variable> variable(Scanner& s, std::uint32_t hash) {
    s_ = s;
    std::uint32_t number = 0;
    const bool plain = digits_of_variable(number) && !rules_.needs_look(number);
    const std::optional<Variable> read = plain ? Variable{number, 0} : read_target(s, hash);
    s.at = s_.at;
    return read;
  }

  /// Return the value that was read last, if it was one of a number: its type is known or not.
  const Value& last_value() const { return last_; }
  /// Return whether comments may stand in or after the number that was read last.
  bool comments() const { return comments_; }
  /// Return the fault of the expression that was read last.
  const Fault& fault() const { return out_.fault(); }

 private:
  Value value_of_word(std::uint32_t at);
  std::optional<std::uint32_t> read_condition();
  std::optional<Variable> read_target(const Scanner& s, std::uint32_t hash);
  std::optional<std::uint32_t> finished(Value value, std::uint32_t at, bool negative = false);

  Value last_;
};

}  // namespace cncsub
