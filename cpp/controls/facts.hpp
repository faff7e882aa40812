// The parts that the files of the controls share. A control is one function in a file of its own,
// cpp/controls/<maker>/<control>.cpp, and the file names both: 30i.cpp of fanuc holds fanuc_30i(),
// the control fanuc-30i. The parts that relatives share stand in the maker's family*.cpp.
#pragma once

#include <initializer_list>
#include <string>
#include <vector>

#include "cncsub/control/control.hpp"

namespace cncsub {

// The build writes the list from the names of the files.
#define CONTROL(function, name) Control function();
#include "controls/list.def"
#undef CONTROL

inline constexpr const char* kKnown = "general knowledge";

/// Return several sources of one fact as one text.
std::string cite(std::initializer_list<const char*> sources);

/// Return the codes of a relative with more codes.
Codes with(Codes codes, const Codes& more);

/// Return the number of a modal word among #4101 to #4120: B, M, N, O, S and T by the alphabet, D,
/// E, F and H as the locals of a macro's arguments. All makers of the family share it. [M7 printed
/// p.331; TDi28 3.28.1.3, F to T; REG]
std::int32_t modal_word_number(char address);

}  // namespace cncsub
