#include "cncsub/code/variable_faults.hpp"

#include <string>

#include "cncsub/control/variable_table.hpp"

namespace cncsub {

namespace {

std::string name_of(const Code& code, std::int64_t number) {
  return code.spelling->name_of_variable(*code.control, number);
}

Fault missing(const Code& code, std::int64_t number) {
  if (number >= 0 && code.control->macros.unlisted_variables.value == UnlistedVariable::NotKnown)
    return {.cause = Cause::VariableNotKnown,
            .detail = "no source says what " + name_of(code, number) + " is on this control"};
  return {.cause = Cause::IllegalVariable,
          .detail = no_variable(*code.control, code.spelling->variable, number)};
}

}  // namespace

std::optional<Fault> unreadable(const Code& code, const VariablePlace& place, std::int64_t number) {
  if (place.range == nullptr) return missing(code, number);
  if (place.range->access == Access::WriteOnly)
    return Fault{.cause = Cause::VariableReadProtected,
                 .detail = name_of(code, number) + " cannot be read"};
  return std::nullopt;
}

std::optional<Fault> unwritable(const Code& code, const VariablePlace& place, std::int64_t number) {
  if (place.range == nullptr) return missing(code, number);
  if (place.kind == VariableKind::Vacant)
    return Fault{.cause = Cause::VacantAssigned, .detail = "#0 is always vacant"};
  switch (place.range->access) {
    case Access::ReadWrite:
      break;
    case Access::ReadOnly:
      return Fault{.cause = Cause::VariableWriteProtected,
                   .detail = name_of(code, number) + " cannot be written"};
    case Access::WriteOnly:  // a statement: the block that writes it has done it already
      return Fault{.cause = Cause::VariableWriteProtected,
                   .detail = name_of(code, number) + " can be set only by a program"};
  }
  return std::nullopt;
}

}  // namespace cncsub
