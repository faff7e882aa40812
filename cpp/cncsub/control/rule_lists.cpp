#include "cncsub/control/rule_lists.hpp"

#include <algorithm>
#include <iterator>

#include "cncsub/control/codes.hpp"
#include "cncsub/control/macro_lists.hpp"
#include "cncsub/control/motion_lists.hpp"
#include "cncsub/control/registered_codes.hpp"
#include "cncsub/control/roles.hpp"
#include "cncsub/control/search_path.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

constexpr std::size_t kLongest = 200;  // an entry that is compared with the known ones

/// Return how many letters have to be changed to make one text of the other.
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
    text += (i == 0 ? "; the nearest are " : ", ") + std::string(known[i]);
  return text;
}

namespace {

/// Return the key of an entry, and what stands after its equals sign.
std::string_view key_of(std::string_view entry) { return entry.substr(0, entry.find('=')); }
std::string_view value_of(std::string_view entry) {
  return entry.substr(std::min(entry.find('='), entry.size() - 1) + 1);
}

std::string no_code(std::string_view text) {
  return std::string(text) + " is not a code: write 54 or 54.1";
}
std::string no_such(std::string_view what, std::string_view word,
                    const std::vector<std::string_view>& known) {
  return std::string(word) + " is not a known " + std::string(what) + near_words(word, known);
}

template <class Row, std::size_t Count>
std::vector<std::string_view> words_of(const Row (&rows)[Count], std::string_view Row::* word) {
  std::vector<std::string_view> words;
  for (const Row& row : rows) words.push_back(row.*word);
  return words;
}

}  // namespace

Wrong one_of(std::string_view what, std::string_view word,
             const std::vector<std::string_view>& known) {
  if (std::find(known.begin(), known.end(), word) != known.end()) return std::nullopt;
  return no_such(what, word, known);
}

Wrong check_code(std::string_view entry) {
  return read_code(entry) ? Wrong() : Wrong(no_code(entry));
}

Wrong check_role(std::string_view entry) {
  if (entry.find('=') == std::string_view::npos || !CodeName::read(key_of(entry)))
    return std::string(entry) + " is not a code with its role: write M97=jump";
  return one_of("role of a code", value_of(entry), role_names());
}

std::string FunctionEntry::wrong(std::string_view text) {
  return no_such("function", text, {std::begin(kFunctionNames), std::end(kFunctionNames)});
}

std::string StatementEntry::wrong(std::string_view text) {
  if (text.ends_with('?')) text.remove_suffix(1);
  return no_such("macro statement", text, {std::begin(kStatementNames), std::end(kStatementNames)});
}

std::string MeaningEntry::text(const GCode& entry) {
  const auto* const word =
      std::find_if(std::begin(kMeaningWords), std::end(kMeaningWords), [&](const MeaningWord& of) {
        return of.group == entry.group && of.meaning == entry.meaning &&
               of.variant == entry.variant;
      });
  return code_text(entry.code) + "=" + std::string(word->word);
}

std::string MeaningEntry::wrong(std::string_view text) {
  if (text.find('=') == std::string_view::npos)
    return std::string(text) + " names no meaning: write 68.2=neutral";
  if (!read_code(key_of(text))) return no_code(key_of(text));
  return no_such("meaning of a G code", value_of(text),
                 words_of(kMeaningWords, &MeaningWord::word));
}

std::string GroupEntry::text(const Entry& entry) {
  const auto* const name =
      std::find_if(std::begin(kGroupNames), std::end(kGroupNames),
                   [&](const GroupName& of) { return of.group == entry.group; });
  return std::string(name->name) + "=" + std::to_string(entry.number);
}

std::string GroupEntry::wrong(std::string_view text) {
  const auto names = words_of(kGroupNames, &GroupName::name);
  if (auto wrong = one_of("group of G codes", key_of(text), names)) return *wrong;
  return std::string(text) + " is not a group with its number: write plane=2";
}

std::string CornerEntry::wrong(std::string_view text) {
  return std::string(text) + " is not an address: write C or ,C";
}

std::string SearchFolder::wrong(std::string_view text) {
  return std::string(text) +
         " is not a folder of the control, in capitals, with the folder on the disk: write "
         "CUS.DIR=cycles, or SPF.DIR";
}

std::string RegisteredEntry::wrong(std::string_view text) {
  return std::string(text) +
         " is not a code with what it calls: write M50=call:9001, G101=macro-call:9010, "
         "T=call:9000";
}

namespace {

/// Return whether two entries are the same: of statements, whether or not they are known.
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

Wrong take_away(Entries& entries, std::string_view entry) {
  const auto found = find_entry(entries, entry);
  if (found == entries.end())
    return "there is no " + std::string(entry) + " to remove" + near_words(entry, entries);
  entries.erase(found);
  return std::nullopt;
}

Wrong put_in(Entries& entries, std::string_view entry, const CheckEntry& check) {
  if (auto wrong = check(entry)) return wrong;
  const auto found = find_entry(entries, entry);
  if (found == entries.end())
    entries.push_back(entry);
  else
    *found = entry;
  return std::nullopt;
}

}  // namespace

Wrong change_list(std::string_view rule, std::string& list, std::string_view text,
                  const CheckEntry& check) {
  const bool anew = text.starts_with('=');
  if (anew) text.remove_prefix(1);
  const std::string before = list;
  Entries entries = split_entries(anew ? std::string_view() : before);
  for (const std::string_view entry : split_entries(text)) {
    const bool away = entry.size() > 1 && entry[0] == '-';
    const auto wrong = away ? take_away(entries, entry.substr(1)) : put_in(entries, entry, check);
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

std::string code_text(int tenfold) {
  if (const std::string_view word = word_of_code(tenfold); !word.empty()) return std::string(word);
  std::string text = std::to_string(tenfold / 10);
  if (tenfold % 10 != 0) text += "." + std::to_string(tenfold % 10);
  return text;
}

std::string Codes::text() const {
  std::string text;
  for_each([&text](int tenfold) { text += (text.empty() ? "" : " ") + code_text(tenfold); });
  return text;
}

}  // namespace cncsub
