#include "cncsub/code/expression_writer.hpp"

#include <algorithm>

namespace cncsub {

namespace {

bool load_of(const Instruction& from, Expression::Load& to) {
  using From = Expression::Load::From;
  switch (from.op) {
    case Ins::Constant:
      to = {From::Constant, true, 0, from.value};
      return true;
    case Ins::Local:
    case Ins::LocalRaw:
      to = {From::Local, from.op == Ins::LocalRaw, from.at, 0};
      return true;
    case Ins::Common:
    case Ins::CommonRaw:
      to = {From::Common, from.op == Ins::CommonRaw, from.at, 0};
      return true;
    default:
      return false;
  }
}

/// Tells expressions of one value, and of one operation on two, from longer ones.
void shorten(const Instruction* at, std::size_t count, Expression& expression) {
  if (count == 2 && load_of(at[0], expression.loads[0])) expression.form = Expression::Form::One;
  if (count == 3 && at[1].op >= Ins::AddConstant && at[1].op <= Ins::MultiplyConstant &&
      load_of(at[0], expression.loads[0])) {
    expression.form = Expression::Form::Two;
    expression.op = at[1].op == Ins::AddConstant        ? Ins::Add
                    : at[1].op == Ins::SubtractConstant ? Ins::Subtract
                                                        : Ins::Multiply;
    expression.loads[1].value = at[1].value;
  }
  if (count != 4 || !load_of(at[0], expression.loads[0]) || !load_of(at[1], expression.loads[1]))
    return;
  const bool plain = (at[2].op >= Ins::Add && at[2].op <= Ins::Multiply) ||
                     (at[2].op >= Ins::Equal && at[2].op <= Ins::LessEqual);
  if (!plain) return;
  expression.form = Expression::Form::Two;
  expression.op = at[2].op;
}

}  // namespace

std::uint32_t ExpressionWriter::end(std::uint32_t first, std::uint32_t at, std::uint32_t width) {
  emit({Ins::End, 0, at, 0});
  Expression expression;
  expression.first = first;
  expression.at = at;
  expression.width = std::max(1u, width);
  shorten(code_.instructions.data() + first, code_.instructions.size() - first, expression);
  code_.expressions.push_back(expression);
  return static_cast<std::uint32_t>(code_.expressions.size() - 1);
}

std::uint32_t ExpressionWriter::one(const Instruction& only, std::uint32_t at,
                                    std::uint32_t width) {
  const std::uint32_t first = next();
  emit(only);
  return end(first, at, width);
}

}  // namespace cncsub
