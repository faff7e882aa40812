// The compiler of a library: the control's dialect reads the files, the programs are registered,
// and the calls that are the same each time are decided.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/code/expression_list.hpp"
#include "cncsub/dialect/sharing.hpp"

namespace cncsub {

/// Read the files into one library of compiled programs. Never fails: what the control would refuse
/// becomes a fault. Without an external device, M198 finds the programs that M98 finds, in memory.
/// `interrupted` is asked fifty times a second; once it gives true, the result is null. The library
/// does not depend on how the reading is shared among threads. `general_only` turns every fast path
/// off, of the reader and of what runs the library: a program does the same, but takes longer.
std::shared_ptr<const Code> compile(const std::shared_ptr<const Control>& control,
                                    std::vector<SourceFile> files, bool external_device,
                                    const std::function<bool()>& interrupted = {},
                                    const Sharing& sharing = {}, bool general_only = false);

/// Return the same library with one more program at its end: the text typed in MDI. `made`: texts
/// that a run of the library has made, which keep their numbers.
std::shared_ptr<const Code> compile_mdi(const Code& code, const std::string& text,
                                        const std::function<bool()>& interrupted = {},
                                        const Texts* made = nullptr);

/// Compile expressions of the library's language, conditions or values, each with the program whose
/// variables it may name. One that is none has a fault.
ExpressionList compile_expressions(const Code& code,
                                   const std::vector<std::pair<std::string, std::int32_t>>& texts);

}  // namespace cncsub
