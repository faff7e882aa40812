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
  switch (out_.op(place)) {
    case Ins::Constant:
      return out_.set_value(place, 0);
    case Ins::VariableRaw:
      return out_.set_op(place, Ins::Variable);
    case Ins::IndirectRaw:
      return out_.set_op(place, Ins::Indirect);
    default:
      return;
  }
}

void ValueWriter::negate(std::uint32_t first, std::uint32_t at) {
  if (out_.last_place() == first && out_.last() == Ins::Constant)
    out_.set_value(first, -out_.value(first));
  else
    emit(Ins::Negate, at);
}

Value ValueWriter::load(std::int64_t number, std::uint32_t at) {
  const VariablePlace place = rules_.code.place(number);
  const auto index = static_cast<std::uint32_t>(place.index);
  if (place.range != nullptr && place.kind == VariableKind::Vacant)
    emit(Ins::Constant, at, kVacant);
  else if (place.is_local())
    return load(Ins::LocalRaw, index, static_cast<std::uint32_t>(number));
  else if (place.is_common())
    return load(Ins::CommonRaw, index, static_cast<std::uint32_t>(number));
  else
    emit(Ins::VariableRaw, at, static_cast<double>(number));
  return last();
}

}  // namespace cncsub
