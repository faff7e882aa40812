// Variables by their number: locals, commons, and what the control answers itself.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Read a variable for a program. Every read of the clock moves it on a little, besides the motion,
/// so that a program that waits for it comes on.
std::optional<Fault> read_variable(Run& run, std::int64_t number, double& value);
/// Read a variable for somebody else, with the locals of any open level.
std::optional<Fault> read_variable(const Run& run, std::int64_t number, int level, double& value);
std::optional<Fault> write_variable(Run& run, std::int64_t number, int level, double value);
inline std::optional<Fault> write_variable(Run& run, std::int64_t number, double value) {
  return write_variable(run, number, run.state.level, value);
}
/// Write what the machine or another program writes: a signal, or a variable.
void set_from_outside(Run& run, std::int32_t number, double value);
/// Clear the variables that the reset key clears.
void clear_variables(Run& run);
/// Return every variable that is not vacant or was ever written: commons and the locals of a level.
std::map<std::int32_t, double> variables(const Run& run, int level);

// Predicates of a variable that hold in every run.

/// Return whether a variable may hold no value: a local or a common.
bool can_be_vacant(const Code& code, std::int64_t number);
/// Return whether a variable is set by the machine, from outside.
bool is_signal(const Code& code, std::int64_t number);
/// Return whether a reset makes a variable vacant.
bool cleared_by_reset(const Code& code, std::int64_t number);

}  // namespace cncsub
