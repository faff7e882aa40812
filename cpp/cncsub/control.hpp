// A control as data: the rules it follows, its parameters, variables, code calls and alarms, each
// with its source.
#pragma once

#include <charconv>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cncsub/alarm.hpp"
#include "cncsub/number.hpp"
#include "cncsub/source.hpp"

namespace cncsub {

#define CHOICE(type) enum class type : std::uint8_t {
#define OPTION(type, name, slug, example) name,
#define END_CHOICE(type) \
  }                      \
  ;
#include "cncsub/choices.def"
#undef CHOICE
#undef OPTION
#undef END_CHOICE

struct Option {
  std::string_view slug;
  std::string_view example;
};

/// The options of a choice, in the order of its enumerators.
template <class Choice>
const std::vector<Option>& options();

using Letters = std::string;          // addresses, one letter each
using Codes = std::string;            // names or codes, separated by blanks
using Ranges = std::string;           // of variable numbers, from - to, separated by blanks
using VariableOptions = std::string;  // names, separated by blanks

/// The source of an answer that a control's file leaves as the family has it.
inline constexpr const char* kFamilyDefault = "family default";

/// Calls `use` for each code of a list such as "0 1 54.1", as ten times the code.
template <class Use>
void for_each_code(std::string_view codes, Use&& use) {
  const char* at = codes.data();
  const char* end = at + codes.size();
  while (at < end) {
    double value = 0;
    const auto read = std::from_chars(at, end, value);
    if (read.ec != std::errc()) {
      ++at;
      continue;
    }
    if (value >= 0 && value <= 1000) use(to_whole<int>(value * 10 + 0.5));
    at = read.ptr + 1;
  }
}

/// One answer of a control, and where it comes from.
template <class T>
struct Rule {
  T value{};
  std::string source = kFamilyDefault;
  Evidence evidence = Evidence::Inferred;
};

/// A number of its own for one direction of an axis.
struct DirectedNumber {
  std::string direction;  // "X+", or "-" of any axis
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

  /// The number of a direction such as "X+", or null where it has none of its own.
  const DirectedNumber* towards(std::string_view direction) const;
};

struct Control;

/// A setting of the control. `effect` turns its value into rules; null where the engine reads the
/// number itself.
struct Parameter {
  std::string name;  // "6050" or "3404#6"
  double value = 0;
  std::string meaning;
  std::string source;
  Evidence evidence = Evidence::Inferred;
  void (*effect)(Control&, double) = nullptr;
};

/// How many axes have a variable of those that `skip_variables` begins.
inline constexpr int kSkipAxes = 5;

/// What a variable number is. The engine knows the kinds; the control says at which numbers they
/// stand.
enum class VariableKind : std::uint8_t {
  Vacant,           // #0
  Local,            // of the present level
  LevelImage,       // the locals of level (index / count of locals)
  Common,           // shared by all programs, cleared at power-off
  Kept,             // shared by all programs, kept at power-off
  Input,            // signals from the machine, one bit each
  InputWord,        // 16 or 32 of them as one number
  Output,           // signals to the machine
  OutputWord,       //
  UserAlarm,        // #3000
  Milliseconds,     // #3001
  Hours,            // #3002
  Control1,         // #3003, #3004: switches of the automatic operation
  Settings,         // #3005
  Message,          // #3006
  Mirror,           // #3007
  Restart,          // #3008
  Date,             // #3011, YYYYMMDD
  Time,             // #3012, HHMMSS
  PartsCount,       // #3901, #3902
  ModalCode,        // #4001...: the code of group number % 100, of the block before
  ModalWord,        // the modal word of an address, of the block before
  ActiveCode,       // #4201...: the same of the running block
  ActiveWord,       //
  BlockEnd,         // #5001...: end of the block before, work coordinates
  MachinePosition,  // #5021...
  WorkPosition,     // #5041...
  SkipPosition,     // #5061...
  ActiveLength,     // #5081...: length offset in force
  ServoError,       // #5101...
  WorkOffset,       // #5201...: 20 numbers a system, the first of them external
  AxisWorkOffset,   // #2500...: 100 numbers an axis, the first of them external
  ExtraWorkOffset,  // #7001...: G54.1 P1...
  LengthWear,       // tool offsets
  LengthGeometry,
  RadiusWear,
  RadiusGeometry,
  ParameterChoice,  // #100000...: which parameter #100010 reads
  ParameterValue,   // #100010
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
  // Of commons that are other names of commons: what the first one is. Of a kind whose numbers
  // begin before these: how many are missing.
  std::int32_t from = 0;
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

/// How a code calls a program.
enum class CodeCallKind : std::uint8_t { Subprogram, Macro, Modal, ModalEveryBlock };

/// Codes that call programs, by parameters. Either a list (parameters `parameter`, `parameter + 1`
/// ... hold the codes and call `program`, `program + 1` ...), a range (three parameters: first
/// code, first program, how many), or a switch (every code of the address calls `program`).
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
  std::string refused;  // codes inside that range that may not (they alarm: code-may-not-call)
  std::string source;
  Evidence evidence = Evidence::Inferred;
  bool own_codes = true;  // codes that the control has itself may be registered
};

struct Control {
  std::string name;   // "gsk-988ta"
  std::string title;  // "GSK 988TA lathe"

#define RULE(type, name, value, meaning) Rule<type> name{value, kFamilyDefault, Evidence::Inferred};
#include "cncsub/rules.def"
#undef RULE

  std::vector<Parameter> parameters;
  std::vector<VariableRange> variables;  // besides the commons
  std::vector<VariableOption> variable_choices;
  std::vector<CodeCall> code_calls;
  std::map<Cause, AlarmEntry> alarms;
  std::string user_alarm_prefix;  // "MC": #3000=1 is MC3001
  std::int32_t user_alarm_digits = 0;
  std::string user_alarm_number;  // the one number of all user alarms ("P277"), or empty

  const AlarmEntry* alarm(Cause cause) const;
  /// The value of a parameter, 0 where the control has none of this name.
  double parameter(std::string_view parameter_name) const;
  /// Sets a parameter of the control and lets it have its effect on the rules. Returns what is
  /// wrong with the name or the value, or nothing.
  std::optional<std::string> set_parameter(const std::string& parameter_name, double value);
};

/// The answers of a control without their sources.
struct Answers {
#define RULE(type, name, value, meaning) type name{};  // NOLINT(readability-redundant-member-init)
#include "cncsub/rules.def"
#undef RULE
  explicit Answers(const Control& control);
};

/// Sources follow values: every rule that no longer answers as `before` comes from `source`.
void follow(Control& control, const Answers& before, const std::string& source, Evidence evidence);

using RuleValue = std::variant<bool, std::int64_t, std::string>;

/// A rule as a row of a table.
struct RuleView {
  std::string name;
  std::string meaning;
  RuleValue value;
  RuleValue family;  // what the family answers
  std::string source;
  Evidence evidence = Evidence::Inferred;
  std::vector<Option> options;  // of a choice; empty for numbers, yes-or-no and text
};

std::vector<RuleView> rules(const Control& control);
/// Sets a rule by its name; a list is changed entry by entry (rule_lists.hpp). Returns what is
/// wrong with the name or the value, or nothing.
std::optional<std::string> set_rule(Control& control, const std::string& rule_name,
                                    const RuleValue& value,
                                    const std::string& source = "set by the caller",
                                    Evidence evidence = Evidence::Inferred);

/// All controls, by maker and name. Each is a function in a file of its own,
/// cpp/controls/<maker>/<control>.cpp.
const std::vector<Control>& all_controls();

}  // namespace cncsub
