// The options of a run, and the answers of the world outside while it runs.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "cncsub/motion/state/setup.hpp"
#include "cncsub/motion/state/signals.hpp"
#include "cncsub/motion/state/workpiece.hpp"
#include "cncsub/trace/trace.hpp"

namespace cncsub {

/// The answers of the world outside, scripted.
struct Inputs {
  std::map<std::int32_t, double> signals;  // #1000 and the like, as they are at the start
  double clock_ms = 0;                     // #3001 when the run starts
  double date = 20000101;                  // #3011, YYYYMMDD
  double time = 0;                         // #3012, HHMMSS
  // The answers at M00, M01, #3006: cycle start, or not; all start when none is given.
  std::vector<bool> operator_starts;
  bool operator_given = false;
  // The variables that another program writes, each time the run waits.
  std::vector<std::map<std::int32_t, double>> writes;
  // The signals that blocks find which watch a skip signal, in order: whichever they watch (the
  // first list), or those of one signal. After the last one the workpiece decides.
  std::array<std::vector<SkipSignal>, kSkipSignals> skips;
  std::shared_ptr<const Workpiece> workpiece;
  // The values that the machine's signals take when it is sent a code: 'M' 117.
  std::map<std::pair<char, std::int64_t>, std::map<std::int32_t, double>> answers;
};

struct Options {
  bool mdi = false;         // what runs first was typed in MDI
  std::int64_t start = -1;  // the sequence number to start from; -1: the first block
  std::map<std::int32_t, double> variables;
  static constexpr int kSwitches = 10;  // that skip blocks, from 1
  std::uint16_t skips = 0;              // bit k: block-skip switch k is on
  bool optional_stop = false;
  std::int64_t max_cycles = 1;
  std::int64_t max_blocks = 10'000'000;
  double max_seconds = 0;                             // 0 = any
  std::uint64_t max_memory = std::uint64_t{4} << 30;  // bytes of what is recorded
  Trace::Depth trace = Trace::Depth::Moves;
  std::vector<std::int32_t> watch;  // variables that can be read, whose changes are kept
  bool conditions = false;          // what conditions compare is kept
  Inputs inputs;
  Setup setup;
};

}  // namespace cncsub
