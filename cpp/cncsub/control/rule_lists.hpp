// Changes rules that are lists, entry by entry.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control/letters.hpp"
#include "cncsub/control/list.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

/// A message that says what is wrong with an entry, or nothing.
using Wrong = std::optional<std::string>;
using CheckEntry = std::function<Wrong(std::string_view)>;

/// Change a list as it is written. Each entry of the text is added, or replaces the one with the
/// same key (`68.2=neutral`); `-entry` takes one away; a `=` at the head gives the whole list anew.
/// Return what is wrong with an entry, and what is near it, or nothing.
Wrong change_list(std::string_view rule, std::string& list, std::string_view text,
                  const CheckEntry& check);

/// Change a list of a kind in the same way.
template <class Kind>
Wrong change(std::string_view rule, List<Kind>& list, std::string_view text) {
  std::string written = list.text();
  const auto check = [](std::string_view entry) {
    return Kind::read(entry) ? Wrong() : Wrong(Kind::wrong(entry));
  };
  if (auto wrong = change_list(rule, written, text, check)) return wrong;
  List<Kind> changed;
  std::string_view rest = written;
  for (auto entry = take_entry(rest); !entry.empty(); entry = take_entry(rest))
    if (const auto read = Kind::read(entry); read && !changed.put(*read))
      return std::string(rule) + ": at most " + std::to_string(Kind::kMost) + " entries";
  list = changed;
  return std::nullopt;
}

/// Change a set of characters: the text is the whole set.
template <class Kind>
Wrong change(std::string_view rule, Characters<Kind>& set, std::string_view text) {
  if (text.starts_with('=')) text.remove_prefix(1);
  Characters<Kind> changed;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (!changed.put(text[i]))
      return std::string(rule) + ": '" + std::string(first_character(text.substr(i))) +
             "' is not " + std::string(Kind::kWhat);
  set = changed;
  return std::nullopt;
}

/// Return the entries of a list.
std::vector<std::string_view> split_entries(std::string_view text);
/// Return `; near are ...`: the three known words that are most like this one.
std::string near_words(std::string_view word, std::vector<std::string_view> known);
/// Return nothing where the word is a known one, else `foo is no such thing; near are ...`.
Wrong one_of(std::string_view what, std::string_view word,
             const std::vector<std::string_view>& known);

// Return what is wrong with an entry of these rules, and what is near.
Wrong check_code(std::string_view entry);
Wrong check_role(std::string_view entry);

}  // namespace cncsub
