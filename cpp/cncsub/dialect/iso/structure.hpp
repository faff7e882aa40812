// What the statements of a program lead to: the partners of loops and IF blocks, the blocks that
// jumps go to.
#pragma once

#include "cncsub/code/builder.hpp"

namespace cncsub {

/// Pairs WHILE and DO with END, IF with ELSE and ENDIF, and finds the blocks of GOTO. What has no
/// partner becomes a fault where it stands.
void match_structure(Builder& to, const Program& program);

}  // namespace cncsub
