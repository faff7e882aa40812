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

double Control::parameter(std::string_view parameter_name) const {
  for (const Parameter& p : parameters)
    if (p.name == parameter_name) return p.value;
  return 0;
}

std::optional<std::string> Control::set_parameter(const std::string& parameter_name, double value) {
  if (!(std::fabs(value) <= kLargestSetting))
    return "parameter " + parameter_name + " is a number up to " + std::to_string(kLargestSetting);
  for (Parameter& p : parameters)
    if (p.name == parameter_name) {
      const auto effect = p.effect;
      p.value = value;
      if (effect != nullptr) effect(*this, value);
      return std::nullopt;
    }
  parameters.push_back({parameter_name, value, "no rule depends on it", "set by the caller",
                        Evidence::Inferred, nullptr});
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
