// The rules of two controls that make a difference, found by exchanging them until it goes.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cncsub/comparison/parting.hpp"
#include "cncsub/control/control.hpp"

namespace cncsub {

/// A rule or a parameter as two controls have it. `examples`: what the values mean, where they say.
struct RuleApart {
  std::string name, meaning;
  std::array<std::string, 2> values, examples;
};

/// The rules of one control that another one answers otherwise, and parameters that are no rules.
class RuleExchange {
 public:
  using Names = std::vector<std::string>;
  using ControlPtr = std::shared_ptr<const Control>;

  RuleExchange(ControlPtr one, ControlPtr other);

  /// Return the first control with the values of the other one for these; null where they do not go
  /// together.
  ControlPtr control(const Names& names) const;
  /// Return all that can be exchanged: rules, then parameters.
  Names all() const;
  /// Return the rules whose values could not be given to the first control.
  const Names& untried() const { return untried_; }
  RuleApart apart(const std::string& name) const;

 private:
  void list_parameters();

  ControlPtr one_, other_;
  std::vector<RuleView> rules_, others_;
  std::vector<std::pair<std::string, RuleValue>> changes_;
  std::vector<std::pair<std::string, double>> parameters_;
  Names untried_;
};

/// Runs the texts of the first side, read for another control; empty where they do not run so.
using RunOn = std::function<Runner(const RuleExchange::ControlPtr&)>;

/// Return the fewest rules and parameters that make a difference: the first control with the second
/// one's values for these does what the second one does, as far as this difference. None where even
/// all of them do not make it.
RuleExchange::Names rules_that_make(const Parting& parting, const Sides& sides,
                                    const RuleExchange& exchange, const RunOn& run_on,
                                    InterruptCheck& interrupt);

}  // namespace cncsub
