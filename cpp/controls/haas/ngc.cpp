// Haas mills with the Next Generation Control.
// The keys of the sources stand in sources.def. What no source says is as in the family.
#include "controls/facts.hpp"
#include "controls/settings.hpp"

namespace cncsub {
namespace {

using enum Evidence;

constexpr const char* kHaas = "general knowledge of the Haas mill";
constexpr const char* kUnsure = "general knowledge of the Haas mill, unsure";
constexpr const char* kPolicy = "policy, nobody says";
constexpr const char* kAlarms = "general knowledge of the Haas alarm list";

void reading(Control& c) {
  c.reading.max_program_number = {99999, "H96 p.217: O00012, five digits", Secondary};
  c.reading.max_sequence_number = {99999, kHaas, Inferred};
  c.reading.block_skip = {BlockSkip::Anywhere, kHaas, Inferred};
  c.reading.extra_m_codes = {ExtraMCodes::Alarm,
                             "general knowledge of the Haas mill: one M code a block", Inferred};
  c.reading.whole_numbers = {WholeNumbers::Increments,
                             "HEL: without a point the last digit counts thousandths", Secondary};
  c.reading.missing_end = {MissingEnd::Alarm, "general knowledge of the Haas alarm list: 312",
                           Inferred};
  c.reading.g_codes = {
      "0 1 2 3 4 9 10 12 13 17 18 19 20 21 28 29 31 35 36 37 40 41 42 43 44 47 49 50 51 52 53 54 "
      "55 56 57 58 59 60 61 64 65 68 69 70 71 72 73 74 76 77 80 81 82 83 84 85 86 87 88 89 90 91 "
      "92 93 94 95 98 99 100 101 102 103 107 110 111 112 113 114 115 116 117 118 119 120 121 122 "
      "123 124 125 126 127 128 129 136 141 143 150 153 154 155 161 162 163 164 165 166 169 174 184 "
      "187 188 234 253 254 255 268 269",
      kHaas, Inferred};
}

void calls_and_returns(Control& c) {
  c.calls.program_word = {ProgramWord::Number, "H96 p.217: P is the number of the program",
                          Secondary};
  c.calls.max_program_digits = {5, "H96 p.217: O00012, five digits", Secondary};
  c.calls.max_repeats = {99, kHaas, Inferred};
  c.calls.zero_repeats = {ZeroRepeats::Once, kPolicy, Inferred};
  c.calls.max_nesting = {9, kHaas, Inferred};
  c.calls.max_macro_nesting = {9, kHaas, Inferred};
  c.calls.return_with_p = {ReturnWithP::OwnProgram, "HDIY, M99 P: it does not return to the caller",
                           Manual};
  c.calls.main_return = {MainReturn::Restarts, kHaas, Inferred};
  give_role(c.calls.roles, "M97", Role::LocalCall, "H96 p.217, M97", Secondary);
  give_role(c.calls.roles, "M96", Role::JumpUnlessInput, "H96 p.217, M96; p.91", Secondary);
  c.calls.conditional_return = {true, "HDIY, N50 [#10000 LT 10] M99 P10", Manual};
}

void macros(Control& c) {
  c.macros.commons = {"10000-10999", "ZAP, Haas system variables", Secondary};
  c.macros.statements = {"# [ IF WHILE DO GOTO DPRNT BPRNT? POPEN PCLOS", kHaas, Inferred};
  c.macros.if_form = {
      IfForm::Words,
      "VBH, 9000.nc: IF[#10001 EQ 0] M98 P9004; H96 p.159: IF [ #9 EQ #0 ] #9= #4109", Secondary};
  has(c.macros.conditions, {Condition::Values}, "HDIY: 0 is false, what is not 0 is true", Manual);
  has(c.macros.conditions, {Condition::Joined}, "HDIY: Boolean operators in conditions", Manual);
  c.macros.short_functions = {false, kPolicy, Inferred};
  c.macros.functions = {"SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX MOD", kHaas, Inferred};
  c.macros.vacant_address = {VacantAddress::Ignored, "HDIY, address substitution: no Z movement",
                             Manual};
  c.macros.vacant_comparison = {VacantComparison::Distinguished, "H96 p.118: IF [#2 NE #0]",
                                Secondary};
  lacks(c.common.reset_clears, {Cleared::Commons}, "ZAP, Haas system variables: saved at power-off",
        Secondary);
  no_role(c.calls.roles, {"G66", "G67"}, kHaas, Inferred);
  c.macros.max_macro_digits = {5, "H96 p.217: O00012, five digits", Secondary};
  c.macros.words_before_macro_call = {WordsBeforeMacroCall::Alarm, "general knowledge: 528",
                                      Inferred};
  c.macros.user_alarm_offset = {1000, kHaas, Inferred};
  c.macros.user_alarm_last = {999, kHaas, Inferred};
}

void motion(Control& c) {
  leave_out(c, RuleGroup::TurningRules, "H96 p", Manual);  // of mills
  c.motion.g_meanings = {
      "47=not-computed 87=not-computed 88=not-computed 103=look-ahead-limit "
      "110=extra-system-1 111=extra-system-2 112=extra-system-3 113=extra-system-4 "
      "114=extra-system-5 115=extra-system-6 116=extra-system-7 117=extra-system-8 "
      "118=extra-system-9 119=extra-system-10 120=extra-system-11 121=extra-system-12 "
      "122=extra-system-13 123=extra-system-14 124=extra-system-15 125=extra-system-16 "
      "126=extra-system-17 127=extra-system-18 128=extra-system-19 129=extra-system-20 "
      "150=not-computed 154=extra-system 187=neutral",
      "H96 p.113: G110 to G129; the others general knowledge of the Haas mill", Inferred};
  c.motion.max_extra_systems = {99, "general knowledge of the Haas mill: G154 P1 to P99", Inferred};
  c.motion.max_offset_number = {200, "HEL, D: 0 to 200", Secondary};
  c.motion.dwell_words = {"P", kHaas, Inferred};
  c.motion.dwell_point = {DwellPoint::CyclesToo,
                          "H96 p.91: G04 P1. waits a second; in cycles every post processor of the "
                          "Haas writes it so",
                          Secondary};
  c.motion.cycle_repeats = {"L", kHaas, Inferred};
  c.motion.computed_lengths = {ComputedLengths::Rounded,
                               "HVF p.374: G0 X[#1+#1] with 1.00333 goes to 2.0067", Secondary};
  c.motion.scale_unit = {ScaleUnit::AsWritten,
                         "HML p.136: G51 P2. and G51 P2; H96 p.159: G51 P [ #5 * 1000 ]",
                         Secondary};
}

using Kind = VariableKind;
constexpr Access kReadWrite = Access::ReadWrite;
constexpr Access kReadOnly = Access::ReadOnly;
constexpr Access kWriteOnly = Access::WriteOnly;
constexpr const char* kZap = "ZAP, Haas system variables";

/// Add the inputs, outputs, tools and counters.
void system_variables(Control& c) {
  const std::string zap = kZap;
  c.variables.insert(
      c.variables.end(),
      {
          {1000, 1063, Kind::Input, kReadOnly, 0, kHaas, Inferred},
          // Loads, analog inputs, flutes, vibrations and timers: the machine supplies their values.
          {1064, 1068, Kind::InputWord, kReadOnly, 0, zap, Secondary},
          {1080, 1087, Kind::InputWord, kReadOnly, 0, zap, Secondary},
          {1090, 1098, Kind::InputWord, kReadOnly, 0, zap, Secondary},
          {1100, 1139, Kind::Output, kReadWrite, 0, kHaas, Inferred},
          {1264, 1268, Kind::InputWord, kReadOnly, 0, zap, Secondary},
          {1601, 2000, Kind::InputWord, kReadOnly, 0, zap, Secondary},
          {2001, 2200, Kind::LengthGeometry, kReadWrite, 0, zap, Secondary},
          {2201, 2400, Kind::LengthWear, kReadWrite, 0, zap, Secondary},
          {2401, 2600, Kind::RadiusGeometry, kReadWrite, 0, zap, Secondary},
          {2601, 2800, Kind::RadiusWear, kReadWrite, 0, zap, Secondary},
          {3000, 3000, Kind::UserAlarm, kWriteOnly, 0, zap, Secondary},
          {3001, 3001, Kind::Milliseconds, kReadWrite, 0, zap, Secondary},
          {3002, 3002, Kind::Hours, kReadWrite, 0, zap, Secondary},
          {3003, 3004, Kind::Control1, kReadWrite, 0, zap, Secondary},
          {3006, 3006, Kind::Message, kWriteOnly, 0, zap, Secondary},
          {3011, 3011, Kind::Date, kReadOnly, 0, zap, Secondary},
          {3012, 3012, Kind::Time, kReadOnly, 0, zap, Secondary},
          {3020, 3025, Kind::InputWord, kReadOnly, 0, zap, Secondary},
          {3026, 3026, Kind::ActiveWord, kReadOnly, 'T', kHaas, Inferred},
          {3027, 3028, Kind::InputWord, kReadOnly, 0, zap, Secondary},
          {3901, 3902, Kind::PartsCount, kReadWrite, 0, kHaas, Inferred},
      });
}

/// Add the modal codes, positions and work offsets.
void system_positions(Control& c) {
  const std::string manual = "H96 p.113, work offsets";
  c.variables.insert(
      c.variables.end(),
      {
          {4001, 4021, Kind::ModalCode, kReadOnly, 0, kHaas, Inferred},
          {5001, 5006, Kind::BlockEnd, kReadOnly, 0, kHaas, Inferred},
          {5021, 5026, Kind::MachinePosition, kReadOnly, 0, kHaas, Inferred},
          {5041, 5046, Kind::WorkPosition, kReadOnly, 0, kHaas, Inferred},
          {5061, 5066, Kind::SkipPosition, kReadOnly, 0, kHaas, Inferred},
          {5081, 5086, Kind::ActiveLength, kReadOnly, 0, kHaas, Inferred},
          // #5201 to #5206, the offset of G52 and G92, is no external offset and is not held here.
          {5221, 5326, Kind::WorkOffset, kReadWrite, 0, manual, Secondary, 20},
          {7001, 7386, Kind::ExtraWorkOffset, kReadWrite, 0, manual, Secondary},
          {11000, 11063, Kind::Input, kReadOnly, 0, kZap, Secondary},
          {14001, 15966, Kind::ExtraWorkOffset, kReadWrite, 0, kHaas, Inferred},
      });
}

void variables(Control& c) {
  const std::string zap = kZap;
  c.variables = {
      {0, 0, Kind::Vacant, kReadOnly, 0, "H96 p.113", Secondary},
      {1, 33, Kind::Local, kReadWrite, 0, "HAA", Secondary},
      {700, 749, Kind::Kept, kReadWrite, 0, zap, Secondary},  // of the control's own programs
  };
  system_variables(c);
  system_positions(c);
  // The numbers of older Haas controls are other names of these.
  for (const auto& [first, last] : {std::pair{100, 199}, {500, 699}, {800, 999}})
    c.variables.push_back({first, last, Kind::Kept, kReadWrite, 0, zap, Secondary, 10000 + first});
  for (const char address : {'B', 'D', 'F', 'H', 'M', 'N', 'O', 'S', 'T'}) {
    const std::int32_t number = modal_word_number(address);
    c.variables.push_back({number, number, Kind::ModalWord, kReadOnly, address, kUnsure, Inferred});
  }
}

/// Add settings by their numbers, and the aliases of codes by the programs that they call.
void settings(Control& c) {
  const auto add = [&c](const char* name, double value, const char* meaning,
                        std::vector<Setting> sets, const char* source = kHaas,
                        Evidence evidence = Inferred) {
    c.parameters.push_back({name, value, meaning, source, evidence, std::move(sets)});
    apply(c, c.parameters.back(), "setting " + std::string(name) + " as delivered: " + kHaas,
          Inferred);
  };
  add("9", 0, "the unit before G20 or G21: 0 = mm, 1 = inch", {entry(rule::power_on, PowerOn::G20)},
      "H96 p.152, G20 and G21", Secondary);
  add("33", 0, "what M02 and M30 do to G52: 0 = FANUC, they end it, 1 = HAAS, it stays",
      {entry_while_zero(rule::reset_clears, Cleared::LocalSystem)});
  add("40", 0, "an offset of D is 0 = a radius, 1 = a diameter",
      {bit(rule::radius_offset_diameter)}, "HEL, D: setting 40; its values are general knowledge",
      Inferred);
  add("43", 0, "the start-up of cutter compensation: 0 = type A, 1 = type B",
      {bit(rule::start_up, StartUp::TypeA, StartUp::TypeB)});
  add("52", 0, "how far above R a peck of G83 draws back, mm", {micrometres(rule::peck_above)},
      "HVF p.192, setting 52", Secondary);
  add("56", 0, "M30 brings back the G codes of power-on: 0 = no, 1 = yes",
      {entry(rule::reset_clears, Cleared::Codes)});
  add("85", 0.05, "how far a corner may be rounded, mm; no path is drawn otherwise for it", {});
  add("162", 0, "a number without a point counts 0 = least increments, 1 = mm, inches or degrees",
      {bit(rule::whole_numbers, WholeNumbers::Increments, WholeNumbers::Millimetres)});
  using Form = CodeCall::Form;
  c.code_calls = {
      {Form::List, 'M', CodeCallKind::Subprogram, 9000, 9000, 10, "", 0, 1, 999, "", kHaas,
       Inferred},
      {Form::List, 'G', CodeCallKind::Macro, 9010, 9010, 10, "", 0, 1, 999, "", kHaas, Inferred}};
  for (int program = 9000; program < 9020; ++program)
    c.parameters.push_back({std::to_string(program), 0,
                            std::string("the ") + (program < 9010 ? "M" : "G") +
                                " code that is an alias of O" + std::to_string(program) +
                                ", 0 = none",
                            kHaas, Inferred});
}

/// Set the alarms from memory, since no printed list was found. A cause that is not listed shows no
/// number.
void alarms(Control& c) {
  struct Row {
    const char* number;
    const char* text;
    std::vector<Cause> causes;
  };
  using enum Cause;
  const Row rows[] = {
      {"307", "SUBROUTINE NESTING TOO DEEP", {NestingTooDeep}},
      {"310", "INVALID G CODE", {GCodeNotAvailable}},
      {"312", "PROGRAM END", {EndOfRecord}},
      {"313", "NO P CODE IN M97, M98, OR G65", {ProgramNumberMissing}},
      {"314", "SUBPROGRAM OR MACRO NOT IN MEMORY", {ProgramNotFound}},
      {"315", "INVALID P CODE IN M97, M98 OR M99", {StartNotFound, ReturnTargetNotFound}},
      {"503", "ILLEGAL MACRO VARIABLE REFERENCE", {IllegalVariable}},
      {"504", "UNBAL. PAREN. IN EXPRESSION", {BracketNotClosed, BracketNotOpened}},
      {"508", "DIVISION BY ZERO", {DivisionByZero}},
      {"516", "ILLEGAL CONDITIONAL OR NO THEN", {IfFormat}},
      {"524", "END FOUND WITH NO MATCHING DO", {MissingDo}},
      {"528", "PARAMETER PRECEDES G65", {MacroCallNotFirst}},
      {"529", "ILLEGAL G65 PARAMETER", {IllegalArgument}},
      {"530", "TOO MANY I, J, OR K'S IN G65", {TooManyArgumentSets}},
      {"531", "MACRO NESTING TOO DEEP", {MacroNestingTooDeep}},
      {"539", "ILLEGAL GOTO", {JumpTargetNotFound}},
      {"538", "MATCHING END NOT FOUND", {Cause::MissingEnd}},
  };
  for (const Row& row : rows)
    for (const Cause cause : row.causes)
      c.alarms[cause] = {row.number, row.text, kAlarms, Inferred};
}

}  // namespace

Control haas_ngc() {
  Control c;
  c.title = "Haas mill, Next Generation Control";
  reading(c);
  calls_and_returns(c);
  macros(c);
  motion(c);
  variables(c);
  settings(c);
  alarms(c);
  return c;
}

}  // namespace cncsub
