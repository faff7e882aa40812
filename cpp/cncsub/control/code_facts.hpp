// What a G or an M code, or an address, does on a control: in words, with its source.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control/control.hpp"
#include "cncsub/control/g_codes.hpp"

namespace cncsub {

/// Letters of a block that a code takes, and what they say.
struct CodeWord {
  std::string letters;
  std::string says;
  std::vector<std::string> rules;  // those that say more of it
};

/// Who says something about a code: the rule that holds it, empty where no rule does.
struct CodeSource {
  std::string rule;
  std::string source;
  Evidence evidence = Evidence::Inferred;
};

/// A program that a code calls because it is registered.
struct CodeProgram {
  std::string kind;  // "call", "macro-call"
  std::int32_t program = 0;
  CodeSource by;
};

struct CodeFacts {
  std::string name;       // "G54.1"
  std::string treatment;  // "computed", "passed-over", "not-computed", "not-known", "refused"
  std::string does;       // a sentence without its subject
  std::string usual;      // the name by which rules and causes speak of the code
  std::string group;      // "motion"; empty where it has none
  std::vector<CodeWord> words;
  std::vector<std::string_view> causes;  // of the alarms that it can raise on the control
  std::vector<CodeSource> sources;
  std::vector<CodeProgram> programs;
};

/// What one row of a .def file says of a code or a word.
struct FactRow {
  std::string_view does, words, causes;
};

/// Return what a row says of a code or a word of a control.
CodeFacts facts_of_row(const Control& control, const FactRow& row);

/// Return the treatment of a G code of this meaning.
std::string_view treatment_of(Meaning meaning);

/// Return what is known of a code on one kind of machine of a control.
CodeFacts code_facts(const Control& control, MachineType machine, CodeName code);

/// Return what is known of an address; nothing where it is one of an axis or of arguments alone.
std::optional<CodeFacts> address_facts(const Control& control, char letter);

}  // namespace cncsub
