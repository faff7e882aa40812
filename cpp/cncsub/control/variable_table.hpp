// The variables of a control as it is set: its own, its commons, and those of the options fitted.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control/control.hpp"

namespace cncsub {

/// The most commons that a control may be given: a run holds each of them.
inline constexpr std::int64_t kMostCommons = 100'000;
/// The first common that is kept at power-off.
inline constexpr std::int32_t kFirstKept = 500;

/// Set the rule `commons` anew. The text names ranges (`100-199`), single numbers, and options,
/// each with all commons of a control that has it. Return what is wrong with an entry, or nothing.
std::optional<std::string> change_commons(const Control& control, Ranges& list,
                                          std::string_view text);

/// Change the rule `variable_options`, entry by entry as other lists.
std::optional<std::string> change_variable_options(const Control& control, VariableOptions& list,
                                                   std::string_view text);

/// Return whether the control has all that the option brings.
bool is_fitted(const Control& control, const VariableOption& option);

/// Return what the option brings, as the rule `commons` is written.
std::string numbers_of(const VariableOption& option);

/// Return whether these are other names of commons.
bool is_alias(const VariableRange& range);

/// Return the group in which a variable of a kind is shown: "locals", "work offsets", ...
std::string_view group_of(VariableKind kind);
/// Return what variables of a kind hold, or do.
std::string_view what_it_holds(VariableKind kind);

/// Return every range that the control has, by number.
std::vector<VariableRange> variable_ranges(const Control& control);

/// Return `there is no #900000`, and the option that would bring it.
std::string no_variable(const Control& control, std::string_view sign, std::int64_t number);
/// Return which option brings a variable, as the end of a sentence; empty where none does.
std::string option_with(const Control& control, std::int64_t number);

}  // namespace cncsub
