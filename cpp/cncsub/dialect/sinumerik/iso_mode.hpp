// The ISO mode of the control: between G291 and G290, and in a program that ISOCALL or M98 calls,
// blocks are written as for another maker's control. The control translates each of them into its
// own language and executes that. So does this reader: what runs is one language on one machine.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cncsub/code/code.hpp"
#include "cncsub/dialect/sinumerik/open_block.hpp"

namespace cncsub::sinumerik {

/// Return whether machine data let the control read blocks in ISO mode for milling. [MD840, MD
/// 18800, MD 10880]
bool has_iso_mode(const Control& control);

/// Return the call of the program of this name in ISO mode, which was read from `at` on.
CallRecord iso_call(const OpenBlock& open, std::string_view name, std::uint32_t at);

/// Return the names of the programs that calls in ISO mode mean.
std::vector<std::string> programs_called_in_iso_mode(const Code& code);
/// Return whether a program of this name is one of them: it has the name, or the number.
bool is_called_in_iso_mode(const std::vector<std::string>& called, std::string_view name);

constexpr int kIsoModeOff = 2900, kIsoModeOn = 2910;  // ten times G290 and G291
/// Take G290 or G291.
bool mode_code(OpenBlock& open, Block& block, Words& words, int code, const Value& word);
/// Let the blocks after this one be in the mode that its words choose, if they choose one.
/// `beside_call`: words stand in the block that `words` do not hold.
bool switch_mode(OpenBlock& open, Block& block, const Words& words, bool beside_call);

/// Read the rest of a block in ISO mode, whose skip levels and number are passed.
void read_iso_block(OpenBlock& open, Block& block);

}  // namespace cncsub::sinumerik
