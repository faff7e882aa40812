// Texts of a program for the operator or a printer, and words that the control reports as dropped.
#pragma once

#include <string>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Record a message for the operator, or a line that is printed.
void say(Run& run, std::string text);
/// Execute DPRNT or BPRNT.
bool print(Run& run, const Print& print);
/// Return the comment of a statement: the text of #3000, #3006 and H99.
std::string comment_of(const Run& run, const Statement& statement);
/// Raise the alarm of #3000 or H99. It is what the block does, so that the block is a step. Return
/// false, as `alarm`.
bool alarm_of_program(Run& run, const Statement& statement, const std::string& text,
                      const std::string& number);
/// Record what the block said and the control did not obey: what was known when the block was read,
/// then G codes, then addresses.
void tell_dropped(Run& run, const Block& block, const NcWords& words);

}  // namespace cncsub
