// The faults of a variable that hold in every run.
#pragma once

#include <cstdint>
#include <optional>

#include "cncsub/code/code.hpp"

namespace cncsub {

/// Return why no program can read a variable, or nothing.
std::optional<Fault> unreadable(const Code& code, const VariablePlace& place, std::int64_t number);
inline std::optional<Fault> unreadable(const Code& code, std::int64_t number) {
  return unreadable(code, code.place(number), number);
}
/// Return why nobody can give a variable a value, or nothing.
std::optional<Fault> unwritable(const Code& code, const VariablePlace& place, std::int64_t number);
inline std::optional<Fault> unwritable(const Code& code, std::int64_t number) {
  return unwritable(code, code.place(number), number);
}

}  // namespace cncsub
