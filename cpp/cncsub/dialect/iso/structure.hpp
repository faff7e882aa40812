// The structure of a program's statements: the partners of loops and IF blocks, and the blocks that
// jumps go to.
#pragma once

#include "cncsub/code/builder.hpp"

namespace cncsub {

/// Pair WHILE and DO with END, IF with ELSE and ENDIF, and find the blocks of GOTO. A statement
/// without a partner becomes a fault where it stands.
void match_structure(Builder& to, const Program& program);

}  // namespace cncsub
