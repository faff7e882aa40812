// The words of the ISO family that a control has, for those who ask: `cncsub explain WHILE`.
#include <algorithm>
#include <optional>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/iso/operators.hpp"

namespace cncsub {

namespace {

constexpr KeywordRow kRows[] = {
#define KEYWORD(word, does, words, causes) {word, does, words, causes},
#include "cncsub/dialect/iso/keywords.def"
#undef KEYWORD
};

/// The statement without which a control has not got a word.
struct Belonging {
  std::string_view word, statement;
};
constexpr Belonging kBelonging[] = {
    {"THEN", "IF"}, {"ELSE", "IF"}, {"ENDIF", "IF"}, {"END", "DO"}, {"ENDW", "WHILE"}};

/// Return whether the control's forms of IF, loops and names have a word.
bool is_in_forms(const MacroRules& rules, std::string_view word) {
  const IfForm form = rules.if_form.value;
  const bool whiles = rules.loop_form.value == LoopForm::WhileEndw;
  if (word == "ELSE" || word == "ENDIF")
    return form == IfForm::Blocks || form == IfForm::ThenBlocks;
  if (word == "THEN") return form != IfForm::Blocks && form != IfForm::GotoOnly;
  if (word == "DO" || word == "END") return !whiles;
  if (word == "ENDW") return whiles;
  return word != "SETVN" || rules.variable_forms.value.has(VariableForm::Names);
}

std::string_view statement_of(std::string_view word) {
  for (const Belonging& of : kBelonging)
    if (of.word == word) return of.statement;
  return word;
}

/// Return a row as a control has it; nothing where it has not got the word.
std::optional<Keyword> keyword_of(const MacroRules& rules, const KeywordRow& of) {
  if (!is_in_forms(rules, of.word)) return std::nullopt;
  Keyword word = of.keyword();
  if (const auto function = FunctionEntry::read(of.word)) {
    if (!rules.functions.value.has(*function)) return std::nullopt;
    word.rule = "functions";
    word.source = rules.functions.source;
  } else if (const auto entry = StatementEntry::read(statement_of(of.word))) {
    const auto& list = rules.statements.value;
    const auto* const own = std::find_if(list.begin(), list.end(), [&](const auto& one) {
      return StatementEntry::same(one, *entry);
    });
    if (own == list.end()) return std::nullopt;
    if (own->unsure) word.treatment = "not-known";
    word.rule = "statements";
    word.source = rules.statements.source;
  } else {
    if (rules.statements.value.empty()) return std::nullopt;
    word.rule = "logic_order";
    word.source = rules.logic_order.source;
  }
  return word;
}

}  // namespace

std::vector<Keyword> iso_keywords(const Control& control) {
  std::vector<Keyword> all;
  for (const KeywordRow& of : kRows)
    if (auto word = keyword_of(control.macros, of)) all.push_back(std::move(*word));
  return all;
}

}  // namespace cncsub
