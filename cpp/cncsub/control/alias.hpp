// Other names of controls: FANUC sells one control under several numbers.
#pragma once

#include <string_view>
#include <vector>

#include "cncsub/control/control.hpp"

namespace cncsub {

/// A name that people write for a control of another name, and who says that it is the same one.
struct Alias {
  std::string_view name;     // "fanuc-31i"
  std::string_view control;  // "fanuc-30i"
  std::string_view source;
  Evidence evidence = Evidence::Inferred;
};

/// Return every alias, in the order of cpp/controls/aliases.def.
const std::vector<Alias>& all_aliases();

/// Return the control of a name or of an alias; null where there is none.
const Control* find_control(std::string_view name);

/// Return the names and aliases that somebody who wrote `name` most likely meant, the likeliest
/// first; at most three.
std::vector<std::string_view> names_near(std::string_view name);

}  // namespace cncsub
