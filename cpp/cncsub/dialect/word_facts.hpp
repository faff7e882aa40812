// What a word of a control's language does: a statement, a function, an address.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control/code_facts.hpp"
#include "cncsub/dialect/dialect.hpp"

namespace cncsub {

/// Return what is known of a word in the language of a control; nothing where that has no such
/// word.
std::optional<CodeFacts> word_facts(const Control& control, std::string_view word);

/// Return what is known of what a program writes: a G or an M code, a word of the language, an
/// address with a number or without, or a variable by its number (#3006, R10). Nothing where the
/// name is none of these.
std::optional<CodeFacts> named_facts(const Control& control, MachineType machine,
                                     std::string_view name);

/// Return what a block is written with, in its order, each name once: codes, addresses, words,
/// variables, and the names that programs give.
std::vector<std::string> names_in(const Control& control, std::string_view block);

/// Return the words of a control's language.
std::vector<Keyword> keywords_of(const Control& control);

}  // namespace cncsub
