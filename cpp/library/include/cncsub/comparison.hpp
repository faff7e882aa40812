// The same programs on two controls: where they part, and which rules make it. Beside cncsub.hpp.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "cncsub/cncsub.hpp"

namespace cncsub::api {

/// A rule or a parameter as two controls have it.
struct RuleApart {
  std::string name, meaning;
  std::array<std::string, 2> values, examples;
};

/// What two runs do otherwise. The first control with the second one's values for `rules` does what
/// the second one does, as far as this difference; no rules: it lies in the languages, or in tables
/// that are no rules.
struct Comparison {
  bool same = false;
  std::string what;  // a line for each control; empty where they do the same
  std::array<std::int64_t, 2>
      step{};  // where they part; the count of steps of one that has stopped
  std::vector<RuleApart> rules;
  std::vector<std::string> untried;  // rules whose values could not be exchanged
  std::vector<Run> runs;             // two
};

/// Run what two libraries hold, the same texts read for two controls, and compare them.
/// `interrupted` is asked now and then; where it returns true, the result is an Error.
CNCSUB_API Result<Comparison> compare(const Library& first, const Library& second,
                                      const Options& options = {},
                                      const std::function<bool()>& interrupted = {});

}  // namespace cncsub::api
