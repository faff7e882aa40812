// The coverage of a run: counted from its steps and calls, without a trace of its own.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/text/interrupt_check.hpp"
#include "cncsub/trace/trace.hpp"

namespace cncsub {

/// The way in which a block decides where the program goes on.
enum class Branch : std::uint8_t {
  None,
  IfGoto,   // IF [..] GOTO, and UNTIL
  IfThen,   // IF [..] THEN
  If,       // IF [..] THEN .. ENDIF
  ElseIf,   // o1 elseif
  DoWhile,  // o1 while after o1 do
  HJump,    // G65 H81 to H86
  Input,    // M96
  For,      // ENDFOR: whether the loop goes on
  Case,     // CASE OF, several IF GOTO in a block: whether one of them jumps
  While,    // loops from here on: their passes are counted
  Repeat    // o1 repeat
};
std::string_view to_string(Branch branch);
constexpr bool is_loop(Branch branch) { return branch >= Branch::While; }

/// The branches of all blocks by their address, and where the loops end.
struct Branches {
  explicit Branches(const Code& code);

  std::vector<Branch> of;
  std::unordered_map<Address, Address> ends;
};

struct Coverage {
  struct Call {
    Address address;  // of the block that calls
    CallKind kind;
    std::int32_t program;
    std::int64_t count;
  };
  struct Given {
    std::int32_t program, variable;
    std::int64_t count;  // of calls that gave it
  };

  // By the address of the loop: how often it ran no pass, one, more than one.
  std::unordered_map<Address, std::array<std::int64_t, 3>> loops;
  std::vector<Call> calls;
  std::vector<Given> arguments;
};

/// Counts by address. Each array has room for all blocks and holds zeros.
struct BlockCounts {
  std::int64_t* held;     // executions whose condition held, or that have none
  std::int64_t* failed;   // executions whose condition did not hold
  std::int64_t* skipped;  // how often a block-skip switch passed over the block
};

/// Count a whole run, whose trace holds its blocks. A block that was passed over is no step: the
/// steps around it show it. It is not counted where only a computed jump or a start in the middle
/// of a program may have led there.
Coverage coverage_of(const Code& code, const Trace& trace, const BlockCounts& counts,
                     InterruptCheck& interrupt);

}  // namespace cncsub
