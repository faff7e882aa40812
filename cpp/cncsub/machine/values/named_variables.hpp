// Variables that have names, with their values, for whoever looks at a run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// A variable that has a name, and where its values lie.
struct NamedValues {
  const DefinedVariable* variable;
  const double* values;
  std::vector<std::int32_t> extents;  // of an array
};
/// Return the variables that the program of a level defines, then those of all programs. One that
/// was not defined yet is left out.
std::vector<NamedValues> named_variables(const Run& run, int level);
/// Return the one of this name, in capitals; nothing where there is none.
std::optional<NamedValues> named_variable(const Run& run, int level, const std::string& name);

}  // namespace cncsub
