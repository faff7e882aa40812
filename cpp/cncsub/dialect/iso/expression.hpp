// Expressions of the ISO family, compiled into instructions.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "cncsub/code/builder.hpp"
#include "cncsub/dialect/iso/operators.hpp"
#include "cncsub/dialect/iso/value_writer.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

/// Compiles what stands in brackets, behind an equals sign or behind an address. One reader reads
/// all of a tape, an expression after the other; what is read is passed over by the scanner.
class ExpressionReader {
 public:
  ExpressionReader(Builder& to, const ExpressionRules& rules);

  const ExpressionRules& rules() const { return rules_; }
  /// An expression that gives a number; nothing where it is faulty (see `fault`). Reads as far as
  /// the expression goes.
  std::optional<std::uint32_t> number(Scanner& s);
  /// The value behind an address: `#1`, `-#1`, `[...]`, `-[...]`. In a word, ROUND rounds to the
  /// address's increment.
  std::optional<std::uint32_t> word_value(Scanner& s, char address);
  /// The condition of IF and WHILE, brackets included.
  std::optional<std::uint32_t> condition(Scanner& s);
  /// What stands behind the # of a variable, which is at `hash`: its number, or an expression that
  /// gives it.
  struct Variable {
    std::int64_t number = -1;
    std::uint32_t expression = 0;
  };
  std::optional<Variable> variable(Scanner& s, std::uint32_t hash) {
    begin(s);
    return variable_here(hash);
  }

  /// What is wrong with the expression that was read last.
  const Fault& fault() const { return out_.fault(); }

 private:
  static constexpr std::ptrdiff_t kMostVariableDigits = 9;

  void begin(Scanner& s, char address = 0) {
    s_ = &s;
    out_.begin(address);
    last_ = waiting_.get() + 1;
    brackets_ = nots_ = 0;
  }
  std::uint32_t offset(const char* at) const { return static_cast<std::uint32_t>(at - s_->file); }

  /// Whether a number that was read as far as `at` ends there for certain: it may go on behind a
  /// gap and with another point.
  bool ends_at(const char* at) const {
    return at == s_->end || (at < s_->end && !begins_gap(*at) && *at != '.');
  }
  /// The number behind a #, where it is digits and nothing else.
  std::optional<std::uint32_t> plain_number(const char*& at) const {
    const char* end = at;
    std::uint32_t number = 0;
    for (; is_digit(*end); ++end) number = number * 10 + static_cast<std::uint32_t>(*end - '0');
    const std::ptrdiff_t digits = end - at;
    if (digits == 0 || digits > kMostVariableDigits || rules_.indirect || !ends_at(end))
      return std::nullopt;
    at = end;
    return number;
  }

  // A place in the text that is handed on stays in a register; whoever is not given one reads on
  // from the scanner's.
  Value expression() { return values(last_, false); }
  Value operand_alone() { return values(last_, true); }
  Value bracket();
  Value values(const Waiting* base, bool alone);

  Value other_operand();
  Value other_constant();
  Value sign();
  Refused no_operand();

  /// What is read next is the value of what waits.
  Value wait(Waiting::Kind kind, std::uint32_t at, const FunctionName* function = nullptr) {
    Waiting& waiting = *last_++;
    waiting.level = kind <= Waiting::Kind::Not ? Waiting::kPrefix : Waiting::kOpening;
    waiting.kind = kind;
    waiting.at = at;
    waiting.first = out_.first();
    waiting.function = function;
    waiting.second = false;
    return Value::awaited();
  }
  Value open(Waiting::Kind kind, std::uint32_t at, const FunctionName* function = nullptr);
  bool opens();
  bool closes();
  Value prefixed(Value value);

  // ---- values.cpp ----
  Value operand(const char*& at);
  Value constant(const char*& at);
  Value near_variable(const char*& at);
  bool opens_here(const char*& at);
  Value closed(Value value, const char*& at);
  Value function(const Waiting& of);
  Value behind(Value value, const Waiting* base, bool alone, const char*& at);
  Value operates(const OperatorName& of, Value value, const char*& at);
  bool is_of_numbers(const OperatorName& of, const Value& value) const;
  Value join(Value value, int level, const char* at);

  // ---- variables.cpp ----
  Value other_variable();
  std::optional<Variable> variable_here(std::uint32_t hash) {
    if (const auto number = plain_number(s_->at)) return Variable{*number, 0};
    return other_target(hash);
  }
  std::optional<Variable> other_target(std::uint32_t hash);
  std::optional<std::int64_t> variable_number(std::uint32_t at);
  std::optional<std::int64_t> written_number();

  // ---- functions.cpp ----
  Value word();
  Value not_closed(Waiting& of, bool argument);
  Value other_closed(const Waiting& of, Value value);
  Value arc_tangent(const Waiting& of);
  Value programmed(std::uint32_t at);
  Value negation(std::uint32_t at);
  Value negated(const Waiting& of, Value value);

  const ExpressionRules& rules_;
  Names& names_;
  ValueWriter out_;
  Scanner* s_ = nullptr;
  std::unique_ptr<Waiting[]> waiting_;  // NOLINT(*-avoid-c-arrays): up to `last_`
  Waiting* last_ = nullptr;
  int brackets_ = 0;
  int nots_ = 0;  // NOT before NOT
};

}  // namespace cncsub
