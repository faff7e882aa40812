// The parameters of a control: its settings by their numbers, and the rules that each sets.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control/source.hpp"

namespace cncsub {

struct Control;

/// The largest number of a parameter and of a rule.
inline constexpr std::int64_t kLargestSetting = 999'999'999;

/// A rule that a parameter sets, or an entry of a rule that is a set, and how the parameter's
/// value becomes its answer. settings.hpp makes them.
struct Setting {
  std::string rule;  // "no_radius", "power_on:G01"
  std::function<void(Control&, double)> set;
};

struct Parameter {
  std::string name;  // "6050" or "3404#6"
  double value = 0;
  std::string meaning;
  std::string source;
  Evidence evidence = Evidence::Inferred;
  // NOLINTBEGIN(readability-redundant-member-init)
  std::vector<Setting> sets = {};
  std::string read_by = {};  // the rule that says that the engine reads the number itself, and how
  // NOLINTEND(readability-redundant-member-init)
};

/// The name of a parameter: 6001#5 is number 6001, bit 5; without a bit it is -1. `read` returns
/// nothing where a text is no such name.
struct ParameterName {
  std::int64_t number = 0;
  int bit = -1;

  static std::optional<ParameterName> read(std::string_view text);
  auto operator<=>(const ParameterName&) const = default;
};

/// Let a parameter set its rules. `source` is that of every answer that changes.
void apply(Control& control, const Parameter& parameter, const std::string& source,
           Evidence evidence);

}  // namespace cncsub
