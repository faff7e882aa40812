// What the values of the RS274/NGC family have in common: operators, functions, variables with
// names.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cncsub/code/builder.hpp"
#include "cncsub/code/operators.hpp"
#include "cncsub/dialect/bare_line.hpp"
#include "cncsub/dialect/dialect.hpp"

namespace cncsub {

struct NgcFunction {
  std::string_view name;
  Ins op;
};
/// The functions of one value. EXP is the power of e: its base is written before the value.
extern const std::span<const NgcFunction> ngc_functions;
constexpr double kEuler = 2.71828182845904523536;

/// The operators, all left-associative, powers too. One whose spelling begins another's stands
/// after that one.
extern const std::span<const OperatorRow> ngc_operators;

/// The reader of the values of one pair of brackets, for `read_operators`. `Expression` reads the
/// operands.
template <class Expression>
class NgcOperators {
 public:
  using Value = bool;  // whether one was read
  using Operator = OperatorRow;

  NgcOperators(Expression& to, int depth) : to_(to), depth_(depth) {}

  bool operand() { return to_.read_value(depth_); }
  const OperatorRow* next_operator() const {
    const std::string_view rest = to_.line_.rest();
    for (const OperatorRow& of : ngc_operators)
      if (rest.starts_with(of.spelling)) return &of;
    return nullptr;
  }
  template <class Left>
  int level_of(const OperatorRow& of, bool /*value*/, const Left& /*left*/) const {
    return of.level;
  }
  std::uint32_t offset() const { return to_.line_.offset(); }
  void pass(const OperatorRow& of) { to_.line_.take(of.spelling); }
  bool apply(const OperatorRow& of, std::uint32_t at, bool /*left*/, bool /*right*/) {
    to_.to_.expressions().emit({of.op, 0, at, 0});
    to_.constant_.reset();
    return true;
  }

 private:
  Expression& to_;
  int depth_;
};

/// Write an instruction for the text at this place of the line.
void ngc_push(Builder& to, const BareLine& line, Ins op, double value = 0, std::uint32_t index = 0);
/// Write the instruction that reads a variable with a number.
void ngc_push_load(Builder& to, const BareLine& line, std::int64_t number);
/// Write the instruction that reads a variable with a name; its value is vacant if it is not set.
void ngc_push_raw(Builder& to, const BareLine& line, const std::string& name);

/// Return the place of a name among Code::named_variables. Those that begin with _ are everybody's.
std::uint32_t ngc_named(Builder& to, const std::string& name);
/// Return the variable of a name.
const NamedVariable& ngc_variable(Builder& to, const std::string& name);
/// Let an assignment go to a variable with a number. `Place` has a target and an index.
template <class Place>
void ngc_assign_to(const Builder& to, std::int64_t number, Place& place) {
  using Target = Statement::Target;
  const VariablePlace where = to.code().place(number);
  place.target = where.is_local()    ? Target::Local
                 : where.is_common() ? Target::Common
                                     : Target::Variable;
  place.index = place.target == Target::Variable ? static_cast<std::int32_t>(number) : where.index;
}

/// Let a statement assign a value to a place, which has a target, an index and a number.
template <class Place>
void ngc_assign(Builder& to, Statement& statement, const Place& place, const ValueRead& value) {
  statement.expression = to.expressions().expression_of(value);
  statement.target = place.target;
  statement.index = place.index;
  statement.variable = place.number;
  statement.at = value.at;
  statement.width = value.width;
}

/// Compile a text as an expression in brackets. `Expression` is a reader of values.
template <class Expression>
std::optional<Fault> ngc_expression(Builder& to, const ExpressionText& text,
                                    std::uint32_t& expression) {
  BareLine line;
  line.set("[" + std::string(text.text) + "]", text.at - 1);
  Expression reader(to, line);
  ValueRead value;
  if (!reader.bracketed(value)) return reader.fault;
  if (!line.at_end())
    return Fault{Cause::ExpressionFormat, line.offset(), 1, "the expression ends before this"};
  expression = to.expressions().expression_of(value);
  return std::nullopt;
}

/// A named variable that the control answers itself, as an expression.
struct BuiltIn {
  struct Step {
    Ins op = Ins::End;
    double value = 0;  // a constant or a variable number; of Common: 0 what was returned, 1 whether
  };
  std::string_view name;
  std::array<Step, 4> steps;
};
/// The steps of one.
namespace built_in {

using Step = BuiltIn::Step;

// The control keeps its own state at these numbers, beyond those that programs can name.
constexpr double kModal = 14000, kWord = 14100, kMachine = 15020, kWork = 15040;

constexpr Step modal(int group) { return {Ins::Variable, kModal + group}; }
constexpr Step word(char address) { return {Ins::Variable, kWord + (address - 'A')}; }
constexpr Step machine(int axis) { return {Ins::Variable, kMachine + axis}; }
constexpr Step work(int axis) { return {Ins::Variable, kWork + axis}; }
constexpr Step number(double value) { return {Ins::Constant, value}; }
constexpr Step equal() { return {Ins::Equal, 0}; }
constexpr Step times() { return {Ins::Multiply, 0}; }

}  // namespace built_in

/// Return the one of this name; null where there is none.
const BuiltIn* find_built_in(std::span<const BuiltIn> all, std::string_view name);
/// Write the instructions of one.
void ngc_push_built_in(Builder& to, const BareLine& line, const BuiltIn& of);

}  // namespace cncsub
