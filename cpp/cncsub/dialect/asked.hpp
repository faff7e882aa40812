// The rules of a control that its language asks, and the words that it takes. The other rules are
// neither shown nor set.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cncsub/control/code_facts.hpp"
#include "cncsub/control/control.hpp"

namespace cncsub {

std::vector<RuleView> asked_rules(const Control& control);

/// Return why a rule cannot be set: the language of the control does not ask it. Return nothing if
/// the language asks it, or if no rule has this name.
std::optional<std::string> never_asked(const Control& control, const std::string& rule_name);

/// Leave out the letters that the language of the control refuses beside a code.
void keep_taken(const Control& control, CodeName code, std::vector<CodeWord>& words);

}  // namespace cncsub
