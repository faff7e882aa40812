// Rules that are lists: what somebody changes in them, entry by entry.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cncsub {

/// Changes the list of a rule. Each entry of the text is added, or replaces the one with the same
/// key (`68.2=neutral`); `-entry` takes one away; a `=` at the head gives the whole list anew.
/// Returns what is wrong with an entry, and what is near it, or nothing.
/// `known` are the words that may be entries where the control says which.
std::optional<std::string> change_list(std::string_view rule, std::string& list,
                                       std::string_view text,
                                       const std::vector<std::string_view>& known = {});

/// The same for a rule that is a set of letters: the text is the whole set.
std::optional<std::string> change_letters(std::string_view rule, std::string& letters,
                                          std::string_view text);

/// The entries of a list.
std::vector<std::string_view> split_entries(std::string_view text);
/// `; near are ...`: the three known words that are most like this one.
std::string near_words(std::string_view word, std::vector<std::string_view> known);

// What the entries of a list may be; each is told where its meaning is.
std::vector<std::string_view> function_names();
std::vector<std::string_view> meaning_words();
std::vector<std::string_view> refusable_causes();
std::vector<std::string_view> group_names();

/// The kinds of macro statements that the rule `statements` may name.
enum class StatementKind : unsigned char {
  Variables,
  Brackets,
  If,
  While,
  Do,
  Dprnt,
  Bprnt,
  Popen,
  Pclos,
  Count
};
std::string_view statement_name(StatementKind kind);

}  // namespace cncsub
