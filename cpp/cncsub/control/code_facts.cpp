#include "cncsub/control/code_facts.hpp"

#include <algorithm>
#include <iterator>

#include "cncsub/control/code_calls.hpp"
#include "cncsub/control/rule_lists.hpp"

namespace cncsub {
namespace {

constexpr FactRow kMeanings[] = {
#define MEANING(name, does, words, causes) {does, words, causes},
#include "cncsub/control/meanings.def"
#undef MEANING
};

constexpr FactRow kRoles[] = {
#define ROLE(name, slug, example, words, causes) {example, words, causes},
#include "cncsub/control/roles.def"
#undef ROLE
};

struct Address {
  char letter;
  std::string_view says;
};
constexpr Address kAddresses[] = {
#define ADDRESS(letter, says) {letter, says},
#include "cncsub/control/addresses.def"
#undef ADDRESS
};

/// The causes for which some controls refuse what others run.
constexpr Cause kRefusals[] = {
#define REFUSAL(cause, example) Cause::cause,
#include "cncsub/control/refusals.def"
#undef REFUSAL
};

/// Return the letters that a rule holds; none where it holds a word instead.
std::string letters_of(const std::vector<RuleView>& known, std::string_view name) {
  for (const RuleView& rule : known) {
    const auto* const text = std::get_if<std::string>(&rule.value);
    if (rule.name != name || text == nullptr) continue;
    const bool is_choice = !rule.options.empty();
    return is_choice && text->size() > 1 ? "" : *text;
  }
  return "";
}

/// Return letters with a blank between: "P X U" of "PXU"; a comma stays before its letter.
std::string spaced(std::string_view letters) {
  std::string text;
  for (const char c : letters) {
    if (c == ' ') continue;
    if (!text.empty() && text.back() != ',') text += ' ';
    text += c;
  }
  return text;
}

/// Read one of the words of a row: `letters: what they say [rules that say more]`.
CodeWord read_word(const std::vector<RuleView>& known, std::string_view item) {
  CodeWord word;
  const std::size_t colon = item.find(": ");
  const std::size_t open = std::min(item.find(" ["), item.size());
  word.letters = item.substr(0, colon);
  word.says = item.substr(colon + 2, open - colon - 2);
  if (word.letters.starts_with('{')) {
    const std::string rule = word.letters.substr(1, colon - 2);
    word.letters = spaced(letters_of(known, rule));
    word.rules.push_back(rule);
  }
  if (open < item.size())
    for (const std::string_view rule : split_entries(item.substr(open + 2, item.size() - open - 3)))
      word.rules.emplace_back(rule);
  return word;
}

/// Read the words of a row. A word whose letters a rule leaves out is none.
std::vector<CodeWord> read_words(const Control& control, std::string_view text) {
  std::vector<CodeWord> words;
  const std::vector<RuleView> known = text.empty() ? std::vector<RuleView>() : rules(control);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find("; "), text.size());
    CodeWord word = read_word(known, text.substr(0, end));
    text.remove_prefix(std::min(end + 2, text.size()));
    if (!word.letters.empty()) words.push_back(std::move(word));
  }
  return words;
}

/// Return the text of a rule's value; empty for no, and where there is no such rule.
std::string value_of(const std::vector<RuleView>& known, std::string_view name) {
  for (const RuleView& rule : known)
    if (const auto* const text = std::get_if<std::string>(&rule.value); rule.name == name)
      return text != nullptr ? *text : rule.value == RuleValue(false) ? "" : "set";
  return "";
}

/// Return whether the control raises a cause; of what it may refuse, what it does refuse.
bool raises(const Control& control, Cause cause) {
  const bool may_refuse =
      std::find(std::begin(kRefusals), std::end(kRefusals), cause) != std::end(kRefusals);
  return !may_refuse || control.common.refuses.value.has(cause);
}

/// Return whether none of the conditions holds, `!rule=value!...`, under which nothing is raised.
bool is_raised_under(const std::vector<RuleView>& known, std::string_view conditions) {
  while (!conditions.empty()) {
    const std::size_t end = std::min(conditions.find('!', 1), conditions.size());
    const std::string_view one = conditions.substr(1, end - 1);
    const std::size_t equals = one.find('=');
    if (value_of(known, one.substr(0, equals)) == one.substr(equals + 1)) return false;
    conditions.remove_prefix(end);
  }
  return true;
}

/// Add the causes of a row that the control raises, each once.
void add_causes(const Control& control, std::string_view entries,
                std::vector<std::string_view>& causes) {
  const std::vector<RuleView> known = entries.empty() ? std::vector<RuleView>() : rules(control);
  for (std::string_view entry : split_entries(entries)) {
    const bool always = entry.starts_with('+');
    if (always) entry.remove_prefix(1);
    const std::size_t end = std::min(entry.find('!'), entry.size());
    const std::string_view slug = entry.substr(0, end);
    for (std::size_t i = 0; i < all_causes().size(); ++i)
      if (all_causes()[i].slug == slug && (always || raises(control, static_cast<Cause>(i))) &&
          is_raised_under(known, entry.substr(end)) &&
          std::find(causes.begin(), causes.end(), slug) == causes.end())
        causes.push_back(slug);
  }
}

/// Add the causes for which rules name the code itself.
void add_listed_causes(const Control& control, CodeName code,
                       std::vector<std::string_view>& causes) {
  const bool is_g = code.letter == 'G';
  const auto add = [&](const Rule<Codes>& of_g, const Rule<Codes>* of_m, Cause cause) {
    const Rule<Codes>* const list = is_g ? &of_g : of_m;
    if (list != nullptr && list->value.has(code.tenfold)) causes.push_back(info(cause).slug);
  };
  const MacroRules& macros = control.macros;
  const MotionRules& motion = control.motion;
  add(macros.codes_not_with_macro_call, &macros.m_codes_not_with_macro_call,
      is_g ? Cause::CodeWithMacroCall : Cause::MCodeWithMacroCall);
  add(macros.codes_not_with_modal_call, nullptr, Cause::CodeWithModalCall);
  add(control.calls.codes_not_with_call, nullptr, Cause::IllegalWordWithCall);
  add(control.calls.codes_not_with_return, nullptr, Cause::IllegalWordWithReturn);
  const auto add_refused = [&](const Rule<Codes>& of_g, const Rule<Codes>* of_m, Cause cause) {
    if (raises(control, cause)) add(of_g, of_m, cause);
  };
  add_refused(motion.codes_not_compensated, &motion.m_codes_not_compensated,
              Cause::CompensationCode);
  add_refused(motion.codes_not_turned, nullptr, Cause::TurnedCycle);
  add_refused(motion.pattern_codes, nullptr, Cause::PatternWithoutCycle);
}

/// Add the causes that a code has with all codes of its group.
void add_group_causes(const Control& control, const GCode& code,
                      std::vector<std::string_view>& causes) {
  const auto add = [&](bool is_of_group, Cause cause) {
    if (is_of_group && raises(control, cause)) causes.push_back(info(cause).slug);
  };
  const bool once = code.group == Group::OneShot;
  const bool beyond_arcs = code.group == Group::Motion && code.meaning > Meaning::Ccw;
  add(once && code.meaning != Meaning::ExactStop, Cause::OneShotWithMotion);
  add(once || beyond_arcs || code.group == Group::Radius || code.group == Group::Work ||
          code.group == Group::Units || code.group == Group::Stroke,
      Cause::RotationCode);
}

template <class T>
CodeSource source_of(std::string_view name, const Rule<T>& rule, std::string_view entry) {
  for (const EntrySource& own : rule.entries)
    if (own.entry == entry || own.entry.starts_with(std::string(entry) + "="))
      return {std::string(name), own.source, own.evidence};
  return {std::string(name), rule.source, rule.evidence};
}

std::string group_name(Group group) {
  for (const GroupName& known : kGroupNames)
    if (known.group == group) return std::string(known.name);
  return "";
}

/// Return the name that a code of this meaning has where a control says nothing.
std::string usual_name(MachineType machine, int code, Meaning meaning) {
  const GCodes usual(Control(), machine == MachineType::LatheB ? MachineType::LatheA : machine);
  if (usual.find(code).meaning == meaning) return code_name(code);
  const GCode other = usual.of(meaning);
  return other.code < 0 ? "" : code_name(other.code);
}

void add_registered(const Control& control, char letter, int tenfold, CodeFacts& facts) {
  const auto kind = [](CodeCallKind of) {
    return std::string(kCodeCallNames[static_cast<std::size_t>(of)]);
  };
  for (const auto& entry : control.calls.registered_codes.value)
    if (entry.letter == letter && (entry.code == 0 || entry.code * 10 == tenfold))
      facts.programs.push_back({kind(entry.kind), entry.program,
                                source_of("registered_codes", control.calls.registered_codes,
                                          RegisteredEntry::text(entry))});
  each_code_call(control, [&](const CodeCall& list, std::int32_t number, std::int32_t program) {
    const bool every = list.form == CodeCall::Form::Switch;
    if (list.address != letter || (!every && number == 0)) return;
    if (every || list.tenths_of(std::abs(number)) == tenfold)
      facts.programs.push_back(
          {kind(list.kind), calls_by_name(list) ? -1 : program, {"", list.source, list.evidence}});
  });
  for (const CodeCall& list : control.code_calls)
    if (calls_all(list) && list.address == letter && tenfold >= 10 * list.first_code &&
        tenfold < 10 * (list.last_code + 1))
      facts.programs.push_back({kind(list.kind), -1, {"", list.source, list.evidence}});
}

/// The roles by which a registered code calls.
constexpr Role kRolesOfCalls[] = {Role::Call, Role::MacroCall, Role::ModalCall,
                                  Role::ModalCallEveryBlock};

/// Return the example of a role with another code in place of its own: "`M98 P2` calls O2".
std::string example_with(std::string_view example, CodeName code) {
  const std::size_t end = std::min(example.find_first_of(" `", 1), example.size());
  const auto written = CodeName::read(example.substr(1, end - 1));
  if (!written || *written == code) return std::string(example);
  return "`" + code.text() + std::string(example.substr(end));
}

/// Take over a role: what it does, its words, its alarms, and who says that the code has it.
void add_role(const Control& control, CodeName code, Role role, CodeFacts& facts) {
  const FactRow& row = kRoles[static_cast<std::size_t>(role)];
  facts.does = example_with(row.does, code);
  facts.words = read_words(control, row.words);
  add_causes(control, row.causes, facts.causes);
  facts.treatment = "computed";
  facts.sources = {source_of("roles", control.calls.roles, code.text())};
  const auto usual = family_roles().code_of(role);
  facts.usual = family_roles().of(code) == role || !usual ? facts.name : usual->text();
}

void add_meaning(const Control& control, MachineType machine, int tenfold, CodeFacts& facts) {
  const GCode found = GCodes(control, machine).find(tenfold);
  const FactRow& row = kMeanings[static_cast<std::size_t>(found.meaning)];
  facts.does = row.does;
  const bool names_system = found.meaning == Meaning::WorkExtra && found.variant != 0;
  facts.words = read_words(control, names_system ? "" : row.words);  // no P: G505
  add_causes(control, row.causes, facts.causes);
  if (found.code >= 0) add_group_causes(control, found, facts.causes);
  facts.treatment = treatment_of(found.meaning);
  facts.group = found.code < 0 ? "" : group_name(found.group);
  facts.usual = usual_name(machine, tenfold, found.meaning);
  const Rule<Meanings>& own = control.motion.g_meanings;
  const Rule<Codes>& listed = control.reading.g_codes;
  if (own.value.has({static_cast<std::int16_t>(tenfold), Group::OneShot, Meaning::None}))
    facts.sources.push_back(source_of("g_meanings", own, code_text(tenfold)));
  if (!listed.value.empty())
    facts.sources.push_back(source_of("g_codes", listed, code_text(tenfold)));
}

/// Say of a registered code that it calls, with the words and alarms of such a call.
void add_call(const Control& control, CodeFacts& facts) {
  const CodeProgram& called = facts.programs.front();
  for (std::size_t i = 0; i < std::size(kCodeCallNames); ++i) {
    if (kCodeCallNames[i] != called.kind) continue;
    const FactRow& row = kRoles[static_cast<std::size_t>(kRolesOfCalls[i])];
    const auto like = control.calls.roles.value.code_of(kRolesOfCalls[i]);
    const std::string_view number = std::string_view(facts.name).substr(1);
    const std::string program = called.program >= 0 ? "O" + std::to_string(called.program)
                                                    : name_of_called(facts.name[0], number);
    facts.does = "calls " + program + (like ? " as " + like->text() : "");
    facts.words = read_words(control, i == 0 ? "" : row.words);
    std::erase_if(facts.words, [](const CodeWord& word) { return word.letters == "P"; });
    add_causes(control, row.causes, facts.causes);
  }
  facts.treatment = "computed";
}

}  // namespace

CodeFacts facts_of_row(const Control& control, const FactRow& row) {
  CodeFacts facts;
  facts.does = row.does;
  facts.words = read_words(control, row.words);
  add_causes(control, row.causes, facts.causes);
  return facts;
}

std::string_view treatment_of(Meaning meaning) {
  switch (meaning) {
    case Meaning::None:
      return "refused";
    case Meaning::Unknown:
      return "not-known";
    case Meaning::Uncomputed:
      return "not-computed";
    case Meaning::Neutral:
    case Meaning::Ignored:
      return "passed-over";
    default:
      return "computed";
  }
}

CodeFacts code_facts(const Control& control, MachineType machine, CodeName code) {
  CodeFacts facts;
  const bool is_g = code.letter == 'G';
  facts.name = is_g ? code_name(code.tenfold) : code.text();
  add_registered(control, code.letter, code.tenfold, facts);
  const Role role = control.calls.roles.value.of(code);
  if (role != Role::None) {
    add_role(control, code, role, facts);
  } else if (is_g) {
    add_meaning(control, machine, code.tenfold, facts);
  } else {
    facts.usual = facts.name;
    facts.treatment = "passed-over";
    facts.does = "sent to the machine: nothing is computed from it";
  }
  if (!facts.programs.empty()) add_call(control, facts);
  add_listed_causes(control, code, facts.causes);
  return facts;
}

std::optional<CodeFacts> address_facts(const Control& control, char letter) {
  CodeFacts facts;
  facts.name = facts.usual = std::string(1, letter);
  facts.treatment = "computed";
  for (const Address& known : kAddresses)
    if (known.letter == letter) facts.does = known.says;
  if (facts.does.empty()) return std::nullopt;
  add_registered(control, letter, 0, facts);
  if (!facts.programs.empty()) add_call(control, facts);
  return facts;
}

}  // namespace cncsub
