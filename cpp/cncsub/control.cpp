#include "cncsub/control.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "controls/controls.hpp"

namespace cncsub {

const std::vector<CauseInfo>& all_causes() {
  static const std::vector<CauseInfo> causes = {
#define CAUSE(name, slug, meaning, cure) {#name, slug, meaning, cure},
#include "cncsub/causes.def"
#undef CAUSE
  };
  return causes;
}

std::string_view to_string(Evidence evidence) {
  switch (evidence) {
    case Evidence::SourceDocument:
      return "source document";
    case Evidence::Manual:
      return "maker's manual";
    case Evidence::Secondary:
      return "secondary";
    case Evidence::Inferred:
      return "inferred";
  }
  return "";
}

#define CHOICE(type)                           \
  template <>                                  \
  const std::vector<Option>& options<type>() { \
    static const std::vector<Option> list = {
#define OPTION(type, name, slug, example) {slug, example},
#define END_CHOICE(type) \
  }                      \
  ;                      \
  return list;           \
  }
#include "cncsub/choices.def"
#undef CHOICE
#undef OPTION
#undef END_CHOICE

namespace {

constexpr std::int64_t kLargestSetting = 999'999'999;  // of a rule, and of a parameter

template <class T>
RuleView view(const char* name, const char* meaning, const Rule<T>& rule) {
  RuleView row{name, meaning, {}, rule.source, rule.evidence, {}};
  if constexpr (std::is_enum_v<T>) {
    row.options = options<T>();
    row.value = std::string(row.options[static_cast<std::size_t>(rule.value)].slug);
  } else if constexpr (std::is_same_v<T, bool>) {
    row.value = rule.value;
  } else if constexpr (std::is_integral_v<T>) {
    row.value = static_cast<std::int64_t>(rule.value);
  } else {
    row.value = rule.value;
  }
  return row;
}

std::string joined(const std::vector<Option>& list) {
  std::string text;
  for (const Option& option : list) text += (text.empty() ? "" : ", ") + std::string(option.slug);
  return text;
}

template <class T>
std::optional<std::string> assign(const char* name, Rule<T>& rule, const RuleValue& value) {
  if constexpr (std::is_enum_v<T>) {
    if (const auto* slug = std::get_if<std::string>(&value)) {
      const auto& list = options<T>();
      for (std::size_t i = 0; i < list.size(); ++i)
        if (list[i].slug == *slug) {
          rule.value = static_cast<T>(i);
          return std::nullopt;
        }
    }
    return std::string(name) + " is one of " + joined(options<T>());
  } else if constexpr (std::is_same_v<T, bool>) {
    const auto* yes = std::get_if<bool>(&value);
    if (yes == nullptr) return std::string(name) + " is True or False";
    rule.value = *yes;
  } else if constexpr (std::is_integral_v<T>) {
    const auto* number = std::get_if<std::int64_t>(&value);
    if (number == nullptr || *number < 0 || *number > kLargestSetting)
      return std::string(name) + " is a whole number from 0 to " + std::to_string(kLargestSetting);
    rule.value = static_cast<T>(*number);
  } else {
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) return std::string(name) + " is a text";
    rule.value = *text;
  }
  return std::nullopt;
}

}  // namespace

std::vector<RuleView> rules(const Control& control) {
  return {
#define RULE(type, name, value, meaning) view(#name, meaning, control.name),
#include "cncsub/rules.def"
#undef RULE
  };
}

std::optional<std::string> set_rule(Control& control, const std::string& rule_name,
                                    const RuleValue& value) {
#define RULE(type, name, default_value, meaning)     \
  if (rule_name == #name) {                          \
    auto wrong = assign(#name, control.name, value); \
    if (!wrong) {                                    \
      control.name.source = "set by the caller";     \
      control.name.evidence = Evidence::Inferred;    \
    }                                                \
    return wrong;                                    \
  }
#include "cncsub/rules.def"
#undef RULE
  return "no rule is named " + rule_name;
}

const AlarmEntry* Control::alarm(Cause cause) const {
  const auto found = alarms.find(cause);
  return found == alarms.end() ? nullptr : &found->second;
}

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// What a parameter's name says: 6001#5 is number 6001, bit 5; without a bit it is -1. Nothing
/// where it is no such name.
struct ParameterName {
  std::int64_t number = 0;
  int bit = -1;

  static std::optional<ParameterName> read(std::string_view text) {
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
  bool operator==(const ParameterName&) const = default;
};

/// The parameter of this name; zeros in front of its number may be missing.
template <class Parameters>
auto* find_parameter(Parameters& parameters, std::string_view name) {
  for (auto& p : parameters)
    if (p.name == name) return &p;
  const auto wanted = ParameterName::read(name);
  for (auto& p : parameters)
    if (wanted && ParameterName::read(p.name) == wanted) return &p;
  return static_cast<decltype(&parameters.front())>(nullptr);
}

/// The parameters that somebody who wrote `name` may have meant: the bits of the same number, or
/// the three nearest numbers.
std::string near_parameters(const std::vector<Parameter>& parameters, const ParameterName& name) {
  std::vector<std::pair<std::int64_t, std::string_view>> far;
  for (const Parameter& p : parameters)
    if (const auto known = ParameterName::read(p.name))
      far.emplace_back(std::abs(known->number - name.number), p.name);
  std::stable_sort(far.begin(), far.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::string near;
  for (std::size_t i = 0; i < far.size() && (i < 3 || far[i].first == 0); ++i)
    near += (i == 0 ? "; near are " : ", ") + std::string(far[i].second);
  return near;
}

}  // namespace

double Control::parameter(std::string_view parameter_name) const {
  const Parameter* p = find_parameter(parameters, parameter_name);
  return p == nullptr ? 0 : p->value;
}

std::optional<std::string> Control::set_parameter(const std::string& parameter_name, double value) {
  const auto read = ParameterName::read(parameter_name);
  if (!read)
    return "'" + parameter_name +
           "' is no parameter: write its number, as '6050', or number and bit, as '6001#5'";
  const std::string what = "parameter " + parameter_name;
  if (read->bit > 7) return what + ": the bits of a parameter are 0 to 7";
  Parameter* p = find_parameter(parameters, parameter_name);
  if (p == nullptr)
    return name + " has no " + what + near_parameters(parameters, *read) + " (`cncsub controls " +
           name + "` lists them)";
  if (read->bit >= 0 && value != 0 && value != 1) return what + " is a bit, 0 or 1";
  if (!(std::fabs(value) <= kLargestSetting))
    return what + " is a number up to " + std::to_string(kLargestSetting);
  const auto effect = p->effect;
  p->value = value;
  if (effect != nullptr) effect(*this, value);
  return std::nullopt;
}

const VariableRange* Control::variable(std::int64_t number) const {
  for (const VariableRange& range : variables)
    if (number >= range.first && number <= range.last) return &range;
  return nullptr;
}

const std::vector<Control>& all_controls() {
  static const std::vector<Control> list = [] {
    std::vector<Control> all;
    const auto take = [&](std::vector<Control> maker, void (*add_motion)(std::vector<Control>&)) {
      add_motion(maker);
      for (Control& control : maker) all.push_back(std::move(control));
    };
    take(gsk_controls(), add_gsk_motion);
    take(mitsubishi_controls(), add_mitsubishi_motion);
    take(fanuc_controls(), add_fanuc_motion);
    take(hnc_controls(), add_hnc_motion);
    return all;
  }();
  return list;
}

}  // namespace cncsub
