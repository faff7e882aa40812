// Variables by their number: locals, commons, and what the control answers itself.
#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// A program's look at a variable. With every look at the clock it goes on a little, besides going
/// on with the motion: a program that waits for it comes on.
std::optional<Fault> read_variable(Run& run, std::int64_t number, double& value);
/// Somebody else's look, at the locals of any open level.
std::optional<Fault> read_variable(const Run& run, std::int64_t number, int level, double& value);
std::optional<Fault> write_variable(Run& run, std::int64_t number, int level, double value);
inline std::optional<Fault> write_variable(Run& run, std::int64_t number, double value) {
  return write_variable(run, number, run.state.level, value);
}
/// What the machine or another program writes: a signal, or a variable.
void set_from_outside(Run& run, std::int32_t number, double value);
/// What the reset key does to variables.
void clear_variables(Run& run);
/// Every variable that is not vacant or was ever written: commons and the locals of a level.
std::map<std::int32_t, double> variables(const Run& run, int level);

// What is true of a variable in every run.

/// Whether it may hold no value: a local or a common.
bool can_be_vacant(const Code& code, std::int64_t number);
/// Whether it is set by the machine, from outside.
bool is_signal(const Code& code, std::int64_t number);
/// Whether a reset makes it vacant.
bool cleared_by_reset(const Code& code, std::int64_t number);

}  // namespace cncsub
