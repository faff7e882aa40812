// What a run went through: counted from its steps and calls, without a trace of its own.
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

/// How a block decides where the program goes on.
enum class Branch : std::uint8_t {
  None,
  IfGoto,   // IF [..] GOTO, and UNTIL
  IfThen,   // IF [..] THEN
  If,       // IF [..] THEN .. ENDIF
  ElseIf,   // o1 elseif
  DoWhile,  // o1 while behind o1 do
  HJump,    // G65 H81 to H86
  Input,    // M96
  While,    // from here on loops: passes are counted
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

  // By the loop's address: entries without a pass, with one, with more.
  std::unordered_map<Address, std::array<std::int64_t, 3>> loops;
  std::vector<Call> calls;
  std::vector<Given> arguments;
};

/// By address, each with room for all blocks and zeros in it.
struct BlockCounts {
  std::int64_t* held;     // executions whose condition held, or that have none
  std::int64_t* failed;   // the others
  std::int64_t* skipped;  // how often a block-skip switch passed over the block
};

/// Counts a whole run, which has recorded its blocks. What was passed over is no step: it is told
/// from the steps around it, and not counted where only a computed jump or a start in the middle of
/// a program may have led there.
Coverage coverage_of(const Code& code, const Trace& trace, const BlockCounts& counts,
                     InterruptCheck& interrupt);

}  // namespace cncsub
