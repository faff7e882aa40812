// Named variables that the interpreter answers itself.
#pragma once

#include <array>
#include <string_view>

#include "cncsub/code/code.hpp"

namespace cncsub::linuxcnc {

/// A named variable as an expression.
struct BuiltIn {
  struct Step {
    Ins op = Ins::End;
    double value = 0;  // a constant, a variable's number; of Common: 0 what was returned, 1 whether
  };
  std::string_view name;
  std::array<Step, 4> steps;
};

/// Null where it is none that is answered here.
const BuiltIn* find_built_in(std::string_view name);
/// Whether it is one that nobody answers without a machine.
bool tells_of_machine(std::string_view name);
/// Whether it is one of both, which cannot be assigned to.
bool is_read_only(std::string_view name);

}  // namespace cncsub::linuxcnc
