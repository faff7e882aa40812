#include "cncsub/code/expression_writer.hpp"

#include <algorithm>

namespace cncsub {

namespace {

using Form = Expression::Form;

constexpr bool is_variable(Ins op) { return op >= Ins::Local && op <= Ins::CommonRaw; }
static_assert(static_cast<int>(Ins::CommonRaw) - static_cast<int>(Ins::Local) == 3);
constexpr bool compares(Ins op) { return op >= Ins::Equal && op <= Ins::LessEqual; }
constexpr bool joins(Ins op) { return op >= Ins::Add && op <= Ins::Multiply; }

/// The same operation on two values.
constexpr Ins without_constant(Ins op) {
  return op == Ins::AddConstant        ? Ins::Add
         : op == Ins::SubtractConstant ? Ins::Subtract
         : op == Ins::MultiplyConstant ? Ins::Multiply
                                       : Ins::End;
}

struct Shape {
  Form form;
  Ins op = Ins::Constant;
};

/// How the instructions from `at` to `end`, which do not hold the End, are computed.
Shape shape_of(const ExpressionCell* at, const ExpressionCell* end) {
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
      if (const Ins op = at[2].op(); is_variable(at[1].op()) && (joins(op) || compares(op)))
        return {Form::TwoVariables, op};
      break;
    case 4:
      if (const Ins op = at[3].op();
          first == Ins::Constant && is_variable(at[2].op()) && (joins(op) || compares(op)))
        return {Form::ConstantAndVariable, op};
      if (is_variable(first) && at[1].op() == Ins::Constant && compares(at[3].op()))
        return {Form::VariableToConstant, at[3].op()};
      break;
    default:
      break;
  }
  return {Form::Long};
}

}  // namespace

void OpenInstructions::make_room() {
  const std::uint32_t top = place_of(top_);
  const std::size_t before = table_.size(), room = 2 * (top + kRoom);
  table_.add(top + 1);  // they count while they are moved
  table_.room(room);
  table_.keep(before);
  first_ = table_.room(0) + 1;
  limit_ = first_ + top + room - kSpare;
  top_ = first_ + top;
}

std::uint32_t OpenInstructions::end(std::uint32_t at, std::uint32_t width) {
  const auto number = static_cast<std::uint32_t>(table_.size());
  const auto [form, op] = width <= Expression::kWidest ? shape_of(first_, top_) : Shape{Form::Long};
  first_[-1] = Expression::head(form, op, at, std::max(1U, width));
  if (form == Form::Constant) {
    first_[0] = first_[1];
    --top_;
  } else if (form == Form::Long) {
    *top_++ = ExpressionCell::of(Ins::End, 0, at);
  }
  table_.add(1 + place_of(top_));
  return number;
}

std::uint32_t ExpressionWriter::one(const Instruction& only, std::uint32_t at,
                                    std::uint32_t width) {
  begin();
  emit(only);
  return end(at, width);
}

}  // namespace cncsub
