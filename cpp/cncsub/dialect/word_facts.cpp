#include "cncsub/dialect/word_facts.hpp"

#include <algorithm>

#include "cncsub/control/source.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

std::vector<Keyword> keywords_of(const Control& control) {
  const Dialect* const dialect = find_dialect(control.dialect);
  return dialect == nullptr ? std::vector<Keyword>() : dialect->keywords(control);
}

std::optional<CodeFacts> word_facts(const Control& control, std::string_view word) {
  const std::vector<Keyword> all = keywords_of(control);
  const auto found = std::find_if(
      all.begin(), all.end(), [word](const Keyword& of) { return same_letters(of.name, word); });
  if (found == all.end()) return std::nullopt;
  CodeFacts facts = facts_of_row(control, {found->does, found->words, found->causes});
  facts.name = found->name;
  facts.treatment = found->treatment;
  facts.sources = {{std::string(found->rule), std::string(found->source),
                    strongest(found->source, control.base.empty() ? control.name : control.base)}};
  return facts;
}

}  // namespace cncsub
