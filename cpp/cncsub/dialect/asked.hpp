// The rules of a control that its language asks: of the others nobody is told, and nobody sets
// them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cncsub/control/control.hpp"

namespace cncsub {

std::vector<RuleView> asked_rules(const Control& control);

/// Why a rule cannot be set that the language of the control does not ask; nothing where it does,
/// or where no rule has this name.
std::optional<std::string> never_asked(const Control& control, const std::string& rule_name);

}  // namespace cncsub
