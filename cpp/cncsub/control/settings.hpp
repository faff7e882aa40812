// The settings of parameters, as data: `bit(rule::no_radius, NoRadius::Line, NoRadius::Alarm)`.
#pragma once

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "cncsub/control/control.hpp"

namespace cncsub {

/// A rule of any control: its name, and where it stands.
template <class T>
struct RuleOf {
  const char* name;
  Rule<T>& (*in)(Control&);
};

namespace rule {
#define RULE(group, type, name, value, meaning) \
  inline constexpr RuleOf<type> name{#name, [](Control& c) -> Rule<type>& { return c.group.name; }};
#include "cncsub/control/rules.def"
}  // namespace rule

/// Set one answer while the parameter is 0, another while it is not.
template <class T>
Setting bit(RuleOf<T> rule, const std::type_identity_t<T>& zero,
            const std::type_identity_t<T>& one) {
  return {rule.name, [=](Control& c, double v) { rule.in(c).value = v != 0 ? one : zero; }};
}
inline Setting bit(RuleOf<bool> rule) { return bit(rule, false, true); }

/// Keep the entry in the set while the parameter is not 0, or while it is.
template <class E, std::size_t Most>
Setting entry(RuleOf<Set<E, Most>> rule, std::type_identity_t<E> entry,
              bool while_not_zero = true) {
  return {std::string(rule.name) + ":" + std::string(slug_of(entry)),
          [=](Control& c, double v) { rule.in(c).value.put(entry, (v != 0) == while_not_zero); }};
}
template <class E, std::size_t Most>
Setting entry_while_zero(RuleOf<Set<E, Most>> rule, std::type_identity_t<E> left_out) {
  return entry(rule, left_out, false);
}

/// Set the rule to the number as it is.
Setting number(RuleOf<int> rule);
/// Set the rule to the number as it is; a 0 stands for this one.
Setting number(RuleOf<int> rule, int for_zero);
/// Set the rule, which holds thousandths, from millimetres.
Setting micrometres(RuleOf<int> rule);
/// Set it in the same way; a 0 leaves what the engine takes by itself.
Setting micrometres_unless_zero(RuleOf<int> rule);

/// Take the number as that of the M code with this role; a 0 stands for `usual`.
Setting code_of(Role role, int usual);

/// Set a rule from several parameters: the first one counts that is not 0.
template <class T>
Setting first_of(RuleOf<T> rule, const std::vector<std::pair<std::string, T>>& parameters,
                 std::type_identity_t<T> otherwise) {
  return {rule.name, [=](Control& c, double /*v*/) {
            rule.in(c).value = otherwise;
            for (const auto& [parameter, answer] : parameters)
              if (c.parameter(parameter) != 0) {
                rule.in(c).value = answer;
                return;
              }
          }};
}

/// Mark a parameter whose number the engine reads itself where the rule says so.
template <class T>
Parameter read_by(RuleOf<T> rule, Parameter parameter) {
  parameter.read_by = rule.name;
  return parameter;
}

}  // namespace cncsub
