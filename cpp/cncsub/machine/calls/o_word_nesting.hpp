// The branches and loops of O words around a block, as they stand in the text.
//
// The program itself nests nothing, so it has no jump that would say what one does to them.
#pragma once

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// Return the head of the outermost branch or loop that holds `to` and not `from`, two blocks of
/// one program; kNowhere where a jump enters none.
Address entered_by_jump(const Code& code, Address from, Address to);
/// Forget the counts of the repeats that do not hold the block, and what skipping has noted.
void leave_o_words(Run& run, Address to);

}  // namespace cncsub
