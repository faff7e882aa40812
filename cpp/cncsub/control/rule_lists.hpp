// Rules that are lists: what somebody changes in them, entry by entry.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control/letters.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

/// Changes the list of a rule. Each entry of the text is added, or replaces the one with the same
/// key (`68.2=neutral`); `-entry` takes one away; a `=` at the head gives the whole list anew.
/// Returns what is wrong with an entry, and what is near it, or nothing.
/// `known` are the words that may be entries where the rule's kind does not say so.
std::optional<std::string> change_list(std::string_view rule, std::string& list,
                                       std::string_view text,
                                       const std::vector<std::string_view>& known = {});

/// The same for a set of characters: the text is the whole set.
template <class Kind>
std::optional<std::string> change(std::string_view rule, Characters<Kind>& set,
                                  std::string_view text) {
  if (text.starts_with('=')) text.remove_prefix(1);
  Characters<Kind> changed;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (!changed.put(text[i]))
      return std::string(rule) + ": '" + std::string(first_character(text.substr(i))) + "' is no " +
             std::string(Kind::kWhat);
  set = changed;
  return std::nullopt;
}

/// The entries of a list.
std::vector<std::string_view> split_entries(std::string_view text);
/// `; near are ...`: the three known words that are most like this one.
std::string near_words(std::string_view word, std::vector<std::string_view> known);

// What the entries of a list may be; each is told where its meaning is.
std::vector<std::string_view> function_names();
std::vector<std::string_view> meaning_words();
std::vector<std::string_view> group_names();

/// The kinds of macro statements that the rule `statements` may name.
enum class StatementKind : unsigned char {
  Variables,
  Brackets,
  If,
  While,
  Do,
  Goto,
  Dprnt,
  Bprnt,
  Popen,
  Pclos,
  Count
};
std::string_view statement_name(StatementKind kind);

}  // namespace cncsub
