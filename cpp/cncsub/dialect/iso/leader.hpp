// The text before the first % of a file: a leader, or a program.
#pragma once

#include <string_view>

#include "cncsub/code/builder.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

/// Return whether the head of a program may begin with this mark.
bool heads(const Code& code, ProgramHead head);

/// Return whether the open program is a leader: a tape begins at `percent`, and no block before
/// that % could run. The open program is the first of its file and has no head. `text`: the file.
bool is_leader(Builder& to, std::string_view text, const Scanner& percent);

}  // namespace cncsub
