// Values: numbers, #5, #<name>, [1 + 2], SIN[30], compiled into instructions.
#pragma once

#include <optional>
#include <string>
#include <unordered_set>

#include "cncsub/dialect/ngc_values.hpp"

namespace cncsub::linuxcnc {

/// The largest number that a program can name, except commons that were given to the control.
/// [rs274 2.9: #5602 is out of range]
inline constexpr std::int64_t kLastVariable = 5601;

using Line = BareLine;
using Value = ValueRead;

/// A variable that is assigned to.
struct Place {
  Statement::Target target = Statement::Target::None;
  std::int32_t index = 0;
  std::uint32_t number = 0;  // Indirect: the expression of its number
};

class ExpressionReader {
 public:
  ExpressionReader(Builder& to, Line& line) : to_(to), line_(line) {}

  /// Forget what was read on the line before.
  void begin_line() { set_here_.clear(); }

  /// Read the value that stands here; return false if there is none: then `fault` says why.
  bool value(Value& value);
  /// Read a value in brackets.
  bool bracketed(Value& value);
  /// Read a value that is whole or nearly so.
  bool whole(Value& value);
  /// Read the variable after the # of an assignment.
  bool place(Place& place);
  /// Read the variable of a DEBUG comment: `#5` or `#<name>`. Its value is vacant if it is not set.
  bool shown(Value& value);

  std::optional<Fault> fault;

 private:
  friend class NgcOperators<ExpressionReader>;
  bool named_place(Place& place);
  bool read_value(int depth);
  bool read_bracket(int depth);
  bool read_number();
  bool read_variable(int depth);
  bool read_named();
  bool read_function(int depth);
  bool read_arctangent(int depth);
  bool read_exists(int depth);
  bool read_name(std::string& name, std::size_t place);
  bool wrong(Cause cause, std::string text, std::size_t place);
  bool finish(Value& value, std::uint32_t at);
  void emit(Ins op, double value = 0, std::uint32_t index = 0);
  /// Write an instruction whose operator or operand stands at `at`.
  void emit_at(std::uint32_t at, Ins op, double value = 0);
  /// Return the number of the variable that the last value names; nothing if there is no such
  /// variable: `fault` says why.
  std::optional<std::int64_t> variable_number(std::size_t place);
  /// Return the whole number that a value nearly is; nothing if it is not whole: `fault` says why.
  std::optional<double> whole_number(double value, std::size_t place);

  Builder& to_;
  Line& line_;
  std::unordered_set<std::string> set_here_;  // named variables that the line has assigned to
  std::optional<double> constant_;            // the last value was this number and nothing else
};

/// Return whether a variable cannot be assigned to.
bool is_read_only(std::int64_t number);

}  // namespace cncsub::linuxcnc
