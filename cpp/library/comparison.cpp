// The rules of two controls that make a difference, found by exchanging them until it goes.
#include "cncsub/comparison.hpp"

#include <algorithm>
#include <utility>

#include "cncsub/dialect/asked.hpp"
#include "cncsub/system/decimal.hpp"
#include "parting.hpp"

namespace cncsub::api {

namespace {

using Names = std::vector<std::string>;
using ControlPtr = std::shared_ptr<const cncsub::Control>;

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
std::optional<RuleValue> written(const cncsub::Control& control, const std::string& name,
                                 const RuleValue& value) {
  for (const bool whole : {false, true}) {
    RuleValue tried = value;
    if (whole) tried = "= " + text_of(value);
    cncsub::Control changed = control;
    if (set_rule(changed, name, tried)) continue;
    const std::vector<RuleView> now = asked_rules(changed);
    const RuleView* const rule = find(now, name);
    if (rule != nullptr && rule->value == value) return tried;
  }
  return std::nullopt;
}

/// The rules of one control that another one answers otherwise, and parameters that are no rules.
class Exchange {
 public:
  Exchange(const cncsub::Control& one, const cncsub::Control& other);

  /// Return the first control with the values of the other one for these; null where they do not go
  /// together.
  ControlPtr control(const Names& names) const;
  Names all() const;
  RuleApart apart(const std::string& name) const;
  const Names& untried() const { return untried_; }

 private:
  void list_parameters();

  const cncsub::Control &one_, &other_;
  std::vector<RuleView> rules_, others_;
  std::vector<std::pair<std::string, RuleValue>> changes_;
  std::vector<std::pair<std::string, double>> parameters_;
  Names untried_;
};

Exchange::Exchange(const cncsub::Control& one, const cncsub::Control& other)
    : one_(one), other_(other), rules_(asked_rules(one)), others_(asked_rules(other)) {
  for (const RuleView& rule : rules_) {
    const RuleView* const theirs = find(others_, rule.name);
    if (theirs == nullptr || theirs->value == rule.value) continue;
    if (auto value = written(one, rule.name, theirs->value))
      changes_.emplace_back(rule.name, *value);
    else
      untried_.push_back(rule.name);
  }
  list_parameters();
}

/// List the parameters of one family of controls that differ and are no rules.
void Exchange::list_parameters() {
  const auto &mine = one_.parameters, &theirs = other_.parameters;
  const auto same_name = [](const Parameter& a, const Parameter& b) { return a.name == b.name; };
  if (!std::equal(mine.begin(), mine.end(), theirs.begin(), theirs.end(), same_name)) return;
  for (std::size_t i = 0; i < mine.size(); ++i)
    if (mine[i].sets.empty() && mine[i].read_by.empty() && mine[i].value != theirs[i].value)
      parameters_.emplace_back(mine[i].name, theirs[i].value);
}

Names Exchange::all() const {
  Names names;
  for (const auto& change : changes_) names.push_back(change.first);
  for (const auto& parameter : parameters_) names.push_back(parameter.first);
  return names;
}

ControlPtr Exchange::control(const Names& names) const {
  auto changed = std::make_shared<cncsub::Control>(one_);
  const auto wanted = [&](const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const auto& [name, value] : changes_)
    if (wanted(name) && set_rule(*changed, name, value)) return nullptr;
  for (const auto& [name, value] : parameters_)
    if (wanted(name) && changed->set_parameter(name, value)) return nullptr;
  return changed;
}

RuleApart Exchange::apart(const std::string& name) const {
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
    for (const Parameter& of : (side == 0 ? one_ : other_).parameters)
      if (of.name == name) {
        apart.meaning = of.meaning;
        apart.values[side] = system::shortest(of.value);
      }
  }
  return apart;
}

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

/// The same texts on two controls.
class Compared {
 public:
  Compared(std::array<Side, 2> sides, const std::function<bool()>& interrupted)
      : sides_(std::move(sides)), interrupted_(interrupted) {}

  Result<Comparison> result();

 private:
  std::optional<cncsub::Machine> run(const Side& side, std::int64_t max_blocks,
                                     const std::vector<std::int32_t>& watch) const;
  bool is_interrupted() const { return interrupted_ && interrupted_(); }
  std::vector<RuleApart> rules(const Parting& parting, Names& untried) const;

  std::array<Side, 2> sides_;
  const std::function<bool()>& interrupted_;
};

std::optional<cncsub::Machine> Compared::run(const Side& side, std::int64_t max_blocks,
                                             const std::vector<std::int32_t>& watch) const {
  Options options = side.options;
  options.max_blocks = std::min(options.max_blocks, max_blocks);
  Result<cncsub::Machine> machine = machine_of(side.code, options, watch);
  if (!machine) return std::nullopt;
  machine->run(interrupted_);
  return *machine;
}

std::vector<RuleApart> Compared::rules(const Parting& parting, Names& untried) const {
  const std::int64_t limit = std::min(parting.first, parting.second) + 1;
  const Runner runner = [this, limit](const Side& side, std::int64_t most, const auto& watch) {
    return run(side, std::min(limit, most), watch);
  };
  const auto wanted = run(sides_[1], limit, {});
  if (!wanted) return {};
  const Exchange exchange(*sides_[0].code->control, *sides_[1].code->control);
  const auto explains = [&](const Names& names) {
    const ControlPtr control = is_interrupted() ? nullptr : exchange.control(names);
    if (control == nullptr) return false;
    std::array<Side, 2> both = sides_;
    both[0].code = read_again(*sides_[0].code, control);
    const auto tried = run(both[0], limit, {});
    return tried && !parting_of(both, *tried, *wanted, runner);
  };
  std::vector<RuleApart> made;
  for (const std::string& name : fewest(exchange.all(), explains))
    made.push_back(exchange.apart(name));
  untried = exchange.untried();
  return made;
}

Result<Comparison> Compared::result() {
  std::vector<cncsub::Machine> runs;
  for (const Side& side : sides_) {
    Result<cncsub::Machine> machine = machine_of(side.code, side.options);
    if (!machine) return Error{machine.error().option, side.name + ": " + machine.error().message};
    machine->run(interrupted_);
    runs.push_back(std::move(*machine));
  }
  const Runner runner = [this](const Side& side, std::int64_t most, const auto& watch) {
    return run(side, most, watch);
  };
  Comparison comparison;
  const auto parting = parting_of(sides_, runs[0], runs[1], runner);
  comparison.same = !parting;
  if (parting) {
    comparison.what = parting->what;
    comparison.step = {parting->first, parting->second};
    comparison.rules = rules(*parting, comparison.untried);
  }
  if (is_interrupted()) return Error{"", "the comparison was interrupted"};
  for (cncsub::Machine& machine : runs)
    comparison.runs.emplace_back(
        std::make_shared<const Run::Inside>(Run::Inside{std::move(machine)}));
  return comparison;
}

}  // namespace

Result<Comparison> compare(const Library& first, const Library& second, const Options& options,
                           const std::function<bool()>& interrupted) {
  Options all = options;
  all.record = Record::Moves;
  const std::shared_ptr<const Code>& one = first.inside().code;
  const std::shared_ptr<const Code>& other = second.inside().code;
  const bool named = one->control->name != other->control->name;
  const std::array<Side, 2> sides = {Side{one, all, named ? one->control->name : "first"},
                                     Side{other, all, named ? other->control->name : "second"}};
  return Compared(sides, interrupted).result();
}

}  // namespace cncsub::api
