// Values: 10.5, R1, R[R2 + 1], (1 + 2) * SIN(30), "A" << 5, compiled into instructions.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/code/builder.hpp"
#include "cncsub/code/operators.hpp"
#include "cncsub/dialect/sinumerik/definitions.hpp"
#include "cncsub/dialect/sinumerik/line.hpp"

namespace cncsub::sinumerik {

/// The operators. An operator whose spelling begins another's stands after that one.
extern const std::span<const OperatorRow> kOperators;

using Value = ValueRead;

/// The expression that is being read: where it stands, what it may name, and what is known of it.
struct OpenExpression {
  Builder& to;
  Line& line;
  const Definitions& definitions;
  std::optional<Fault> fault;      // why the last reading failed
  std::optional<double> constant;  // the value is this number, or text, and nothing else
  // What the block has assigned to so far: parameters by their number, variables below 0.
  std::set<std::int32_t> assigned;
  bool assigned_any = false;  // a parameter of a computed number among them
  bool stands_alone = false;  // in no program, so that a text may be one that no program has

  bool wrong(Cause cause, std::string detail, std::uint32_t at);
  bool not_computed(std::string_view what, std::uint32_t at);
  /// Write an instruction whose operator or operand stands at `at`: a value that it cannot make is
  /// a fault there.
  void emit_at(std::uint32_t at, Ins op, double value = 0) {
    to.expressions().emit({op, 0, at, value});
  }
  /// Write an instruction that no place is to blame for but the whole expression.
  void emit(Ins op, double value = 0) { emit_at(0, op, value); }
  /// Write a number, or the number of a text.
  void push_constant(double value) {
    constant = value;
    emit(Ins::Constant, value);
  }
};

/// System variables that a program may write, by their indices: data of tools, markers, outputs.
struct SystemArray {
  std::int32_t first = 0;  // the variable whose indices are all zero
  Definition shape;        // its type, its dimensions and their extents
};
/// Return those of this name, in capitals; nothing where the control has none that are computed.
std::optional<SystemArray> system_array_of(const Builder& to, std::string_view name);

class ExpressionReader {
 public:
  ExpressionReader(Builder& to, Line& line, const Definitions& definitions)
      : open_{to, line, definitions, {}, {}, {}, false}, fault(open_.fault) {}

  /// Read an expression that stands in no program.
  void stand_alone() { open_.stands_alone = true; }
  /// Forget what was read on the block before.
  void begin_block();
  /// Read the number after an address, with its sign.
  bool number(Value& value);
  /// Read the expression after =.
  bool value(Value& value);
  /// Read an expression of any type, which is set.
  bool value_of_any(Value& value, Type& type);
  /// Read the axis of AX[...], whose bracket is passed; `opens`: an expression begins with it.
  bool indexing_axis(bool opens);
  /// Read a value that counts where that axis is this one. Without `opens` it is added to what the
  /// expression has so far.
  bool value_of_axis(int axis, bool opens);
  /// End such an expression, which began at `at`.
  Value indexed_value(std::uint32_t at);
  /// Read a text, or what << makes one of.
  bool text(Value& value);
  /// Read the expression after =, as a value that the variable takes.
  bool value_of(const Definition& of, Value& value);
  /// Set the variable that stands here with nothing but it before the next comma or bracket, which
  /// is not taken; or the array, and its extents. Return false where none does.
  bool variable_alone(Statement& variable, Type& type, std::vector<std::int32_t>& extents);
  /// Read the expression of a condition; `otherwise`: of its negation.
  bool condition(std::uint32_t& expression, bool otherwise = false);
  /// Read R1=5 or R[R2]=R1+1.
  bool assignment(Statement& statement);
  /// Read DEPTH=5 or GRID[1,2]=5, whose name stands here.
  bool assignment(const Definition& to, Statement& statement);
  /// Read the same, or GRID[0,0]=SET(1,2,3), or GRID[0,0]=REP(5).
  bool assignments(const Definition& to, std::vector<Statement>& statements);
  /// Read $P_UIFR[1]=CTRANS(X,10) or $P_PFRAME[X,TR]=5, whose name is passed.
  bool control_frame(std::string_view name, std::uint32_t at, Statement& statement);
  /// Read SET(...), REP(...) or (...), which give elements from `first` on their values.
  bool elements(const Definition& to, const Statement& first, std::vector<Statement>& statements);
  /// Read the indices of a datum, and the value that it is given.
  bool system_array(const SystemArray& of, Statement& statement);
  /// Note that the block gives a variable its value: what comes after in it does not read that.
  void note_assigned(const Definition& of);
  /// Return whether SET(, REP( or, in a definition, a bracket stands here.
  bool is_list(bool bracket_alone);
  /// Append the value of a variable, as one that it takes itself, to the open expression.
  void push_converted(const Definition& of);

 private:
  bool finish(Value& value, std::uint32_t at);
  bool parameter_side(Statement& statement);
  bool left_side(const Definition& to, Statement& statement);
  bool character_side(const Definition& to, Statement& statement);
  bool frame_part_side(const Definition& to, Statement& statement);
  bool assigned_value(const Definition& to, Statement& statement);
  bool set_list(const Definition& to, const Statement& first, std::vector<Statement>& statements);
  bool repeated(const Definition& to, const Statement& first, std::vector<Statement>& statements);

  OpenExpression open_;

 public:
  std::optional<Fault>& fault;  // why the last reading failed
};

}  // namespace cncsub::sinumerik
