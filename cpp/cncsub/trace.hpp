// What a run leaves behind: a row per executed block, per call, and what was sent to the machine.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "cncsub/code.hpp"
#include "cncsub/column.hpp"
#include "cncsub/moves.hpp"

namespace cncsub {

struct CallRow {
  std::int32_t parent = -1;
  std::int32_t program = 0;
  std::int32_t start_n = -1;
  std::int32_t repeats = 1;
  std::int32_t level = 0;
  std::int32_t depth = 0;
  std::uint32_t record = 0;  // into Code::calls
  CallKind kind = CallKind::M98;
  std::int64_t first_step = 0, last_step = -1, caller_step = 0;
  std::uint32_t first_argument = 0, arguments = 0;
};

struct Trace {
  struct Argument {
    std::int32_t variable;
    double value;
  };
  enum class Depth : std::uint8_t { None, Calls, Blocks, Moves };
  struct Step {
    Address address;
    std::int32_t call;
    std::int32_t repeat;
  };

  Depth depth = Depth::Moves;
  Column<Step> steps;
  Column<CallRow> calls;
  Column<Argument> arguments;
  Moves moves;
  std::vector<std::int64_t> m_codes, t_codes;
  std::vector<std::string> messages;
};

}  // namespace cncsub
