#include "cncsub/control/rule_lists.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "cncsub/control/codes.hpp"
#include "cncsub/control/roles.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

constexpr std::size_t kLongest = 200;  // an entry that is compared with the known ones

/// How many letters have to be changed to make one text of the other.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j < row.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t corner = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = corner + (a[i - 1] == b[j - 1] ? 0 : 1);
      corner = row[j];
      row[j] = std::min({changed, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::vector<std::string_view> split_entries(std::string_view text) {
  std::vector<std::string_view> entries;
  while (!text.empty()) {
    const auto blank = std::min(text.find(' '), text.size());
    if (blank > 0) entries.push_back(text.substr(0, blank));
    text.remove_prefix(std::min(blank + 1, text.size()));
  }
  return entries;
}

std::string near_words(std::string_view word, std::vector<std::string_view> known) {
  word = word.substr(0, kLongest);
  std::stable_sort(known.begin(), known.end(), [&](std::string_view a, std::string_view b) {
    return distance(word, a) < distance(word, b);
  });
  std::string text;
  for (std::size_t i = 0; i < known.size() && i < 3; ++i)
    text += (i == 0 ? "; near are " : ", ") + std::string(known[i]);
  return text;
}

namespace {

std::string_view key_of(std::string_view entry) { return entry.substr(0, entry.find('=')); }

std::optional<std::string> one_of(std::string_view what, std::string_view word,
                                  const std::vector<std::string_view>& known) {
  if (std::find(known.begin(), known.end(), word) != known.end()) return std::nullopt;
  return std::string(word) + " is no " + std::string(what) + near_words(word, known);
}

/// A code such as 54 or 54.1.
std::optional<std::string> code(std::string_view text) {
  if (read_code(text)) return std::nullopt;
  return std::string(text) + " is no code: write 54 or 54.1";
}

std::optional<std::string> address(std::string_view text) {
  const std::string_view letter = text.substr(text.size() == 2 && text[0] == ',' ? 1 : 0);
  if (letter.size() == 1 && letter[0] >= 'A' && letter[0] <= 'Z') return std::nullopt;
  return std::string(text) + " is no address: write C or ,C";
}

std::optional<std::string> group(std::string_view entry) {
  const auto equals = entry.find('=');
  if (auto wrong = one_of("group of G codes", key_of(entry), group_names())) return wrong;
  const std::string_view number = entry.substr(std::min(equals, entry.size() - 1) + 1);
  int value = 0;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), value);
  const bool whole = equals != std::string_view::npos && read.ec == std::errc() &&
                     read.ptr == number.data() + number.size() && value >= 0 && value < 100;
  if (whole) return std::nullopt;
  return std::string(entry) + " is no group with its number: write plane=2";
}

std::optional<std::string> meaning(std::string_view entry) {
  const auto equals = entry.find('=');
  if (equals == std::string_view::npos)
    return std::string(entry) + " has no meaning: write 68.2=neutral";
  if (auto wrong = code(key_of(entry))) return wrong;
  return one_of("meaning of a G code", entry.substr(equals + 1), meaning_words());
}

std::optional<std::string> role(std::string_view entry) {
  const auto equals = entry.find('=');
  if (equals == std::string_view::npos || !CodeName::read(key_of(entry)))
    return std::string(entry) + " is no code with its role: write M97=jump";
  return one_of("role of a code", entry.substr(equals + 1), role_names());
}

std::optional<std::string> statement(std::string_view entry) {
  if (entry.ends_with('?')) entry.remove_suffix(1);
  std::vector<std::string_view> known;
  known.reserve(static_cast<std::size_t>(StatementKind::Count));
  for (int i = 0; i < static_cast<int>(StatementKind::Count); ++i)
    known.push_back(statement_name(static_cast<StatementKind>(i)));
  return one_of("macro statement", entry, known);
}

std::optional<std::string> function(std::string_view entry) {
  return one_of("function", entry, function_names());
}

using Check = std::optional<std::string> (*)(std::string_view);

Check check_of(std::string_view rule) {
  if (rule == "g_meanings") return meaning;
  if (rule == "modal_groups") return group;
  if (rule == "functions") return function;
  if (rule == "statements") return statement;
  if (rule == "roles") return role;
  if (rule == "chamfer_words" || rule == "round_words" || rule == "angle_words") return address;
  return code;
}

/// What an entry is where the words that it may be are given.
std::string_view entry_name(std::string_view rule) {
  if (rule == "variable_options") return "option that brings them";
  if (rule == "refuses") return "cause that may be refused";
  return "entry of the rule";
}

/// The same entry: of statements, whether or not it is known.
bool same_entry(std::string_view a, std::string_view b) {
  const auto bare = [](std::string_view text) {
    return text.ends_with('?') ? text.substr(0, text.size() - 1) : text;
  };
  return key_of(bare(a)) == key_of(bare(b));
}

using Entries = std::vector<std::string_view>;

Entries::iterator find_entry(Entries& entries, std::string_view entry) {
  return std::find_if(entries.begin(), entries.end(),
                      [&](std::string_view other) { return same_entry(other, entry); });
}

std::optional<std::string> take_away(Entries& entries, std::string_view entry) {
  const auto found = find_entry(entries, entry);
  if (found == entries.end())
    return "there is no " + std::string(entry) + " to take away" + near_words(entry, entries);
  entries.erase(found);
  return std::nullopt;
}

std::optional<std::string> put_in(std::string_view rule, Entries& entries, std::string_view entry,
                                  const Entries& known) {
  const bool by_kind = known.empty() && rule != "variable_options";
  auto wrong = by_kind ? check_of(rule)(entry) : one_of(entry_name(rule), entry, known);
  if (wrong) return wrong;
  const auto found = find_entry(entries, entry);
  if (found == entries.end())
    entries.push_back(entry);
  else
    *found = entry;
  return std::nullopt;
}

}  // namespace

std::string_view statement_name(StatementKind kind) {
  static constexpr std::array<std::string_view, static_cast<std::size_t>(StatementKind::Count)>
      kNames = {"#", "[", "IF", "WHILE", "DO", "GOTO", "DPRNT", "BPRNT", "POPEN", "PCLOS"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::optional<std::string> change_list(std::string_view rule, std::string& list,
                                       std::string_view text,
                                       const std::vector<std::string_view>& known) {
  const bool anew = text.starts_with('=');
  if (anew) text.remove_prefix(1);
  const std::string before = list;
  Entries entries = split_entries(anew ? std::string_view() : before);
  for (const std::string_view entry : split_entries(text)) {
    const bool away = entry.size() > 1 && entry[0] == '-';
    const auto wrong =
        away ? take_away(entries, entry.substr(1)) : put_in(rule, entries, entry, known);
    if (wrong) return std::string(rule) + ": " + *wrong;
  }
  std::string changed;
  for (const std::string_view entry : entries) {
    if (!changed.empty()) changed += ' ';
    changed += entry;
  }
  list = changed;
  return std::nullopt;
}

}  // namespace cncsub
