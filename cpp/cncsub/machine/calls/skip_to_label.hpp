// Skips what is not executed: to the next statement of a label, or to the head of a subprogram.
// Some of it is read all the same.
#pragma once

#include <string>

#include "cncsub/machine/state/context.hpp"

namespace cncsub {

constexpr std::uint32_t kOnTheWay = LabelledHead::kReadOnTheWay;

void set_returned(Run& run, double value, bool any);
/// Read the number of an M98 and its count, vacant where it has none.
bool read_98(Run& run, const CallRecord& record, double& p, double& l);
/// Read the values of each M98 that is skipped; nothing skips the end of a tape. A search stops at
/// what cannot be read, too, and an M99 says to it that nothing was returned. [rs274 2.9]
bool read_skipped_blocks(Run& run, Address first, Address to, const std::string& sought);
/// Return the label as the control calls it: that of a subprogram, then that of a branch or a loop.
std::string full_name(const Run& run, std::uint32_t label);
/// Return whether the file of a subprogram may be read: where the main program stands between %,
/// one that begins with a % ends there.
bool may_be_read(Run& run, const OWord& own, std::int32_t file, const std::string& name);
/// Return whether the mode in force uses the words beside M98.
bool uses_words_beside(Run& run, const OWord& own);
/// Skip to the next block of the statement, as from the head of a sub to its end.
bool skip_over(Run& run, const OWord& own, const std::string& sought);
/// Skip to the next statement of the label, and mark it as reached by skipping.
bool skip_to_label(Run& run, const OWord& own);

}  // namespace cncsub
