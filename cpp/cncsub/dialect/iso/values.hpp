// The values of an expression and the operators between them, compiled into instructions.
#pragma once

#include <cstdint>
#include <optional>

#include "cncsub/dialect/iso/expression_scanner.hpp"
#include "cncsub/dialect/iso/operators.hpp"

namespace cncsub {

class ValueReader : protected ExpressionScanner {
 public:
  using Value = cncsub::Value;
  using Operator = IsoOperator;

  // The parts of an expression, for read_operators.
  Value operand();
  const IsoOperator* next_operator();
  template <class Left>
  int level_of(const IsoOperator& of, Value& value, Left& left);
  using ExpressionScanner::offset;
  void pass(const IsoOperator&) { s_.at = behind_operator_; }
  Value apply(const IsoOperator& of, std::uint32_t at, Value left, Value right) {
    if (rules_.structured) [[unlikely]]
      return apply_typed(of, at, left, right);
    return cncsub::apply(out_, of, at, left, right, offset());
  }

 protected:
  static constexpr std::int64_t kComputed = -1;
  static constexpr int kMostNots = 64;  // whose value is still to come

  ValueReader(Builder& to, const ExpressionRules& rules)
      : ExpressionScanner(to, rules), names_(to.names()) {}

  /// Read operands and the operators between them, as far as the text goes.
  Value values();
  /// Read a value with its signs, but no operator after it.
  Value one_operand();
  /// Read a value in brackets.
  Value bracket();
  /// Return the number of a variable that is not in brackets, if it is written after the # at `at`.
  /// Else write instructions that give the number and return kComputed.
  std::optional<std::int64_t> variable_number(std::uint32_t at);

  /// Write what the sign of a variable at `at` adds to its computed number.
  void add_base(std::uint32_t at) {
    if (const std::int32_t base = rules_.base_of(at); base != 0)
      out_.emit(Ins::AddConstant, at, base);
  }

 private:
  // Of structured programs (structured_values.cpp).
  Value structured_operand(char first);
  Value behind_sign(std::uint32_t at);
  Value with_type(Value value, std::uint32_t at);
  Value typed_constant();
  Value typed_negation_of(Value value, std::uint32_t at);
  Value typed_function();
  bool typed_arguments(int count, bool& whole, bool& real);
  const IsoOperator* structured_operator();
  Value apply_typed(const IsoOperator& of, std::uint32_t at, Value left, Value right);

  const IsoOperator* operator_of_name();
  Value constant();
  Value other_constant();
  Value with_sign();
  Value negation(std::uint32_t at);
  Value word();
  Value other_word();
  bool argument();
  Value arguments(const FunctionName& of, std::uint32_t at);
  Value arc_tangent(std::uint32_t at, bool two);
  Value programmed(std::uint32_t at);
  Refused no_operand();
  Value variable();
  Value other_variable(std::uint32_t at);
  std::optional<std::int64_t> written_number();

  Names& names_;
  const char* behind_operator_ = nullptr;  // after the operator that was found last
};

}  // namespace cncsub
