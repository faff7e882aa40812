// Values: 10.5, R1, R[R2 + 1], (1 + 2) * SIN(30), compiled into instructions.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>

#include "cncsub/code/builder.hpp"
#include "cncsub/code/operators.hpp"
#include "cncsub/dialect/sinumerik/definitions.hpp"
#include "cncsub/dialect/sinumerik/line.hpp"

namespace cncsub::sinumerik {

/// The operators. An operator whose spelling begins another's stands after that one.
extern const std::span<const OperatorRow> kOperators;

using Value = ValueRead;

class ExpressionReader {
 public:
  ExpressionReader(Builder& to, Line& line, const Definitions& definitions)
      : to_(to), line_(line), definitions_(definitions) {}

  /// Forget what was read on the block before.
  void begin_block();
  /// Read the number after an address, with its sign.
  bool number(Value& value);
  /// Read the expression after =.
  bool value(Value& value);
  /// Read the expression after =, as a value of this type.
  bool value_of(Type type, Value& value);
  /// Return the variable that stands here with nothing but it before the next comma or bracket. It
  /// is not taken.
  Statement variable_alone();
  /// Read the expression of a condition; `otherwise`: of its negation.
  bool condition(std::uint32_t& expression, bool otherwise = false);
  /// Read R1=5 or R[R2]=R1+1.
  bool assignment(Statement& statement);
  /// Read DEPTH=5, whose name stands here.
  bool assignment(const Definition& to, Statement& statement);
  /// Append the value of a variable to the open expression.
  void push(const Definition& of);
  /// Append the conversion of the last value of the open expression to a type.
  void convert(Type type);

  std::optional<Fault> fault;  // why the last reading failed

 private:
  friend class OperatorReader;
  bool read(int depth);
  bool read_operand(int depth);
  bool read_number();
  bool read_variable(const Definition& of, std::string_view name);
  bool read_parameter(int depth);
  bool read_system_variable();
  bool read_signed(char sign, std::string_view name, int depth);
  bool read_values(int count, std::uint32_t at, int depth);
  bool read_function(std::string_view name, int depth);
  bool read_bracket(char open, char close, int depth);
  bool is_uncomputed_operator();
  bool parameter_number(std::string_view digits, std::uint32_t at, VariablePlace& place,
                        std::int32_t& number);
  bool assigned_value(Type type, Statement& statement);
  bool late(std::uint32_t at);
  bool wrong(Cause cause, std::string detail, std::uint32_t at);
  bool not_computed(std::string_view what, std::uint32_t at);
  bool finish(Value& value, std::uint32_t at);
  void emit(Ins op, double value = 0);

  Builder& to_;
  Line& line_;
  const Definitions& definitions_;
  std::set<std::int32_t>
      assigned_;                    // parameters that the block has assigned to; below 0: variables
  bool assigned_any_ = false;       // one of a computed number among them
  std::optional<double> constant_;  // the value is this number and nothing else
};

}  // namespace cncsub::sinumerik
