// What somebody sets from outside by name: modes, and variables that a program defines.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Put a code or a word in force that nothing but a mode follows from. `typed`: the library with a
/// program at its end that holds it; `mode`: its name as in `modal`. Return why it cannot be, or
/// nothing; then nothing has changed.
std::optional<std::string> set_mode(Run& run, const std::shared_ptr<const Code>& typed,
                                    const std::string& mode);

/// Let an axis stand elsewhere: see Motion::stand_at. Return why it cannot, or nothing.
std::optional<std::string> set_position(Run& run, int axis, double value, Coordinates of);

using NamedValue = std::variant<double, std::string>;
/// Give a variable that has a name its value, or those of its elements in their order. Return why
/// it cannot take them, or nothing; then nothing has changed.
std::optional<std::string> set_named(Run& run, int level, const std::string& name,
                                     const std::vector<NamedValue>& values);

}  // namespace cncsub
