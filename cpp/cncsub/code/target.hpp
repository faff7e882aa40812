// The target of a call: which program, from which block, how often.
#pragma once

#include <optional>
#include <string>

#include "cncsub/code/code.hpp"
#include "cncsub/code/search.hpp"
#include "cncsub/code/spelling.hpp"

namespace cncsub {

/// The values of a call's words, vacant where a variable was.
struct CallOperands {
  double p = 0;
  double l = 0;
  double start = 0;
  double device = 0;
};

/// Read the operands by the control's rules: the form of the call, before anything of the block is
/// executed. Leaves in `target` how often and from which sequence number, and keeps the program's
/// number or name for `find_target`.
std::optional<Fault> decode_call(const Code& code, const CallRecord& call,
                                 const CallOperands& operands, std::int32_t own, Target& target);
/// Return the name of a program as a call of the language writes it.
inline std::string named_program(const Code& code, const std::string& name) {
  const auto& [before, behind] = code.spelling->program_name;
  return std::string(before) + name + std::string(behind);
}
/// Look up the program and its start block, after the block's other words have been executed.
std::optional<Fault> find_target(const Code& code, const CallRecord& call, Target& target,
                                 const SearchFrom& from);
/// Return the record that passes the values of a call to the program that it means from here.
const CallChoice* chosen(const Code& code, const CallRecord& call, const SearchFrom& from);

}  // namespace cncsub
