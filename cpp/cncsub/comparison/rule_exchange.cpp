#include "cncsub/comparison/rule_exchange.hpp"

#include <algorithm>
#include <cstddef>
#include <variant>

#include "cncsub/dialect/asked.hpp"
#include "cncsub/system/decimal.hpp"

namespace cncsub {

namespace {

std::string text_of(const RuleValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  return std::get<bool>(value) ? "yes" : "no";
}

const RuleView* find(const std::vector<RuleView>& rules, const std::string& name) {
  const auto found = std::find_if(rules.begin(), rules.end(),
                                  [&](const RuleView& rule) { return rule.name == name; });
  return found == rules.end() ? nullptr : &*found;
}

/// Return how a rule is given this value: a set is merged, unless = stands before it. Nothing where
/// it cannot be given.
std::optional<RuleValue> written(const Control& control, const std::string& name,
                                 const RuleValue& value) {
  for (const bool whole : {false, true}) {
    RuleValue tried = value;
    if (whole) tried = "= " + text_of(value);
    Control changed = control;
    if (set_rule(changed, name, tried)) continue;
    const std::vector<RuleView> now = asked_rules(changed);
    const RuleView* const rule = find(now, name);
    if (rule != nullptr && rule->value == value) return tried;
  }
  return std::nullopt;
}

}  // namespace

RuleExchange::RuleExchange(ControlPtr one, ControlPtr other)
    : one_(std::move(one)),
      other_(std::move(other)),
      rules_(asked_rules(*one_)),
      others_(asked_rules(*other_)) {
  for (const RuleView& rule : rules_) {
    const RuleView* const theirs = find(others_, rule.name);
    if (theirs == nullptr || theirs->value == rule.value) continue;
    if (auto value = written(*one_, rule.name, theirs->value))
      changes_.emplace_back(rule.name, *value);
    else
      untried_.push_back(rule.name);
  }
  list_parameters();
}

/// List the parameters of one family of controls that differ and are no rules.
void RuleExchange::list_parameters() {
  const auto &mine = one_->parameters, &theirs = other_->parameters;
  const auto same_name = [](const Parameter& a, const Parameter& b) { return a.name == b.name; };
  if (!std::equal(mine.begin(), mine.end(), theirs.begin(), theirs.end(), same_name)) return;
  for (std::size_t i = 0; i < mine.size(); ++i)
    if (mine[i].sets.empty() && mine[i].read_by.empty() && mine[i].value != theirs[i].value)
      parameters_.emplace_back(mine[i].name, theirs[i].value);
}

RuleExchange::Names RuleExchange::all() const {
  Names names;
  for (const auto& change : changes_) names.push_back(change.first);
  for (const auto& parameter : parameters_) names.push_back(parameter.first);
  return names;
}

RuleExchange::ControlPtr RuleExchange::control(const Names& names) const {
  auto changed = std::make_shared<Control>(*one_);
  const auto wanted = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const auto& [name, value] : changes_)
    if (wanted(name) && set_rule(*changed, name, value)) return nullptr;
  for (const auto& [name, value] : parameters_)
    if (wanted(name) && changed->set_parameter(name, value)) return nullptr;
  return changed;
}

RuleApart RuleExchange::apart(const std::string& name) const {
  RuleApart apart{name, "", {}, {}};
  for (std::size_t side = 0; side < 2; ++side) {
    const RuleView* const rule = find(side == 0 ? rules_ : others_, name);
    if (rule != nullptr) {
      apart.meaning = rule->meaning;
      apart.values[side] = text_of(rule->value);
      for (const auto& option : rule->options)
        if (option.slug == apart.values[side]) apart.examples[side] = option.example;
      continue;
    }
    for (const Parameter& of : (side == 0 ? one_ : other_)->parameters)
      if (of.name == name) {
        apart.meaning = of.meaning;
        apart.values[side] = system::shortest(of.value);
      }
  }
  return apart;
}

namespace {

using Names = RuleExchange::Names;

/// Return a set of names that explains and of which none can be left out; none where all of them do
/// not explain.
Names fewest(Names names, const std::function<bool(const Names&)>& explains) {
  if (!explains(names)) return {};
  const auto without = [&](std::size_t first, std::size_t last) {
    Names rest(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(first));
    rest.insert(rest.end(), names.begin() + static_cast<std::ptrdiff_t>(last), names.end());
    return rest;
  };
  for (std::size_t parts = 2; names.size() > 1;) {
    const std::size_t size = (names.size() + parts - 1) / parts;
    bool fewer = false;
    for (std::size_t first = 0; first < names.size() && !fewer; first += size) {
      const std::size_t last = std::min(first + size, names.size());
      Names piece(names.begin() + static_cast<std::ptrdiff_t>(first),
                  names.begin() + static_cast<std::ptrdiff_t>(last));
      const std::size_t pieces = (names.size() + size - 1) / size;
      Names rest = without(first, last);
      if (explains(piece))
        names = std::move(piece), parts = 2, fewer = true;
      else if (pieces > 2 && explains(rest))
        names = std::move(rest), parts = std::max<std::size_t>(parts - 1, 2), fewer = true;
    }
    if (fewer) continue;
    if (size == 1) break;
    parts = std::min(names.size(), 2 * parts);
  }
  return names;
}

}  // namespace

RuleExchange::Names rules_that_make(const Parting& parting, const Sides& sides,
                                    const RuleExchange& exchange, const RunOn& run_on,
                                    InterruptCheck& interrupt) {
  const std::int64_t limit = std::min(parting.first, parting.second) + 1;  // as far as it goes
  const auto limited = [limit](const Runner& runner) -> Runner {
    return [limit, runner](std::int64_t most, const std::vector<std::int32_t>& watch) {
      return runner(std::min(limit, most), watch);
    };
  };
  Sides tried = sides;
  tried[1].again = limited(sides[1].again);
  tried[1].run = tried[1].again(limit, {});
  if (!tried[1].run) return {};
  const auto explains = [&](const Names& names) {
    const RuleExchange::ControlPtr control = exchange.control(names);
    const Runner runner = control == nullptr ? Runner() : run_on(control);
    if (!runner) return false;
    tried[0].again = limited(runner);
    tried[0].run = tried[0].again(limit, {});
    return tried[0].run && !parting_of(Question::Controls, tried, interrupt);
  };
  return fewest(exchange.all(), explains);
}

}  // namespace cncsub
