// Blocks that are typed in MDI while a run stands between two blocks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Return why a run cannot execute the text that a library has more than its own; nothing where it
/// can.
std::optional<std::string> refused_text(const Run& run, const Code& with);
/// Make the blocks of a typed text those that run next. They run at the present level of locals,
/// and after them the run goes on at the block where it stands now. `drops`: the text before it is
/// left, in which an alarm came.
void enter_typed(Run& run, std::int32_t program, bool drops);
/// Leave a typed text whose last block was executed.
void leave_typed(Run& run);

}  // namespace cncsub
