// A control as data: the rules it follows, its parameters, variables, code calls and alarms, each
// with its source.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "cncsub/control/alarm.hpp"
#include "cncsub/control/codes.hpp"
#include "cncsub/control/letters.hpp"
#include "cncsub/control/macro_lists.hpp"
#include "cncsub/control/motion_lists.hpp"
#include "cncsub/control/parameter.hpp"
#include "cncsub/control/registered_codes.hpp"
#include "cncsub/control/roles.hpp"
#include "cncsub/control/search_path.hpp"
#include "cncsub/control/set.hpp"
#include "cncsub/control/source.hpp"
#include "cncsub/text/number.hpp"

namespace cncsub {

#define CHOICE(type) enum class type : std::uint8_t {
#define OPTION(type, name, slug, example) name,
#define END_CHOICE(type) \
  }                      \
  ;
#include "cncsub/control/choices.def"
#undef CHOICE
#undef OPTION
#undef END_CHOICE

struct Option {
  std::string_view slug;
  std::string_view example;
};

/// Return the options of a choice, in the order of its enumerators.
template <class Choice>
const std::vector<Option>& options();

/// The causes for which a control refuses what others run (refusals.def).
using Refusals = Set<Cause, 512>;

/// Return the word for an entry of a set.
template <class E>
std::string_view slug_of(E entry) {
  return options<E>()[static_cast<std::size_t>(entry)].slug;
}
template <>
inline std::string_view slug_of(Cause entry) {
  return info(entry).slug;
}

/// Names of the control's `variable_choices`, separated by blanks. The control's file says which
/// there are.
using VariableOptions = std::string;

/// The source of an answer that a control's file leaves as the family has it.
inline constexpr const char* kFamilyDefault = "family default";

/// The source of one entry of a set, whether it is there or left out.
struct EntrySource {
  std::string entry;
  std::string source;
  Evidence evidence = Evidence::Inferred;

  bool operator==(const EntrySource&) const = default;
};

/// One answer of a control, and where it comes from. Entries of a set may have sources of their
/// own.
template <class T>
struct Rule {
  T value{};
  std::string source = kFamilyDefault;
  Evidence evidence = Evidence::Inferred;
  std::vector<EntrySource> entries = {};  // NOLINT(readability-redundant-member-init)

  void tell(std::string_view entry, const std::string& of, Evidence how_strong) {
    std::erase_if(entries, [&](const EntrySource& reported) { return reported.entry == entry; });
    entries.push_back({std::string(entry), of, how_strong});
  }
};

/// Say that the control has these entries, or lacks them, with a source of their own.
template <class E, std::size_t Most>
void has(Rule<Set<E, Most>>& rule, std::initializer_list<std::type_identity_t<E>> entries,
         const std::string& source, Evidence evidence, bool there = true) {
  for (const E entry : entries) {
    rule.value.put(entry, there);
    rule.tell(slug_of(entry), source, evidence);
  }
}
template <class E, std::size_t Most>
void lacks(Rule<Set<E, Most>>& rule, std::initializer_list<std::type_identity_t<E>> entries,
           const std::string& source, Evidence evidence) {
  has(rule, entries, source, evidence, false);
}

/// Give a code a role on the control, or none (`None`), with a source of its own.
void give_role(Rule<Roles>& rule, CodeName code, Role role, const std::string& source,
               Evidence evidence);
inline void no_role(Rule<Roles>& rule, std::initializer_list<CodeName> codes,
                    const std::string& source, Evidence evidence) {
  for (const CodeName code : codes) give_role(rule, code, Role::None, source, evidence);
}

/// A number of its own for one direction of an axis, or for one kind of two moves that do not meet.
struct DirectedNumber {
  std::string direction;  // "X+", or "-" of any axis; "LA" of a line and the arc after it
  std::string number;
  std::string text;
};

struct AlarmEntry {
  std::string number;
  std::string text;
  std::string source;
  Evidence evidence = Evidence::Inferred;
  bool printed =
      false;  // the text is the list's own words, not ours: a translation, or from memory
  std::vector<DirectedNumber> directed = {};  // NOLINT(readability-redundant-member-init)

  /// Return the number of a direction such as "X+"; null where it has none of its own.
  const DirectedNumber* towards(std::string_view direction) const;
};

/// The number of axes that have a variable from `skip_variables` on.
inline constexpr int kSkipAxes = 5;

/// The kinds of variables. The engine knows the kinds; the control says at which numbers they
/// stand.
enum class VariableKind : std::uint8_t {
  Vacant,            // #0
  Local,             // of the present level
  LevelImage,        // the locals of level (index / count of locals)
  Common,            // shared by all programs, cleared at power-off
  Kept,              // shared by all programs, kept at power-off
  Input,             // signals from the machine, one bit each
  InputWord,         // 16 or 32 of them as one number
  Output,            // signals to the machine
  OutputWord,        //
  UserAlarm,         // #3000
  Milliseconds,      // #3001
  Hours,             // #3002
  Control1,          // #3003, #3004: switches of the automatic operation
  Settings,          // #3005
  Message,           // #3006
  Mirror,            // #3007
  Restart,           // #3008
  Date,              // #3011, YYYYMMDD
  Time,              // #3012, HHMMSS
  PartsCount,        // #3901, #3902
  ModalCode,         // #4001...: the code of group number % 100, of the block before
  ModalWord,         // the modal word of an address, of the block before
  ActiveCode,        // #4201...: the same of the running block
  ActiveWord,        //
  BlockEnd,          // #5001...: end of the block before, work coordinates
  MachinePosition,   // #5021...
  WorkPosition,      // #5041...
  SkipPosition,      // #5061...
  SkipTouched,       // whether the signal of the last skip came
  MeasuredPosition,  // of the last skip, in the frame of its block, without the tool
  MeasuredMachine,   // the same in machine coordinates
  ActiveLength,      // #5081...: length offset in force
  ToolLength,        // that of the tool in the spindle, whether it is in force or not
  ServoError,        // #5101...
  WorkOffset,        // #5201...: 20 numbers a system, the first of them external
  AxisWorkOffset,    // #2500...: 100 numbers an axis, the first of them external
  Shift,             // #5210...: whether the shift of G92 counts, and the shift
  ReferencePoint,    // #5161...: 20 numbers a reference point
  MessageSwitch,     // #5599: 1 until it is written
  WorkSystem,        // #5220: which work system is in force
  ExtraWorkOffset,   // #7001...: G54.1 P1...
  LengthWear,        // tool offsets
  LengthGeometry,
  RadiusWear,
  RadiusGeometry,
  EdgeDatum,        // of an edge of a tool, see edge_datum.hpp
  ToolName,         // by the number of the tool: the text that names it
  ParameterChoice,  // #100000...: which parameter #100010 reads
  ParameterValue,   // #100010
  StoredFrame,      // the frames of the work systems, by FrameNumber
  FrameInForce,     // a FrameInForce
  FrameNumber,      // which of the stored frames is in force
};

enum class Access : std::uint8_t { ReadWrite, ReadOnly, WriteOnly };

struct VariableRange {
  std::int32_t first = 0;
  std::int32_t last = 0;
  VariableKind kind = VariableKind::Common;
  Access access = Access::ReadWrite;
  char address = 0;  // of a modal word
  std::string source;
  Evidence evidence = Evidence::Inferred;
  // Of commons that are other names of commons: the number of the first one. Of a kind whose
  // numbers begin before these: how many are missing.
  std::int32_t from = 0;
  bool metric = false;           // lengths are millimetres, whatever the unit of the program
  bool not_compensated = false;  // no program reads it while a radius is compensated
};

/// Variables that a shop buys. Common ones: `commons` are all that a control with the option has;
/// others: `variables` are what the option adds.
struct VariableOption {
  std::string name;     // "700-sets"
  std::string meaning;  // the maker's name of it, or what it brings
  Ranges commons;
  std::vector<VariableRange> variables;
  std::string source;
  Evidence evidence = Evidence::Inferred;
};

/// Codes that call programs, by parameters. Either a list (parameters `parameter`, `parameter + 1`
/// ... hold the codes and call `program`, `program + 1` ...), a range (three parameters: first
/// code, first program, how many), or a switch (every code of the address calls `program`). A list
/// of no parameters says what may be registered by the rule `registered_codes`.
struct CodeCall {
  enum class Form : std::uint8_t { List, Range, Switch } form = Form::List;
  char address = 'M';
  CodeCallKind kind = CodeCallKind::Subprogram;
  std::int32_t parameter = 0;  // the first parameter; of a range: the first code
  std::int32_t program = 0;   // List, Switch: the first program; Range: the parameter that holds it
  std::int32_t count = 0;     // List: how many parameters; Range: the parameter that says how many
  std::string enable;         // a parameter that must not be 0, or empty
  std::int32_t variable = 0;  // the common variable that takes the code's value, 0 = none
  std::int32_t first_code = 0;  // the codes that may be registered
  std::int32_t last_code = 99999999;
  Codes refused;  // codes inside that range that may not (they alarm: code-may-not-call)
  std::string source;
  Evidence evidence = Evidence::Inferred;
  bool own_codes = true;  // codes that the control has itself may be registered
  bool tenths = false;    // the numbers are tenths of a G code
  // NOLINTNEXTLINE(readability-redundant-member-init)
  std::string every_block = {};  // not 0: a negative number calls for every block, as G66.1 does

  std::int64_t tenths_of(std::int32_t number) const {
    return std::int64_t{number} * (tenths ? 1 : 10);
  }
};

/// A program that the control has itself, such as a standard cycle. A program of the user with the
/// same name comes first.
struct SystemProgram {
  std::string_view name;
  std::string_view text;     // empty: its moves are not computed
  std::string_view needs{};  // what it would need for that; of an inner one: what is not computed

  /// Return whether no program can name it: it stands for what programs of the control do not
  /// compute.
  bool is_inner() const { return name.starts_with('_'); }
};

/// An alarm that programs of the control raise by its number.
struct RaisedAlarm {
  std::int32_t number = 0;
  std::string_view text;
  std::string_view source;
  Evidence evidence = Evidence::Inferred;
};

// The rules of a control, in their groups: control.calls.max_nesting.
#define GROUP(Type, name, meaning) struct Type {
#define END_GROUP(Type, name) \
  }                           \
  ;
#define RULE(group, type, name, value, meaning) Rule<type> name{value};
#include "cncsub/control/rules.def"

/// The groups of the rules.
enum class RuleGroup : std::uint8_t {
#define GROUP(Type, name, meaning) Type,
#define END_GROUP(Type, name)
#define RULE(group, type, name, value, meaning)
#include "cncsub/control/rules.def"
};
std::string_view to_string(RuleGroup group);  // "calls"

/// A group of rules that a control does not have, and who says so.
struct AbsentGroup {
  RuleGroup group{};
  std::string source;
  Evidence evidence = Evidence::Inferred;
};

struct Control {
  std::string name;             // "gsk-988ta"
  std::string base;             // of a control of one's own: the built-in one that it is made from
  std::string title;            // "GSK 988TA lathe"
  std::string dialect = "iso";  // the language of its programs

#define GROUP(Type, name, meaning) Type name;
#define END_GROUP(Type, name)
#define RULE(group, type, name, value, meaning)
#include "cncsub/control/rules.def"

  std::vector<AbsentGroup> absent;  // their rules are not answered, leave_out takes them away

  std::vector<Parameter> parameters;
  std::vector<VariableRange> variables;  // besides the commons
  std::vector<VariableOption> variable_choices;
  std::vector<CodeCall> code_calls;
  std::span<const SystemProgram> system_programs;
  std::span<const RaisedAlarm> raised_alarms;
  std::map<Cause, AlarmEntry> alarms;
  std::string user_alarm_prefix;  // "MC": #3000=1 is MC3001
  std::int32_t user_alarm_digits = 0;
  std::string user_alarm_number;  // the one number of all user alarms ("P277"), or empty

  const AlarmEntry* alarm(Cause cause) const;
  /// Return the entry of a group that the control does not have; null where it has it.
  const AbsentGroup* lacks(RuleGroup group) const;
  /// Return the value of a parameter; 0 where the control has none of this name.
  double parameter(std::string_view parameter_name) const;
  /// Return whether anything is computed from a parameter but what a program reads of it.
  bool uses(const Parameter& parameter) const;
  /// Set a parameter of the control and let it have its effect on the rules. Return what is wrong
  /// with the name or the value, or nothing.
  std::optional<std::string> set_parameter(const std::string& parameter_name, double value);
};

/// Leave out a group of rules that the control does not have: nobody is told of one or may set it,
/// and the engine meets nothing that it would be asked about.
void leave_out(Control& control, RuleGroup group, const std::string& source, Evidence evidence);

/// The answers of a control without their sources.
struct Answers {
// NOLINTNEXTLINE(readability-redundant-member-init)
#define RULE(group, type, name, value, meaning) type name{};
#include "cncsub/control/rules.def"
  explicit Answers(const Control& control);
};

/// Set the source of every rule that no longer answers as `before`.
void follow(Control& control, const Answers& before, const std::string& source, Evidence evidence);

using RuleValue = std::variant<bool, std::int64_t, std::string>;

/// A rule as a row of a table.
struct RuleView {
  std::string name;
  std::string group;  // "calls"
  std::string meaning;
  RuleValue value;
  RuleValue family;  // what the family answers
  std::string source;
  Evidence evidence = Evidence::Inferred;
  std::vector<Option> options;       // of a choice; empty for numbers, yes-or-no and text
  std::vector<Option> members;       // what may be in a set
  std::vector<EntrySource> entries;  // the sources that entries of a set have of their own
};

std::vector<RuleView> rules(const Control& control);
/// Set a rule by its name; a list is changed entry by entry (rule_lists.hpp). Return what is wrong
/// with the name or the value, or nothing.
std::optional<std::string> set_rule(Control& control, const std::string& rule_name,
                                    const RuleValue& value,
                                    const std::string& source = "set by the caller",
                                    Evidence evidence = Evidence::Inferred);
/// Give entries of a set sources of their own.
void tell_entries(Control& control, const std::string& rule_name,
                  const std::vector<EntrySource>& entries);

/// Bring a control that its file has described into order: parameters by their numbers, no fact
/// stronger than its sources are on this control.
void complete(Control& control);

/// Return all controls, by maker and name. Each is a function in a file of its own,
/// cpp/controls/<maker>/<control>.cpp.
const std::vector<Control>& all_controls();

}  // namespace cncsub
