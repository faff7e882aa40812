// DEF: the variables of a program, and those of all programs; DEFINE.
#include <algorithm>
#include <iterator>
#include <utility>

#include "cncsub/dialect/sinumerik/declarations.hpp"
#include "cncsub/dialect/sinumerik/keywords.hpp"

namespace cncsub::sinumerik {

namespace {

// Words between DEF and the type that say who may read and write, and when the control reads ahead.
constexpr std::string_view kAccess[] = {"SYNR", "SYNW", "SYNRW", "PHU",   "APR",   "APW", "APRP",
                                        "APWP", "APRB", "APWB",  "INIPO", "INIRE", "DCM"};
// Words before the limits of its values.
constexpr std::string_view kLimits[] = {"LLI", "ULI"};

}  // namespace

/// Read DEF INT COUNT=1, LAST. A variable without a value is 0.
bool DeclarationReader::def(Block& block) {
  Definition of;
  if (!is_global(block, of.global)) return false;
  attributes_of_data();
  if (!type(block, of)) return false;
  attributes_of_data();
  std::vector<Statement> statements;
  do {
    Declared declared;
    declared.definition = of;
    if (!this->declared(block, declared, 2)) return false;
    if (!add(block, declared, statements)) return false;
  } while (line_.take(','));
  if (lacks_end(block)) return false;
  return write(block, statements), true;
}

/// Return whether the program is a file of definitions.
bool DeclarationReader::is_of_definitions() {
  const std::string file = capitals(to_.code().files[to_.program().file].name);
  return file.ends_with(".DEF") || capitals(to_.code().name_of(to_.program())).ends_with("_DEF");
}

/// Read NCK or CHAN, and who may read and write. Files of definitions say them. [840Da p.133]
bool DeclarationReader::is_global(Block& block, bool& global) {
  const std::uint32_t at = line_.offset();
  const std::string first = capitals(line_.name());
  global = first == "NCK" || first == "CHAN";
  if (!global) return true;
  line_.pass(first.size());
  if (!is_of_definitions())
    return refuse(block, Cause::CodeNotComputed,
                  "DEF " + first + " outside of a file of definitions is not computed here", at);
  return true;
}

/// Pass the words that say who may read and write, and when; the limits of the values are told as
/// dropped. They stand before the type or after it. [828Dj p.23]
void DeclarationReader::attributes_of_data() {
  for (;;) {
    const std::uint32_t at = line_.offset();
    const std::string word = capitals(line_.name());
    const bool limits = is_among(kLimits, word);
    if (!limits && !is_among(kAccess, word)) return;
    line_.pass(word.size());
    Value value;
    expression_.number(value);
    expression_.fault.reset();
    if (limits) to_.drop(at, line_.width_from(at));
  }
}

/// Add what gives a variable its first value when its definition runs, or when a run begins.
bool DeclarationReader::add(Block& block, Declared& declared, std::vector<Statement>& statements) {
  const Definition& definition = declared.definition;
  if (definition.global) return first_value(block, declared);
  if (!definition.is_array()) {
    statements.push_back(assignment_of(declared));
    return true;
  }
  Statement all = assignment_of(declared);
  all.count = 0;
  statements.push_back(all);
  statements.insert(statements.end(), declared.elements.begin(), declared.elements.end());
  return true;
}

/// Keep the first value of a variable of all programs, or of its elements.
bool DeclarationReader::first_value(Block& block, const Declared& declared) {
  const auto refused = [&] {
    return refuse(block, Cause::CodeNotComputed,
                  "a computed first value of " + declared.name + " is not computed here",
                  declared.at);
  };
  if (declared.value && declared.value->computed) return refused();
  if (declared.value) to_.names().first_value(declared.definition.local, declared.value->number);
  for (const Statement& of : declared.elements) {
    const Expression value = to_.code().expression(of.expression);
    auto at = value.begin();
    const Instruction only = *at;
    if (only.op != Ins::Constant || !(++at == Expression::end())) return refused();
    const int count = of.count == 0 ? of.number : of.count;
    for (int i = 0; i < count; ++i) to_.names().first_value(of.index + i, only.value);
  }
  return true;
}

/// Read DEFINE SIDES AS 6: a name for a number. Other macros are left. [general knowledge]
bool DeclarationReader::macro(Block& block) {
  const Line before = line_;
  const auto leave = [&] { return line_ = before, false; };
  Definition number;
  number.global = is_of_definitions();
  line_.pass(6);
  const std::string name = capitals(line_.name());
  line_.pass(name.size());
  if (name.size() < 2 || capitals(line_.name()) != "AS") return leave();
  line_.pass(2);
  Value value;
  const bool read = expression_.number(value) && line_.at_end();
  expression_.fault.reset();
  if (!read) {
    number.macro = true;
    if (number.global) definitions_.add(name, number);
    return leave();
  }
  if (definitions_.defines(name, number.global))
    return refuse(block, Cause::VariableGivenTwice, name + " is defined already", value.at), true;
  number.constant = value.number;
  definitions_.add(name, number);
  return write(block, {}), true;
}

}  // namespace cncsub::sinumerik
