// What a word of a control's language does: a statement, a function, an address.
#pragma once

#include <optional>
#include <string_view>

#include "cncsub/control/code_facts.hpp"
#include "cncsub/dialect/dialect.hpp"

namespace cncsub {

/// Return what is known of a word in the language of a control; nothing where that has no such
/// word.
std::optional<CodeFacts> word_facts(const Control& control, std::string_view word);

/// Return the words of a control's language.
std::vector<Keyword> keywords_of(const Control& control);

}  // namespace cncsub
