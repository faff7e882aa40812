#include "cncsub/control.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <type_traits>

#include "cncsub/rule_lists.hpp"
#include "cncsub/variable_table.hpp"
#include "controls/facts.hpp"

namespace cncsub {

// What every run reads lives as long as the process: when it ends, threads may still be at work.
const std::vector<CauseInfo>& all_causes() {
  static const auto& causes = *new const std::vector<CauseInfo>{
#define CAUSE(name, slug, meaning, cure) {#name, slug, meaning, cure},
#include "cncsub/causes.def"
#undef CAUSE
  };
  return causes;
}

#define CHOICE(type)                           \
  template <>                                  \
  const std::vector<Option>& options<type>() { \
    static const auto& list = *new const std::vector<Option> {
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
RuleValue shown(const T& value) {
  if constexpr (std::is_enum_v<T>)
    return std::string(options<T>()[static_cast<std::size_t>(value)].slug);
  else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>)
    return static_cast<std::int64_t>(value);
  else
    return value;
}

template <class T>
RuleView view(const char* name, const char* meaning, const Rule<T>& rule, const T& family) {
  RuleView row{name, meaning, shown(rule.value), shown(family), rule.source, rule.evidence, {}};
  if constexpr (std::is_enum_v<T>) row.options = options<T>();
  return row;
}

std::string joined(const std::vector<Option>& list) {
  std::string text;
  for (const Option& option : list) text += (text.empty() ? "" : ", ") + std::string(option.slug);
  return text;
}

template <class T>
std::optional<std::string> assign([[maybe_unused]] const Control& control,
                                  [[maybe_unused]] std::string_view type, const char* name,
                                  Rule<T>& rule, const RuleValue& value) {
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
    if (type == "Ranges") return change_commons(control, rule.value, *text);
    if (type == "VariableOptions") return change_variable_options(control, rule.value, *text);
    return type == "Codes" ? change_list(name, rule.value, *text)
                           : change_letters(name, rule.value, *text);
  }
  return std::nullopt;
}

}  // namespace

std::vector<RuleView> rules(const Control& control) {
  return {
#define RULE(type, name, standard, meaning) view<type>(#name, meaning, control.name, standard),
#include "cncsub/rules.def"
#undef RULE
  };
}

std::optional<std::string> set_rule(Control& control, const std::string& rule_name,
                                    const RuleValue& value, const std::string& source,
                                    Evidence evidence) {
#define RULE(type, name, default_value, meaning)                     \
  if (rule_name == #name) {                                          \
    auto wrong = assign(control, #type, #name, control.name, value); \
    if (!wrong) {                                                    \
      control.name.source = source;                                  \
      control.name.evidence = evidence;                              \
    }                                                                \
    return wrong;                                                    \
  }
#include "cncsub/rules.def"
#undef RULE
  return "no rule is named " + rule_name;
}

Answers::Answers(const Control& control) {
#define RULE(type, name, standard, meaning) name = control.name.value;
#include "cncsub/rules.def"
#undef RULE
}

void follow(Control& control, const Answers& before, const std::string& source, Evidence evidence) {
#define RULE(type, name, standard, meaning) \
  if (control.name.value != before.name) control.name = {control.name.value, source, evidence};
#include "cncsub/rules.def"
#undef RULE
}

const DirectedNumber* AlarmEntry::towards(std::string_view direction) const {
  for (const DirectedNumber& one : directed)
    if (!direction.empty() && direction.ends_with(one.direction)) return &one;
  return nullptr;
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

std::string written(double value) {
  std::array<char, 32> text{};
  auto* const end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
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
  p->value = value;
  if (p->effect == nullptr) return std::nullopt;
  const std::string setting = p->name + " = " + written(value);
  const Answers before(*this);
  p->effect(*this, value);
  follow(*this, before, "set by parameter " + setting, Evidence::Inferred);
  return std::nullopt;
}

namespace {

/// No fact is stronger than its sources are on this control, whoever wrote it down.
void judge(Control& c) {
  const auto weaken = [&c](const std::string& source, Evidence& evidence) {
    evidence = std::max(evidence, strongest(source, c.name));
  };
#define RULE(type, name, value, meaning) weaken(c.name.source, c.name.evidence);
#include "cncsub/rules.def"
#undef RULE
  for (Parameter& p : c.parameters) weaken(p.source, p.evidence);
  for (VariableRange& v : c.variables) weaken(v.source, v.evidence);
  for (VariableOption& option : c.variable_choices) weaken(option.source, option.evidence);
  for (CodeCall& call : c.code_calls) weaken(call.source, call.evidence);
  for (auto& [cause, entry] : c.alarms) weaken(entry.source, entry.evidence);
}

/// In the order of their numbers and bits.
void sort_parameters(Control& c) {
  const auto place = [](const Parameter& p) {
    const auto name = ParameterName::read(p.name).value_or(ParameterName());
    return std::pair(name.number, name.bit);
  };
  std::stable_sort(
      c.parameters.begin(), c.parameters.end(),
      [&place](const Parameter& a, const Parameter& b) { return place(a) < place(b); });
}

}  // namespace

const std::vector<Control>& all_controls() {
  static const auto& list = *new const std::vector<Control>([] {
    std::vector<Control> all;
    const auto take = [&all](std::string_view name, Control control) {
      control.name = name;
      sort_parameters(control);
      judge(all.emplace_back(std::move(control)));
    };
#define CONTROL(function, name) take(name, function());
#include "controls/list.def"
#undef CONTROL
    return all;
  }());
  return list;
}

}  // namespace cncsub
