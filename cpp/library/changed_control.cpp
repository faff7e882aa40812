// A control with rules and parameters that a caller changes, and the reading of a library for it.
#include <algorithm>
#include <utility>

#include "cncsub/control/rule_lists.hpp"
#include "cncsub/dialect/asked.hpp"
#include "cncsub/dialect/library.hpp"
#include "cncsub/system/decimal.hpp"
#include "inside.hpp"

namespace cncsub::api {

namespace {

/// Return a text as the kind of value that the rule has; nothing where it is none.
std::optional<RuleValue> value_as(const RuleValue& kind, const std::string& text) {
  if (std::holds_alternative<std::string>(kind)) return text;
  if (std::holds_alternative<bool>(kind)) {
    if (text == "true" || text == "false") return text == "true";
    return std::nullopt;
  }
  double number = 0;
  const system::Parsed read = system::parse(text, number, system::Decimal::Fixed);
  constexpr double kMost = 1e15;
  if (!read.number || read.length != text.size() || !(number > -kMost && number < kMost) ||
      number != static_cast<double>(static_cast<std::int64_t>(number)))
    return std::nullopt;
  return static_cast<std::int64_t>(number);
}

std::optional<Error> change_parameter(cncsub::Control& control, const std::string& name,
                                      const std::string& text) {
  double number = 0;
  const system::Parsed read = system::parse(text, number);
  if (!read.number || read.length != text.size())
    return Error{"changes", "parameter " + name + " must be a number, not " + text};
  if (auto wrong = control.set_parameter(name, number)) return Error{"changes", *wrong};
  return std::nullopt;
}

std::optional<Error> change_rule(cncsub::Control& control, const std::string& name,
                                 const std::string& text) {
  if (auto wrong = never_asked(control, name)) return Error{"changes", *wrong};
  std::vector<std::string_view> names;
  const std::vector<RuleView> all = asked_rules(control);
  for (const RuleView& rule : all) names.push_back(rule.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    return Error{"changes", "there is no rule " + name + near_words(name, names)};
  const RuleValue& kind = all[static_cast<std::size_t>(found - names.begin())].value;
  const auto value = value_as(kind, text);
  if (!value)
    return Error{"changes", name + (std::holds_alternative<bool>(kind)
                                        ? " must be true or false, not " + text
                                        : " must be a whole number, not " + text)};
  if (auto wrong = set_rule(control, name, *value)) return Error{"changes", *wrong};
  return std::nullopt;
}

bool has_parameter(const cncsub::Control& control, const std::string& name) {
  return std::any_of(control.parameters.begin(), control.parameters.end(),
                     [&](const Parameter& of) { return of.name == name; });
}

bool begins_with_digit(const std::string& name) {
  return !name.empty() && name[0] >= '0' && name[0] <= '9';
}

}  // namespace

Result<std::shared_ptr<const cncsub::Control>> changed_control(
    const std::string& name, const std::map<std::string, std::string>& changes) {
  const Result<const cncsub::Control*> found = control_named(name);
  if (!found) return found.error();
  const cncsub::Control* const known = *found;
  auto own = std::make_shared<cncsub::Control>(*known);
  // Parameters first, as in a file of one's own: they set rules that a rule of its own then
  // changes.
  for (const bool parameters : {true, false})
    for (const auto& [key, text] : changes) {
      if ((has_parameter(*known, key) || begins_with_digit(key)) != parameters) continue;
      if (auto wrong =
              parameters ? change_parameter(*own, key, text) : change_rule(*own, key, text))
        return *wrong;
    }
  return std::shared_ptr<const cncsub::Control>(std::move(own));
}

std::shared_ptr<const Code> read_again(const Code& code,
                                       std::shared_ptr<const cncsub::Control> control) {
  std::vector<SourceFile> files;
  for (const SourceFile& file : code.files)
    if (!file.system) files.push_back({file.name, file.stem, file.text, file.external});
  return compile(std::move(control), std::move(files), code.external_device);
}

Result<Library> Library::read_for(const std::string& control,
                                  const std::map<std::string, std::string>& changes) const {
  auto own = changed_control(control, changes);
  if (!own) return own.error();
  return Library(std::make_shared<const Inside>(Inside{read_again(*inside_->code, *own)}));
}

}  // namespace cncsub::api
