// Macro statements: assignments, branches, loops, jumps, names.
#pragma once

#include <optional>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Execute macro statements, which fill most loops, one after the other from the present block on:
/// until another kind of block comes, or one that a switch skips, or the run is to look for a
/// reason to stop; or `one`.
bool run_statements(Run& run, bool one, const Block*& instead);
/// Execute one statement, of any kind.
bool run_statement(Run& run, const Block& block, const Block*& instead);

/// Execute G65 H1 P#100 Q#101 R#102: assign, calculate, jump or raise an alarm. `holds`: what the
/// comparison of a jump gave.
bool h_code(Run& run, const HCode& h, bool& holds);
/// Execute the assignments of a block that does something else too, all with the values from
/// before, and its message. The words have their values already, and are executed after it.
bool assign_in_parallel(Run& run);
/// Return the local, the common or what a parameter stands for that an assignment names; nothing
/// where it names something else.
std::optional<Reference> variable_of(const Run& run, const Statement& statement);
/// The elements of an array from the one on that an assignment names.
struct ArrayElements {
  Reference first;
  std::int32_t left = 0;  // how many there are
};
ArrayElements elements_of(const Run& run, const Statement& statement, double place);
/// Return the number of the variable that an expression gives.
std::int64_t number_of_variable(double value);
/// Give the variable of an assignment its value.
bool store(Run& run, const Statement& statement, double value);
/// Give elements of an array a value, from the one at `place` on.
bool store_elements(Run& run, const Statement& statement, double place, double value);
/// Give a variable a value; #3000 and #3006 raise an alarm and show a message instead.
bool store_number(Run& run, std::int64_t number, double value, const Statement& statement);

/// Return whether a jump is allowed; it alarms in the main program of MDI where the control says
/// so.
bool may_jump(Run& run, const Statement& statement);
/// Return whether the run waits here for the world outside. A jump back that is reached twice with
/// nothing changed in between can only wait, for what the condition that was asked last reads.
bool waits(Run& run);
/// Execute a jump to what a text names.
bool jump_by_text(Run& run, const Statement& statement);
/// Go on at a block of the running program, or wait there for the world outside.
bool jump_to(Run& run, Address to);
/// Leave the loops that do not hold the block.
void leave_loops(Run& run, Address to);

}  // namespace cncsub
