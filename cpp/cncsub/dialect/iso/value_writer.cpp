#include "cncsub/dialect/iso/value_writer.hpp"

namespace cncsub {

Refused ValueWriter::refuse(Cause cause, std::uint32_t at, std::string detail) {
  if (!fault_) fault_ = {cause, at, 1, std::move(detail)};
  return {};
}

bool ValueWriter::no_number(std::uint32_t at) {
  refuse(Cause::ExpressionFormat, at, "the result of a comparison is not a number");
  return false;
}

void ValueWriter::count_other_vacant(std::uint32_t place) {
  switch (open_.op(place)) {
    case Ins::Constant:
      return open_.set_value(place, 0);
    case Ins::VariableRaw:
      return open_.set_op(place, Ins::Variable);
    case Ins::IndirectRaw:
      return open_.set_op(place, Ins::Indirect);
    default:
      return;
  }
}

Value ValueWriter::negated(Value value, std::uint32_t at) {
  if (value.is_constant()) {
    open_.set_value(value.place(), -open_.value(value.place()));
    return value;
  }
  emit(Ins::Negate, at);
  return Value::number();
}

Value ValueWriter::load(std::int64_t number, std::uint32_t at) {
  const VariablePlace place = rules_.code.place(number);
  const auto index = static_cast<std::uint32_t>(place.index);
  const auto of = static_cast<double>(number);
  if (place.range != nullptr && place.kind == VariableKind::Vacant)
    return Value::variable(emit(Ins::Constant, at, kVacant));
  if (place.is_local()) return Value::variable(emit(Ins::LocalRaw, index, of));
  if (place.is_common()) return Value::variable(emit(Ins::CommonRaw, index, of));
  return Value::variable(emit(Ins::VariableRaw, at, of));
}

}  // namespace cncsub
