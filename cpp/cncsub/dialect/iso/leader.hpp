// What stands before the first % of a file: a leader, or a program.
#pragma once

#include <string_view>

#include "cncsub/code/builder.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

/// Whether the head of a program may begin with this mark.
bool heads(const Code& code, ProgramHead head);

/// Whether what the open program, the first of its file and without a head, holds before the % at
/// `percent` is a leader: a tape begins there, and no block before it could run. `text`: the file.
bool is_leader(Builder& to, std::string_view text, const Scanner& percent);

}  // namespace cncsub
