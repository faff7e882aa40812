// The first difference of two runs of the same programs on two controls.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "inside.hpp"

namespace cncsub::api {

/// A program on a control, and how it is run.
struct Side {
  std::shared_ptr<const Code> code;
  Options options;
  std::string name;  // of the control
};

/// The point where two runs part: a step of each, or the count of steps where a run has none.
struct Parting {
  std::int64_t first = 0, second = 0;
  std::string what;
};

/// Runs a side; `watch`: variables whose changes are kept. Empty where it cannot run so, or was
/// interrupted.
using Runner = std::function<std::optional<cncsub::Machine>(
    const Side&, std::int64_t max_blocks, const std::vector<std::int32_t>& watch)>;

/// Return the earliest of all differences, as `cncsub.compare` of Python finds it. Blocks and calls
/// are compared within one language only.
std::optional<Parting> parting_of(const std::array<Side, 2>& sides, const cncsub::Machine& one,
                                  const cncsub::Machine& other, const Runner& run);

}  // namespace cncsub::api
