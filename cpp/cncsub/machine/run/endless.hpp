// Finds why a run that was stopped from outside the program had not ended, by running on.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

struct Endless {
  enum class Kind : std::uint8_t {
    Repeats,  // by design: M99 of the main program starts it over
    Loop,     // the whole state came back exactly, without a look outside: it never ends
    Waiting,  // the run waits for what nobody gives
    Long,     // nothing is proven: it may end
  };
  Kind kind = Kind::Long;
  bool proven = false;          // the whole state came back exactly
  std::int64_t period = 0;      // blocks from a state until it comes back, 0 where it did not
  std::string outside;          // it came back, but the loop reads this from the world outside
  std::int64_t looked = 0;      // blocks that were executed to find out
  std::vector<Address> blocks;  // the blocks of the loop, each once, in the order in which they
                                // run; or the block that starts the program over, or that waits
  std::vector<std::string> changing;  // what differs from one pass to the next: "#100", "X"
  Stop then = Stop::Running;          // how the run would have stopped within these blocks
};
std::string_view to_string(Endless::Kind kind);

constexpr std::int64_t kFurtherBlocks = 100'000;

/// Run a copy on for up to `blocks` blocks, without recording, and return what that shows. `run`
/// stopped with Stop::Limit, Stop::Cycles or Stop::Waiting; for the last two no copy runs. Where
/// `gives_up` ends the search, the result holds what was found until then.
Endless why_endless(const Run& run, std::int64_t blocks, const std::function<bool()>& gives_up);

}  // namespace cncsub
