// The record of the running block for an observer that writes it down: the words as they were
// executed, with their values, and what was assigned and said. A run without an observer only looks
// at a pointer for it, and plain moves not even at that.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/motion/state/machine_inputs.hpp"

namespace cncsub {

struct Observer {
  /// An assignment to what is neither a local nor a common: an offset, an output, #3000, #3006.
  struct Assigned {
    std::int64_t number = 0;
    double value = 0;
    std::string comment;
  };

  // The block, or the variant of it, whose words were executed. Plain moves of programs without
  // modal calls are not observed: they are the words of their block.
  const Block* words = nullptr;
  bool computed = false;  // some of its words are computed: these are their values
  NcWords values;
  BlockCodes codes;
  bool returned = false;          // M99 of the main program
  const HCode* raised = nullptr;  // G65 H99, with the value of its P
  double raised_number = 0;
  std::vector<Assigned> assigned;
  Op device = Op::Words;  // OpenOutput or CloseOutput
  const Print* print = nullptr;
  std::vector<double> printed;  // the values of its fields, in order
  std::optional<Profile> profile;
  std::vector<BlockCodes> restored;  // codes that a return from a call has put in force again
  bool frame_restored = false;       // it changed the frame of the program too

  bool any() const {
    return words != nullptr || print != nullptr || raised != nullptr || device != Op::Words ||
           !assigned.empty() || !restored.empty() || frame_restored;
  }
  void forget() {
    words = nullptr;
    device = Op::Words;
    print = nullptr;
    raised = nullptr;
    computed = returned = false;
    assigned.clear();
    printed.clear();
    profile.reset();
    restored.clear();
    frame_restored = false;
  }
  /// Keep the words of a block; `of_run` are codes that do not outlive it.
  void keep(const Block& block, const NcWords& decoded, const BlockCodes& of_run) {
    words = &block;
    computed = true;
    values = decoded;
    if (decoded.codes != &of_run) return;
    codes = of_run;
    values.codes = &codes;
  }
};

}  // namespace cncsub
