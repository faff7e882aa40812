// The first difference of two runs.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cncsub/comparison/question.hpp"
#include "cncsub/machine/machine.hpp"
#include "cncsub/text/interrupt_check.hpp"

namespace cncsub {

/// A run that has stopped, with all of its trace; null where there is none.
using Ran = std::shared_ptr<const Machine>;

/// Runs a program again from its beginning, for no more than so many blocks. `watch`: the variables
/// whose changes are recorded.
using Runner = std::function<Ran(std::int64_t max_blocks, const std::vector<std::int32_t>& watch)>;

inline constexpr std::int64_t kAnyBlocks = INT64_MAX;

/// One of two runs that are compared.
struct Side {
  std::string name;  // in what is told: a control, "before"
  Ran run;
  Runner again;

  const Code& code() const { return run->code(); }
};
using Sides = std::array<Side, 2>;

/// The names and numbers that an edit changed.
struct Renamed {
  std::map<std::string, std::string> programs;     // name after the edit: name before
  std::map<std::int32_t, std::int32_t> variables;  // number before the edit: number after
};

/// The point where two runs part: a step of each, or the count of steps where a run has none.
struct Parting {
  std::int64_t first = 0, second = 0;
  std::string what;    // a line for each side
  std::string column;  // of the moves, where it is a move that differs
};

/// Return the earliest of all differences that count. Where `interrupt` is requested, or a run
/// cannot be made again, the result says nothing.
std::optional<Parting> parting_of(Question question, const Sides& sides, InterruptCheck& interrupt,
                                  const Renamed& renamed = {});

/// Return the numbers of the variables that both controls have and that hold a value in one of the
/// runs. Where a control lists a variable by a number that the other one has not, the numbers that
/// the programs write count too.
std::vector<std::int32_t> shared_variables(const Machine& one, const Machine& other);

/// Return how a run stopped, in a few words: "alarm PS0076 program-not-found at O1 N10".
std::string summary(const Machine& run);

}  // namespace cncsub
