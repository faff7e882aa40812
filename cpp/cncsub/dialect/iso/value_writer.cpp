#include "cncsub/dialect/iso/value_writer.hpp"

#include "cncsub/dialect/iso/plain_expression.hpp"

namespace cncsub {

namespace {

/// The same load of a variable, where a vacant one counts as 0.
Ins computed(Ins raw) {
  switch (raw) {
    case Ins::LocalRaw:
      return Ins::Local;
    case Ins::CommonRaw:
      return Ins::Common;
    case Ins::VariableRaw:
      return Ins::Variable;
    case Ins::IndirectRaw:
      return Ins::Indirect;
    default:
      return raw;
  }
}

}  // namespace

std::nullopt_t ValueWriter::refuse(Cause cause, std::uint32_t at, std::string detail) {
  if (!failed_) fault_ = {cause, at, 1, std::move(detail)};
  failed_ = true;
  return std::nullopt;
}

bool ValueWriter::has_room(std::uint32_t at) {
  if (depth_ < kDeepest) return true;
  refuse(Cause::BracketsTooDeep, at);
  return false;
}

bool ValueWriter::is_number(Value& value) const {
  if (value.type == Value::Type::Condition &&
      control_.macros.conditions.value.has(Condition::Values))
    value.type = Value::Type::Number;
  return value.type == Value::Type::Number;
}

bool ValueWriter::arithmetic(Value& value, std::uint32_t at) {
  if (!is_number(value)) {
    refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
    return false;
  }
  if (value.raw >= 0) {
    Instruction& load = to_.expressions().instruction(static_cast<std::size_t>(value.raw));
    if (load.op == Ins::Constant) load.value = 0;
    load.op = computed(load.op);
    value.raw = -1;
  }
  return true;
}

void ValueWriter::negate(std::uint32_t first, std::uint32_t at) {
  Instruction& last = to_.expressions().instruction(this->first() - 1);
  if (this->first() == first + 1 && last.op == Ins::Constant)
    last.value = -last.value;
  else
    emit(Ins::Negate, at);
}

void ValueWriter::emit_operator(Ins op, Ins with_constant, std::uint32_t at) {
  Instruction& last = to_.expressions().instruction(first() - 1);
  const bool constant = last.op == Ins::Constant && with_constant != Ins::End;
  if (!constant || (op == Ins::Divide && last.value == 0)) return emit(op, at);
  last.op = with_constant;
  last.at = at;
  depth_ += stack_effect(last.op) - stack_effect(Ins::Constant);
}

Value ValueWriter::load(std::int64_t number, std::uint32_t at) {
  const VariablePlace place = to_.code().place(number);
  const auto written = static_cast<double>(number);
  if (place.range != nullptr && place.kind == VariableKind::Vacant)
    emit(Ins::Constant, at, kVacant);
  else if (place.is_local())
    emit(Ins::LocalRaw, static_cast<std::uint32_t>(place.index), written);
  else if (place.is_common())
    emit(Ins::CommonRaw, static_cast<std::uint32_t>(place.index), written);
  else
    emit(Ins::VariableRaw, at, written);
  return last();
}

std::optional<Value> ValueWriter::take(const PlainExpression& plain) {
  if (depth_ + 2 > kDeepest) return std::nullopt;
  for (std::size_t i = 0; i < plain.count; ++i)
    emit(plain.steps[i].op, plain.steps[i].at, plain.steps[i].value);
  return plain.may_be_vacant() ? last() : Value{};
}

std::uint32_t ValueWriter::finish(std::uint32_t first, std::uint32_t at, std::uint32_t width) {
  depth_ += stack_effect(Ins::End);
  return to_.expressions().end(first, at, width);
}

}  // namespace cncsub
