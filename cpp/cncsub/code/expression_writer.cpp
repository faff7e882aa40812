#include "cncsub/code/expression_writer.hpp"

#include <algorithm>

namespace cncsub {

namespace {

using Form = Expression::Form;

constexpr bool is_variable(Ins op) { return held_by(op) == Holds::Variable; }
constexpr bool compares(Ins op) { return op >= Ins::Equal && op <= Ins::LessEqual; }
constexpr bool joins(Ins op) { return op >= Ins::Add && op <= Ins::Multiply; }

/// The same operation on two values.
constexpr Ins without_constant(Ins op) {
  return op == Ins::AddConstant        ? Ins::Add
         : op == Ins::SubtractConstant ? Ins::Subtract
         : op == Ins::MultiplyConstant ? Ins::Multiply
                                       : Ins::End;
}

/// How the instructions from `at` to `end`, which do not hold the End, are computed.
ExpressionCell head_of(const ExpressionCell* at, const ExpressionCell* end, std::uint32_t width) {
  const std::ptrdiff_t count = end - at;
  const auto head = [width](Form form, Ins op) { return Expression::head(form, op, width); };
  if (count == 2 && at->op() == Ins::Constant) return head(Form::Constant, Ins::End);
  if (count == 4 && at->op() == Ins::Constant && is_variable(at[2].op()) &&
      (joins(at[3].op()) || compares(at[3].op())))
    return head(Form::ConstantAndVariable, at[3].op());
  if (count == 0 || !is_variable(at->op())) return head(Form::Long, Ins::End);
  if (count == 1) return head(Form::Variable, Ins::End);
  const Ins second = at[1].op();
  if (count == 3 && is_variable(second) && (joins(at[2].op()) || compares(at[2].op())))
    return head(Form::TwoVariables, at[2].op());
  if (count == 3 && without_constant(second) != Ins::End)
    return head(Form::VariableAndConstant, without_constant(second));
  if (count == 4 && second == Ins::Constant && compares(at[3].op()))
    return head(Form::VariableAndConstant, at[3].op());
  return head(Form::Long, Ins::End);
}

}  // namespace

void ExpressionWriter::grow() {
  const std::uint32_t top = place_of(top_), last = place_of(last_);
  open_.resize(2 * open_.size());
  clear();
  top_ = open_.data() + top;
  last_ = open_.data() + last;
}

std::uint32_t ExpressionWriter::end(std::uint32_t first, std::uint32_t at, std::uint32_t width) {
  ExpressionCell* const begin = open_.data() + first;
  ended_ = static_cast<std::uint32_t>(code_.expressions.size());
  const ExpressionCell before = begin[-1];  // of an expression that this one stands in
  begin[-1] = head_of(begin, top_, std::max(1U, width));
  *top_ = ExpressionCell::of(Ins::End, 0, at);
  code_.expressions.insert(code_.expressions.end(), begin - 1, top_ + 1);
  begin[-1] = before;
  top_ = begin;
  return ended_;
}

std::uint32_t ExpressionWriter::one(const Instruction& only, std::uint32_t at,
                                    std::uint32_t width) {
  const std::uint32_t first = next();
  emit(only);
  return end(first, at, width);
}

}  // namespace cncsub
