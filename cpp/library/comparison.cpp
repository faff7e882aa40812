// Two libraries run and compared: what their handles hold goes to the engine, and comes back.
#include "cncsub/comparison.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cncsub/comparison/rule_exchange.hpp"
#include "inside.hpp"

namespace cncsub::api {

namespace {

using CodePtr = std::shared_ptr<const Code>;

Error was_interrupted() { return {"", "the comparison was interrupted"}; }

/// Runs that all end where the caller wants them to.
class Comparing {
 public:
  Comparing(const Options& options, const std::function<bool()>& interrupted)
      : options_(options), interrupted_(interrupted) {
    options_.record = Record::Moves;
  }

  Result<Comparison> compared(const std::array<CodePtr, 2>& codes,
                              const std::array<std::string, 2>& names) const;

 private:
  bool is_interrupted() const { return interrupted_ && interrupted_(); }
  Runner runner_of(const CodePtr& code) const;

  Options options_;
  const std::function<bool()>& interrupted_;
};

/// Return what runs a program again; an interrupted run is none.
Runner Comparing::runner_of(const CodePtr& code) const {
  return [this, code](std::int64_t most, const std::vector<std::int32_t>& watch) -> Ran {
    Options options = options_;
    options.max_blocks = std::min(options.max_blocks, most);
    Result<cncsub::Machine> machine = machine_of(code, options, watch);
    if (!machine) return nullptr;
    machine->run(interrupted_);
    if (machine->stop() == cncsub::Stop::Interrupted) return nullptr;
    return std::make_shared<const cncsub::Machine>(std::move(*machine));
  };
}

Result<Comparison> Comparing::compared(const std::array<CodePtr, 2>& codes,
                                       const std::array<std::string, 2>& names) const {
  Sides sides;
  for (std::size_t side = 0; side < 2; ++side) {
    Result<cncsub::Machine> machine = machine_of(codes[side], options_);
    if (!machine)
      return Error{machine.error().option, names[side] + ": " + machine.error().message};
    machine->run(interrupted_);
    if (machine->stop() == cncsub::Stop::Interrupted) return was_interrupted();
    sides[side] = {names[side], std::make_shared<const cncsub::Machine>(std::move(*machine)),
                   runner_of(codes[side])};
  }
  InterruptCheck interrupt(interrupted_);
  Comparison comparison;
  const auto parting = parting_of(Question::Controls, sides, interrupt);
  comparison.same = !parting;
  if (parting) {
    comparison.what = parting->what;
    comparison.step = {parting->first, parting->second};
    const RuleExchange exchange(codes[0]->control, codes[1]->control);
    const auto run_on = [&](const RuleExchange::ControlPtr& control) -> Runner {
      if (is_interrupted()) return {};
      return runner_of(read_again(*codes[0], control));
    };
    for (const std::string& name : rules_that_make(*parting, sides, exchange, run_on, interrupt)) {
      cncsub::RuleApart apart = exchange.apart(name);
      comparison.rules.push_back({std::move(apart.name), std::move(apart.meaning),
                                  std::move(apart.values), std::move(apart.examples)});
    }
    comparison.untried = exchange.untried();
  }
  if (is_interrupted()) return was_interrupted();
  for (const Side& side : sides)
    comparison.runs.emplace_back(std::make_shared<const Run::Inside>(Run::Inside{*side.run}));
  return comparison;
}

}  // namespace

Result<Comparison> compare(const Library& first, const Library& second, const Options& options,
                           const std::function<bool()>& interrupted) {
  const std::array<CodePtr, 2> codes = {first.inside().code, second.inside().code};
  const bool named = codes[0]->control->name != codes[1]->control->name;
  return Comparing(options, interrupted)
      .compared(codes, {named ? codes[0]->control->name : "first",
                        named ? codes[1]->control->name : "second"});
}

}  // namespace cncsub::api
