#include "cncsub/dialect/asked.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "cncsub/control/rule_lists.hpp"
#include "cncsub/dialect/dialect.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

/// Return the names of the rules that a control's language asks; empty if it asks all.
std::vector<std::string_view> names_asked(const Control& control) {
  const Dialect* const dialect = find_dialect(control.dialect);
  return split_entries(dialect == nullptr ? std::string_view() : dialect->rules);
}

bool has(const std::vector<std::string_view>& names, std::string_view name) {
  return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

std::vector<RuleView> asked_rules(const Control& control) {
  std::vector<RuleView> all = rules(control);
  const auto names = names_asked(control);
  std::erase_if(all, [&names](const RuleView& rule) { return !has(names, rule.name); });
  return all;
}

std::optional<std::string> never_asked(const Control& control, const std::string& rule_name) {
  if (has(names_asked(control), rule_name)) return std::nullopt;
  const std::vector<RuleView> all = rules(control);
  const bool known = std::any_of(all.begin(), all.end(),
                                 [&](const RuleView& rule) { return rule.name == rule_name; });
  if (!known) return std::nullopt;
  return control.name + " does not use the rule " + rule_name +
         ": nothing in the language of its programs depends on it";
}

namespace {

/// Write the letters of a word as the language does: CR of SINUMERIK is the R of others.
void spell(const Spelling& spelling, CodeWord& word) {
  if (spelling.long_addresses.empty()) return;
  std::string written;
  for (const std::string_view letters : split_entries(word.letters)) {
    const bool comma = letters.size() == 2 && letters[0] == ',';
    const bool alone = comma || (letters.size() == 1 && is_letter(letters[0]));
    const int place = comma ? comma_place(letters[1]) : letters[0] - 'A';
    written += written.empty() ? "" : " ";
    written += alone ? spelling.address_of(place) : std::string(letters);
  }
  word.letters = written;
}

/// Return whether the language asks none of the rules that say more of a word: it has no such word.
bool is_of_others(const std::vector<std::string_view>& asked, const CodeWord& word) {
  return !word.rules.empty() && std::none_of(word.rules.begin(), word.rules.end(),
                                             [&](const auto& rule) { return has(asked, rule); });
}

}  // namespace

void keep_taken(const Control& control, CodeName code, std::vector<CodeWord>& words) {
  const Dialect* const dialect = find_dialect(control.dialect);
  const auto asked = names_asked(control);
  std::erase_if(words, [&](const CodeWord& word) { return is_of_others(asked, word); });
  const WordUses uses(dialect == nullptr ? std::span<const WordUse>() : dialect->word_uses);
  const std::uint32_t taken =
      code.letter == 'G' ? uses.of_g(code.tenfold) : uses.of_m(code.tenfold / 10);
  const auto is_refused = [&](std::string_view letter) {
    const bool is_letter = letter.size() == 1 && letter[0] >= 'A' && letter[0] <= 'Z';
    return is_letter && ((uses.checked() & ~taken) >> (letter[0] - 'A') & 1u) != 0;
  };
  for (CodeWord& word : words) {
    std::string kept;
    for (const std::string_view letter : split_entries(word.letters))
      if (!is_refused(letter)) kept += (kept.empty() ? "" : " ") + std::string(letter);
    word.letters = kept;
  }
  std::erase_if(words, [](const CodeWord& word) { return word.letters.empty(); });
  if (dialect != nullptr)
    for (CodeWord& word : words) spell(*dialect->spelling, word);
}

}  // namespace cncsub
