// Evaluates expressions that stand in no program, without a change of the run.
#pragma once

#include <optional>

#include "cncsub/code/expression_list.hpp"
#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Evaluate one expression of a list between two blocks. Return the alarm that it would be in a
/// program, and the run is what it was before.
std::optional<Alarm> evaluate_aside(Run& run, const ExpressionList& list,
                                    const ExpressionList::One& one, double& value);
/// Return whether the value of an expression depends on the level of locals that is open.
bool reads_locals(const ExpressionList& list, const ExpressionList::One& one);

}  // namespace cncsub
