// The text of a structured program: the first line %@MACRO, statements that end with a semicolon,
// comments // and (* *), and words of several letters.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "cncsub/text/scan.hpp"

namespace cncsub {

/// Return whether a line says that a structured program follows.
bool heads_structured(std::string_view line);

/// Return whether a line is the head of a program: O and a number, and nothing else but a comment.
bool is_program_head(std::string_view line);

/// Make a part of a text what the readers of blocks read, character by character: comments and the
/// ends of lines become blanks, round brackets square ones, := an equals sign and @ a #.
void translate_structured(std::string& text, std::size_t from, std::size_t to);

/// Read the letters, digits and _ that stand here, as capitals.
std::string name_of_word(Scanner& s);

/// Return whether a function is one that the control has and cncsub does not compute.
bool is_not_computed(std::string_view name);

}  // namespace cncsub
