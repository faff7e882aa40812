#include "cncsub/control/control.hpp"

#include <algorithm>
#include <type_traits>

#include "cncsub/control/rule_lists.hpp"
#include "cncsub/control/variable_table.hpp"

namespace cncsub {

// What every run reads lives as long as the process: when it ends, threads may still be at work.
const std::vector<CauseInfo>& all_causes() {
  static const auto& causes = *new const std::vector<CauseInfo>{
#define CAUSE(name, slug, meaning, cure) {#name, slug, meaning, cure},
#include "cncsub/control/causes.def"
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
#include "cncsub/control/choices.def"
#undef CHOICE
#undef OPTION
#undef END_CHOICE

namespace {

// The members of a set.

template <class E>
std::vector<std::pair<E, Option>> members_of() {
  std::vector<std::pair<E, Option>> all;
  for (const Option& option : options<E>()) all.emplace_back(static_cast<E>(all.size()), option);
  return all;
}

template <>
std::vector<std::pair<Cause, Option>> members_of() {
  return {
#define REFUSAL(cause, example) \
  {Cause::cause, {info(Cause::cause).slug, *example == 0 ? info(Cause::cause).meaning : example}},
#include "cncsub/control/refusals.def"
#undef REFUSAL
  };
}

template <class T>
inline constexpr bool kIsSet = false;
template <class E, std::size_t Most>
inline constexpr bool kIsSet<Set<E, Most>> = true;
template <class T>
inline constexpr bool kIsCharacters = false;
template <class Kind>
inline constexpr bool kIsCharacters<Characters<Kind>> = true;
template <class T>
inline constexpr bool kIsList = false;
template <class Kind>
inline constexpr bool kIsList<List<Kind>> = true;
/// Whether entries of the answer have sources of their own.
template <class T>
inline constexpr bool kHasEntries = kIsSet<T> || std::is_same_v<T, Roles>;

template <class E, std::size_t Most>
std::string written(const Set<E, Most>& set) {
  std::string text;
  for (const auto& [entry, option] : members_of<E>())
    if (set.has(entry)) text += (text.empty() ? "" : " ") + std::string(option.slug);
  return text;
}

template <class E>
inline constexpr const char* kEntryName = "entry of the rule";
template <>
inline constexpr const char* kEntryName<Cause> = "cause that may be refused";

/// Change a set entry by entry, as lists are (rule_lists.hpp).
template <class E, std::size_t Most>
Wrong change(std::string_view name, Set<E, Most>& set, std::string_view text) {
  const auto members = members_of<E>();
  std::vector<std::string_view> words;
  words.reserve(members.size());
  for (const auto& member : members) words.push_back(member.second.slug);
  std::string list = written(set);
  const auto check = [&](std::string_view entry) { return one_of(kEntryName<E>, entry, words); };
  if (auto wrong = change_list(name, list, text, check)) return wrong;
  set = {};
  for (const std::string_view word : split_entries(list))
    for (const auto& [entry, option] : members)
      if (option.slug == word) set.put(entry);
  return std::nullopt;
}

std::string written(const Roles& roles) {
  std::string text;
  for (const Roles::Entry& entry : roles.entries())
    text +=
        (text.empty() ? "" : " ") + entry.code.text() + "=" + std::string(to_string(entry.role));
  return text;
}

/// Change the roles code by code, as lists are (rule_lists.hpp).
Wrong change(std::string_view name, Roles& roles, std::string_view text) {
  std::string list = written(roles);
  if (auto wrong = change_list(name, list, text, check_role)) return wrong;
  roles = {};
  for (const std::string_view entry : split_entries(list)) {
    const auto equals = entry.find('=');
    if (const auto code = CodeName::read(entry.substr(0, equals)))
      roles.set(*code, role_of(entry.substr(equals + 1)));
  }
  return std::nullopt;
}

/// Change a set of codes entry by entry, as lists are (rule_lists.hpp).
Wrong change(std::string_view name, Codes& codes, std::string_view text) {
  std::string list = codes.text();
  if (auto wrong = change_list(name, list, text, check_code)) return wrong;
  codes = {};
  for (const std::string_view entry : split_entries(list))
    if (const auto code = read_code(entry)) codes.put(*code);
  return std::nullopt;
}

template <class T>
RuleValue shown(const T& value) {
  if constexpr (kIsSet<T> || std::is_same_v<T, Roles>)
    return written(value);
  else if constexpr (std::is_same_v<T, Codes> || kIsList<T>)
    return value.text();
  else if constexpr (kIsCharacters<T>)
    return std::string(value.text());
  else if constexpr (std::is_enum_v<T>)
    return std::string(options<T>()[static_cast<std::size_t>(value)].slug);
  else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>)
    return static_cast<std::int64_t>(value);
  else
    return value;
}

template <class E, std::size_t Most>
std::vector<Option> members(const Set<E, Most>& /*set*/) {
  std::vector<Option> all;
  for (const auto& member : members_of<E>()) all.push_back(member.second);
  return all;
}

template <class T>
RuleView view(const char* name, const char* group, const char* meaning, const Rule<T>& rule,
              const T& family) {
  RuleView row{name,          group, meaning, shown(rule.value), shown(family), rule.source,
               rule.evidence, {},    {},      rule.entries};
  if constexpr (std::is_enum_v<T>) row.options = options<T>();
  if constexpr (kIsSet<T>) row.members = members(rule.value);
  return row;
}

std::string joined(const std::vector<Option>& list) {
  std::string text;
  for (const Option& option : list) text += (text.empty() ? "" : ", ") + std::string(option.slug);
  return text;
}

template <class E>
  requires std::is_enum_v<E>
Wrong assign_value(std::string_view name, E& place, const RuleValue& value) {
  const auto& list = options<E>();
  if (const auto* slug = std::get_if<std::string>(&value))
    for (std::size_t i = 0; i < list.size(); ++i)
      if (list[i].slug == *slug) {
        place = static_cast<E>(i);
        return std::nullopt;
      }
  return std::string(name) + " must be one of " + joined(list);
}

Wrong assign_value(std::string_view name, bool& place, const RuleValue& value) {
  const auto* yes = std::get_if<bool>(&value);
  if (yes == nullptr) return std::string(name) + " must be True or False";
  place = *yes;
  return std::nullopt;
}

Wrong assign_value(std::string_view name, int& place, const RuleValue& value) {
  const auto* number = std::get_if<std::int64_t>(&value);
  if (number == nullptr || *number < 0 || *number > kLargestSetting)
    return std::string(name) + " must be a whole number from 0 to " +
           std::to_string(kLargestSetting);
  place = static_cast<int>(*number);
  return std::nullopt;
}

template <class T>
Wrong assign([[maybe_unused]] const Control& control, std::string_view name, Rule<T>& rule,
             const RuleValue& value) {
  if constexpr (std::is_enum_v<T> || std::is_integral_v<T>) {
    return assign_value(name, rule.value, value);
  } else {
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr) return std::string(name) + " must be a text";
    if constexpr (std::is_same_v<T, Ranges>)
      return change_commons(control, rule.value, *text);
    else if constexpr (std::is_same_v<T, VariableOptions>)
      return change_variable_options(control, rule.value, *text);
    else
      return change(name, rule.value, *text);
  }
}

template <class E, std::size_t Most>
void tell_changes(Rule<Set<E, Most>>& rule, const Set<E, Most>& before, const std::string& source,
                  Evidence evidence) {
  for (const auto& [entry, option] : members_of<E>())
    if (rule.value.has(entry) != before.has(entry)) rule.tell(option.slug, source, evidence);
}

void tell_changes(Rule<Roles>& rule, const Roles& before, const std::string& source,
                  Evidence evidence) {
  for (const Roles& side : {before, rule.value})
    for (const Roles::Entry& entry : side.entries())
      if (rule.value.of(entry.code) != before.of(entry.code))
        rule.tell(entry.code.text(), source, evidence);
}

/// Set the source of an answer that changed; of a set, that of the entries that came or went.
template <class T>
void follow_rule(Rule<T>& rule, const T& before, const std::string& source, Evidence evidence) {
  if (rule.value == before) return;
  if constexpr (kHasEntries<T>)
    tell_changes(rule, before, source, evidence);
  else
    rule = {rule.value, source, evidence};
}

/// Return why the control has no rule of this name, where its group is absent.
Wrong no_such_rule(const Control& control, RuleGroup group, std::string_view rule) {
  const AbsentGroup* const absent = control.lacks(group);
  if (absent == nullptr) return std::nullopt;
  return control.name + " has no rules of " + std::string(to_string(group)) + ", such as " +
         std::string(rule) + ": " + absent->source;
}

/// Set the source of an answer that somebody gave; of a set only what came or went is theirs.
template <class T>
void set_source(Rule<T>& rule, [[maybe_unused]] const T& before, const std::string& source,
                Evidence evidence) {
  if constexpr (kHasEntries<T>) {
    tell_changes(rule, before, source, evidence);
  } else {
    rule.source = source;
    rule.evidence = evidence;
  }
}

}  // namespace

std::string_view to_string(RuleGroup group) {
  static constexpr std::string_view kNames[] = {
#define GROUP(Type, name, meaning) #name,
#define END_GROUP(Type, name)
#define RULE(group, type, name, value, meaning)
#include "cncsub/control/rules.def"
  };
  return kNames[static_cast<std::size_t>(group)];
}

const AbsentGroup* Control::lacks(RuleGroup group) const {
  const auto found = std::find_if(absent.begin(), absent.end(),
                                  [group](const AbsentGroup& of) { return of.group == group; });
  return found == absent.end() ? nullptr : &*found;
}

void leave_out(Control& control, RuleGroup group, const std::string& source, Evidence evidence) {
  control.absent.push_back({group, source, evidence});
#define GROUP(Type, name, meaning) \
  if (group == RuleGroup::Type) control.name = Type();
#define END_GROUP(Type, name)
#define RULE(group, type, name, value, meaning)
#include "cncsub/control/rules.def"
  if (group != RuleGroup::MacroRules) return;
  // No statement is one of the control's, so none is read and asked about.
  control.macros.statements.value = {};
  control.macros.functions.value = {};
  control.macros.short_functions.value = false;
}

std::vector<RuleView> rules(const Control& control) {
  std::vector<RuleView> all;
#define GROUP(Type, name, meaning) if (control.lacks(RuleGroup::Type) == nullptr) {
#define END_GROUP(Type, name) }
#define RULE(group, type, name, standard, meaning) \
  all.push_back(view<type>(#name, #group, meaning, control.group.name, standard));
#include "cncsub/control/rules.def"
  return all;
}

std::optional<std::string> set_rule(Control& control, const std::string& rule_name,
                                    const RuleValue& value, const std::string& source,
                                    Evidence evidence) {
#define GROUP(Type, name, meaning) \
  {                                \
    constexpr auto kGroup = RuleGroup::Type;
#define END_GROUP(Type, name) }
#define RULE(group, type, name, default_value, meaning)                   \
  if (rule_name == #name) {                                               \
    if (auto none = no_such_rule(control, kGroup, #name)) return none;    \
    const type before = control.group.name.value;                         \
    auto wrong = assign(control, #name, control.group.name, value);       \
    if (!wrong) set_source(control.group.name, before, source, evidence); \
    return wrong;                                                         \
  }
#include "cncsub/control/rules.def"
  return "there is no rule " + rule_name;
}

void tell_entries(Control& control, const std::string& rule_name,
                  const std::vector<EntrySource>& entries) {
#define RULE(group, type, name, default_value, meaning) \
  if (rule_name == #name) control.group.name.entries = entries;
#include "cncsub/control/rules.def"
}

Answers::Answers(const Control& control) {
#define RULE(group, type, name, standard, meaning) name = control.group.name.value;
#include "cncsub/control/rules.def"
}

void follow(Control& control, const Answers& before, const std::string& source, Evidence evidence) {
#define RULE(group, type, name, standard, meaning) \
  follow_rule(control.group.name, before.name, source, evidence);
#include "cncsub/control/rules.def"
}

void give_role(Rule<Roles>& rule, CodeName code, Role role, const std::string& source,
               Evidence evidence) {
  rule.value.set(code, role);
  rule.tell(code.text(), source, evidence);
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

/// Weaken every fact that is stronger than its sources are on this control, whoever wrote it down.
void judge(Control& c) {
  const auto weaken = [&c](const std::string& source, Evidence& evidence) {
    evidence = std::max(evidence, strongest(source, c.name));
  };
#define RULE(group, type, name, value, meaning)       \
  weaken(c.group.name.source, c.group.name.evidence); \
  for (EntrySource& reported : c.group.name.entries) weaken(reported.source, reported.evidence);
#include "cncsub/control/rules.def"
  for (AbsentGroup& group : c.absent) weaken(group.source, group.evidence);
  for (Parameter& p : c.parameters) weaken(p.source, p.evidence);
  for (VariableRange& v : c.variables) weaken(v.source, v.evidence);
  for (VariableOption& option : c.variable_choices) weaken(option.source, option.evidence);
  for (CodeCall& call : c.code_calls) weaken(call.source, call.evidence);
  for (auto& [cause, entry] : c.alarms) weaken(entry.source, entry.evidence);
}

/// Sort parameters by their numbers and bits.
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

void complete(Control& control) {
  sort_parameters(control);
  judge(control);
}

}  // namespace cncsub
