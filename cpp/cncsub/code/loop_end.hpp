// A loop that asks its condition at its end: that end is an IfGoto, and says where the loop begins.
#pragma once

#include <optional>

#include "cncsub/code/statement.hpp"

namespace cncsub {

/// `index` of such an IfGoto: where it leads, seen from the block that begins the loop.
enum class LoopEnd : std::int32_t {
  None = 0,        // the block ends no loop
  ToHead = 1,      // to the block that begins the loop
  BehindHead = 2,  // to the block after it
};

inline void end_loop_by(Statement& statement, LoopEnd leads) {
  statement.index = static_cast<std::int32_t>(leads);
}

/// Return the block that begins the loop that an IfGoto ends; nothing where it ends none.
inline std::optional<Address> head_of_loop(const Statement& statement) {
  const auto leads = static_cast<LoopEnd>(statement.index);
  if (leads == LoopEnd::None || statement.to == kNowhere) return std::nullopt;
  return statement.to - (leads == LoopEnd::BehindHead ? 1 : 0);
}

}  // namespace cncsub
