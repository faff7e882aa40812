#include "cncsub/control/parameter.hpp"

#include <algorithm>
#include <cmath>

#include "cncsub/control/control.hpp"
#include "cncsub/system/decimal.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

std::optional<ParameterName> ParameterName::read(std::string_view text) {
  ParameterName name;
  const std::size_t hash = std::min(text.find('#'), text.size());
  if (hash == 0 || hash > 15) return std::nullopt;
  for (const char c : text.substr(0, hash)) {
    if (!is_digit(c)) return std::nullopt;
    name.number = name.number * 10 + (c - '0');
  }
  if (hash == text.size()) return name;
  const std::string_view bit = text.substr(hash + 1);
  if (bit.empty() || bit.size() > 2 || !std::all_of(bit.begin(), bit.end(), is_digit))
    return std::nullopt;
  name.bit = 0;
  for (const char c : bit) name.bit = name.bit * 10 + (c - '0');
  return name;
}

namespace {

/// Find the parameter of this name; zeros in front of its number may be missing.
template <class Parameters>
auto* find_parameter(Parameters& parameters, std::string_view name) {
  for (auto& p : parameters)
    if (p.name == name) return &p;
  const auto wanted = ParameterName::read(name);
  for (auto& p : parameters)
    if (wanted && ParameterName::read(p.name) == wanted) return &p;
  return static_cast<decltype(&parameters.front())>(nullptr);
}

std::string written(double value) { return system::shortest(value); }

/// Return the parameters that somebody who wrote `name` may have meant: the bits of the same
/// number, or the three nearest numbers.
std::string near_parameters(const std::vector<Parameter>& parameters, const ParameterName& name) {
  std::vector<std::pair<std::int64_t, std::string_view>> far;
  for (const Parameter& p : parameters)
    if (const auto known = ParameterName::read(p.name))
      far.emplace_back(std::abs(known->number - name.number), p.name);
  std::stable_sort(far.begin(), far.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string near;
  for (std::size_t i = 0; i < far.size() && (i < 3 || far[i].first == 0); ++i)
    near += (i == 0 ? "; the nearest are " : ", ") + std::string(far[i].second);
  return near;
}

}  // namespace

double Control::parameter(std::string_view parameter_name) const {
  const Parameter* p = find_parameter(parameters, parameter_name);
  return p == nullptr ? 0 : p->value;
}

namespace {

/// Return whether a list of calling codes is kept in a parameter, or asks for it.
bool is_of(const CodeCall& list, const Parameter& parameter) {
  if (parameter.name == list.enable || parameter.name == list.every_block) return true;
  const auto name = ParameterName::read(parameter.name);
  if (!name || name->bit >= 0) return false;
  const std::int64_t number = name->number;
  if (list.form == CodeCall::Form::List)
    return number >= list.parameter && number < list.parameter + list.count;
  return list.form == CodeCall::Form::Range &&
         (number == list.parameter || number == list.program || number == list.count);
}

}  // namespace

bool Control::uses(const Parameter& parameter) const {
  return !parameter.sets.empty() || !parameter.read_by.empty() ||
         std::any_of(code_calls.begin(), code_calls.end(),
                     [&](const CodeCall& list) { return is_of(list, parameter); });
}

void apply(Control& control, const Parameter& parameter, const std::string& source,
           Evidence evidence) {
  if (parameter.sets.empty()) return;
  const Answers before(control);
  for (const Setting& setting : parameter.sets) setting.set(control, parameter.value);
  follow(control, before, source, evidence);
}

std::optional<std::string> Control::set_parameter(const std::string& parameter_name, double value) {
  const auto read = ParameterName::read(parameter_name);
  if (!read)
    return "'" + parameter_name +
           "' is not a parameter: write its number, such as '6050', or its number and bit, such as "
           "'6001#5'";
  const std::string what = "parameter " + parameter_name;
  if (read->bit > 7) return what + ": the bits of a parameter are 0 to 7";
  Parameter* p = find_parameter(parameters, parameter_name);
  if (p == nullptr)
    return name + " has no " + what + near_parameters(parameters, *read) + " (`cncsub controls " +
           name + "` lists them)";
  if (read->bit >= 0 && value != 0 && value != 1)
    return what + " is a bit: its value must be 0 or 1";
  if (!(std::fabs(value) <= kLargestSetting))
    return what + " must be a number up to " + std::to_string(kLargestSetting);
  p->value = value;
  apply(*this, *p, "set by parameter " + p->name + " = " + written(value), Evidence::Inferred);
  return std::nullopt;
}

}  // namespace cncsub
