// Files into a library: read by the dialect of the control, programs registered, calls decided that
// are the same each time.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/dialect/sharing.hpp"

namespace cncsub {

/// Reads the files into one library of compiled programs. Never fails: what the control would
/// refuse becomes a fault. Without an external device the memory stands in for it: M198 then finds
/// the programs that M98 finds. `interrupted` is asked fifty times a second whether to give up; the
/// result is null then. However it is shared out to threads, the library is the same.
/// `general_only`: every short way is off, of the reader and of what runs the library. What a
/// program does is the same; it takes longer.
std::shared_ptr<const Code> compile(std::shared_ptr<const Control> control,
                                    std::vector<SourceFile> files, bool external_device,
                                    const std::function<bool()>& interrupted = {},
                                    const Sharing& sharing = {}, bool general_only = false);

/// The same library with one more program behind the others, the text typed in MDI.
std::shared_ptr<const Code> compile_mdi(const Code& code, const std::string& text,
                                        const std::function<bool()>& interrupted = {});

}  // namespace cncsub
