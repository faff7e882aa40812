// Chooses how an expression is computed, by its instructions: in the shortest form where it is one
// value, or one operation on two.
#pragma once

#include "cncsub/code/expression.hpp"

namespace cncsub {

struct ExpressionForm {
  using Form = Expression::Form;

  Form form;
  Ins op = Ins::Constant;  // of two values: what joins them

  /// Return the form of the instructions from `at` to `end`, which do not hold the End.
  static ExpressionForm of(const ExpressionCell* at, const ExpressionCell* end);

 private:
  static constexpr bool is_variable(Ins op) { return op >= Ins::Local && op <= Ins::CommonRaw; }
  static_assert(static_cast<int>(Ins::CommonRaw) - static_cast<int>(Ins::Local) == 3);
  static constexpr bool is_of_two(Ins op) {
    return (op >= Ins::Equal && op <= Ins::AlikeLessEqual) ||
           (op >= Ins::Add && op <= Ins::Multiply);
  }

  /// Return the same operation on two values.
  static constexpr Ins without_constant(Ins op) {
    return op == Ins::AddConstant        ? Ins::Add
           : op == Ins::SubtractConstant ? Ins::Subtract
           : op == Ins::MultiplyConstant ? Ins::Multiply
                                         : Ins::End;
  }
};

inline ExpressionForm ExpressionForm::of(const ExpressionCell* at, const ExpressionCell* end) {
  const Ins first = at->op();
  switch (end - at) {
    case 1:
      if (is_variable(first)) return {Form::Variable};
      break;
    case 2:
      if (first == Ins::Constant) return {Form::Constant};
      break;
    case 3:
      if (!is_variable(first)) break;
      if (const Ins op = without_constant(at[1].op()); op != Ins::End)
        return {Form::VariableAndConstant, op};
      if (is_variable(at[1].op()) && is_of_two(at[2].op())) return {Form::TwoVariables, at[2].op()};
      break;
    case 4:
      if (!is_of_two(at[3].op())) break;
      if (first == Ins::Constant && is_variable(at[2].op()))
        return {Form::ConstantAndVariable, at[3].op()};
      if (is_variable(first) && at[1].op() == Ins::Constant)
        return {Form::VariableToConstant, at[3].op()};
      break;
    default:
      break;
  }
  return {Form::Long};
}

}  // namespace cncsub
