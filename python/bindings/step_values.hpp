// Columns that follow from a step: of the steps, and of what steps made.
#pragma once

#include <cstdint>
#include <string>

#include "live.hpp"

namespace cncsub::bindings {

/// Returns the program of a step, which is mostly that of the step before.
class ProgramOfStep {
 public:
  explicit ProgramOfStep(const Code& code) : code_(&code) {}

  std::int32_t operator()(const Trace::Step& step) {
    if (!surely_there(step.address)) last_ = code_->program_at(step.address);
    return last_;
  }

 private:
  /// Return whether a block certainly lies in the last program, and not in one that is a part of
  /// it.
  bool surely_there(Address address) const {
    const auto place = static_cast<std::size_t>(last_);
    const Program& guess = code_->programs[place];
    const bool before_next =
        place + 1 == code_->programs.size() || address < code_->programs[place + 1].first;
    return address >= guess.first && before_next && guess.inside == kNoProgram;
  }

  const Code* code_;
  std::int32_t last_ = 0;
};

/// Call `use` with the function that makes the column of a name out of a step; return false where
/// there is no such column. Each part of the rows gets a copy, which may remember the step before.
template <class Use>
bool with_step_value(const Record& record, const std::string& name, const Use& use) {
  const auto shared = record.code();
  const Code& code = *shared;
  const auto used = [&](auto value) {
    use(value);
    return true;
  };
  if (name == "program") return used(ProgramOfStep(code));
  if (name == "n") return used([&](const Trace::Step& s) { return code.blocks[s.address].n; });
  if (name == "line")
    return used([&](const Trace::Step& s) { return code.blocks[s.address].line; });
  if (name == "depth")
    return used([&](const Trace::Step& s) { return record.trace().depth_of(s.call); });
  if (name == "frame") return used([](const Trace::Step& s) { return s.call; });
  if (name == "repeat") return used([](const Trace::Step& s) { return s.repeat; });
  return false;
}

}  // namespace cncsub::bindings
