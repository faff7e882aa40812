// Haas mills with the Next Generation Control.
// The keys of the sources stand in sources.def. HNGC is the operator's manual. What no source says
// is as in the family.
#include "controls/facts.hpp"
#include "controls/haas/family.hpp"
#include "controls/settings.hpp"

namespace cncsub {
namespace {

using enum Evidence;

constexpr const char* kHaas = "general knowledge of the Haas mill";
constexpr const char* kPolicy = "policy, nobody says";
constexpr const char* kAlarms = "general knowledge of the Haas alarm list";

void reading(Control& c) {
  c.reading.max_program_number = {99999, "HNGC p.132: five digits", Manual};
  c.reading.max_sequence_number = {99999, kHaas, Inferred};
  c.reading.block_skip = {BlockSkip::Anywhere, kHaas, Inferred};
  c.reading.m_codes_per_block = {1, "HNGC p.345: one M code a block", Manual};
  c.reading.extra_m_codes = {ExtraMCodes::Alarm, "HNGC p.345: one M code a block", Manual};
  c.reading.whole_numbers = {WholeNumbers::Increments, "HNGC p.393, setting 162", Manual};
  c.reading.missing_end = {MissingEnd::Alarm, "HNGC p.134: without M99 it is alarm 312", Manual};
  c.reading.g_codes = {
      "0 1 2 3 4 9 10 12 13 17 18 19 20 21 28 29 31 35 36 37 40 41 42 43 44 47 49 50 51 52 53 54 "
      "55 56 57 58 59 60 61 64 65 68 69 70 71 72 73 74 76 77 80 81 82 83 84 85 86 87 88 89 90 91 "
      "92 93 94 95 98 99 100 101 102 103 107 110 111 112 113 114 115 116 117 118 119 120 121 122 "
      "123 124 125 126 127 128 129 136 141 143 150 153 154 155 161 162 163 164 165 166 169 174 184 "
      "187 188 234 253 254 255 268 269",
      "HNGC p.237 to 242, list of G codes", Manual};
  for (const char* code : {"87", "88", "102", "253", "268", "269"})
    c.reading.g_codes.tell(code, kHaas, Inferred);
}

/// Take over what the manual's list of M codes says. M29 turns on a relay, and taps nothing.
void roles_of_codes(Control& c) {
  constexpr const char* kList = "HNGC p.345 to 347, list of M codes";
  struct Row {
    CodeName code;
    Role role;
  };
  constexpr Row rows[] = {{"M00", Role::Stop},
                          {"M01", Role::OptionalStop},
                          {"M02", Role::End},
                          {"M03", Role::SpindleForward},
                          {"M04", Role::SpindleBackward},
                          {"M05", Role::SpindleStop},
                          {"M06", Role::ToolChange},
                          {"M30", Role::End},
                          {"M98", Role::Call},
                          {"M99", Role::Return}};
  for (const auto& [code, role] : rows) give_role(c.calls.roles, code, role, kList, Manual);
  no_role(c.calls.roles, {"M29"}, "HNGC p.352, M29", Manual);
  give_role(c.calls.roles, "G65", Role::MacroCall, "HNGC p.232, G65", Manual);
  give_role(c.calls.roles, "M97", Role::LocalCall, "HNGC p.358, M97", Manual);
  give_role(c.calls.roles, "M96", Role::JumpUnlessInput, "HNGC p.357, M96", Manual);
}

void calls_and_returns(Control& c) {
  c.calls.program_word = {ProgramWord::Number, "HNGC p.359, M98: P is the number of the program",
                          Manual};
  c.calls.max_program_digits = {5, "HNGC p.149: Onnnnn", Manual};
  c.calls.max_repeats = {99, "HNGC p.358, 359: L is 1 to 99", Manual};
  c.calls.zero_repeats = {ZeroRepeats::Once, kPolicy, Inferred};
  c.calls.max_nesting = {9, kHaas, Inferred};
  c.calls.max_macro_nesting = {9, "HNGC p.232: G65 can be nested nine times", Manual};
  c.calls.return_with_p = {ReturnWithP::OwnProgram,
                           "HNGC p.224, M99 P: it does not return to the caller", Manual};
  c.calls.main_return = {MainReturn::Restarts, "HNGC p.360, M99 in the main program", Manual};
  roles_of_codes(c);
  c.calls.conditional_return = {true, "HNGC p.227, [#1EQ#2] M99 P5", Manual};
}

void macros(Control& c) {
  c.macros.commons = {"10000-10999", "HNGC p.199, global variables", Manual};
  c.macros.statements = {"# [ IF WHILE DO GOTO DPRNT BPRNT? POPEN PCLOS",
                         "HNGC p.226 to 230; POPEN and PCLOS are general knowledge", Inferred};
  c.macros.loop_form = {LoopForm::DoEnd, "HNGC p.229: WHILE, DO and END", Manual};
  c.macros.prints_leading_blanks = {true, "HNGC p.230: leading spaces", Manual};
  c.macros.angle_unit = {AngleUnit::Degrees, "HNGC p.221, functions", Manual};
  c.macros.max_loop_number = {3, "HNGC p.229: DO 1 to 3", Manual};
  c.macros.max_loops = {3, "HNGC p.229: three nested loops", Manual};
  c.macros.loops_count_across_calls = {false, "HNGC p.229: three levels in each subprogram",
                                       Manual};
  c.macros.if_form = {
      IfForm::Words,
      "HNGC p.228, THEN G01 X#24 and THEN #101=0.0 M99; without THEN VBH, 9000.nc: IF[#10001 EQ 0] "
      "M98 P9004; H96 p.159: IF [ #9 EQ #0 ] #9= #4109",
      Secondary};
  has(c.macros.conditions, {Condition::Values}, "HNGC p.227: IF [#1] GOTO5", Manual);
  has(c.macros.conditions, {Condition::Joined}, "HNGC p.223: IF [[..] AND [..]] GOTO1", Manual);
  c.macros.short_functions = {false, kPolicy, Inferred};
  c.macros.functions = {"SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX MOD",
                        "HNGC p.220, functions; p.223, MOD", Manual};
  c.macros.vacant_address = {VacantAddress::Ignored, "HNGC p.220: no Y movement", Manual};
  c.macros.vacant_comparison = {VacantComparison::Distinguished, "HNGC p.228: IF [#9NE#0] GOTO3",
                                Manual};
  lacks(c.common.reset_clears, {Cleared::Commons}, "HNGC p.199: they stay at power-off", Manual);
  no_role(c.calls.roles, {"G66", "G67"}, kHaas, Inferred);
  c.macros.max_macro_digits = {5, "HNGC p.232: G65 Pnnnnn", Manual};
  c.macros.words_before_macro_call = {WordsBeforeMacroCall::Alarm, "general knowledge: 528",
                                      Inferred};
  c.macros.user_alarm_offset = {1000, "HNGC p.210, #3000", Manual};
  c.macros.user_alarm_last = {999, "HNGC p.210, #3000", Manual};
}

void motion(Control& c) {
  leave_out(c, RuleGroup::TurningRules, "HNGC p.237", Manual);  // of mills
  c.motion.machine = {MachineType::Mill, "HNGC p.237, the codes of mills", Manual};
  c.motion.g_meanings = {
      "47=not-computed 87=not-computed 88=not-computed "
      "103=look-ahead-limit "
      "110=extra-system-1 111=extra-system-2 112=extra-system-3 113=extra-system-4 "
      "114=extra-system-5 115=extra-system-6 116=extra-system-7 117=extra-system-8 "
      "118=extra-system-9 119=extra-system-10 120=extra-system-11 121=extra-system-12 "
      "122=extra-system-13 123=extra-system-14 124=extra-system-15 125=extra-system-16 "
      "126=extra-system-17 127=extra-system-18 128=extra-system-19 129=extra-system-20 "
      "150=not-computed 154=extra-system 187=neutral",
      "HNGC p.308, 323: G110 to G129, G154; the others general knowledge of the Haas mill",
      Inferred};
  c.motion.rapid_way = {RapidWay::OwnRates, "HNGC p.248: each axis at its own speed", Manual};
  c.motion.negative_radius = {NegativeRadius::LongWay, "HNGC p.252: R below zero", Manual};
  c.motion.helix = {Helix::Everywhere, "HNGC p.254: helical interpolation", Manual};
  c.motion.chamfer_words = {",C", "HNGC p.249: ,C", Manual};
  c.motion.round_words = {",R", "HNGC p.249: ,R", Manual};
  c.motion.rotation_words = {"R", "HNGC p.282: R is the angle", Manual};
  c.motion.max_extra_systems = {99, "HNGC p.323, G154 P1 to P99", Manual};
  c.motion.max_offset_number = {200, "HNGC p.220: D is 0 to 200", Manual};
  c.motion.dwell_words = {"P", "HNGC p.258, G04", Manual};
  c.motion.dwell_point = {DwellPoint::CyclesToo,
                          "HNGC p.258: G04 P10. is ten seconds, P10 ten milliseconds; p.295: G82 "
                          "P0.3; p.296: G83 P1.5",
                          Manual};
  c.motion.cycle_repeats = {"L", "HNGC p.293, L", Manual};
  c.motion.max_rotation = {360, "HNGC p.282: R is -360. to 360.", Manual};
  c.motion.computed_lengths = {ComputedLengths::Rounded,
                               "HNGC p.221: G00 X[#1+#1] with 1.00333 goes to 2.0067", Manual};
  c.motion.scale_unit = {ScaleUnit::AsWritten,
                         "HML p.136: G51 P2. and G51 P2; H96 p.159: G51 P [ #5 * 1000 ]",
                         Secondary};
}

/// Add settings by their numbers.
void settings(Control& c) {
  const auto add = [&c](const char* name, double value, const char* meaning,
                        std::vector<Setting> sets, const char* source = kHaas,
                        Evidence evidence = Inferred) {
    c.parameters.push_back({name, value, meaning, source, evidence, std::move(sets)});
    apply(c, c.parameters.back(), "setting " + std::string(name) + " as delivered: " + kHaas,
          Inferred);
  };
  const auto told = [&add](const char* name, double value, const char* meaning,
                           std::vector<Setting> sets, const char* source) {
    add(name, value, meaning, std::move(sets), source, Manual);
  };
  told("9", 0, "the unit, which G20 or G21 must be too: 0 = mm, 1 = inch",
       {entry(rule::power_on, PowerOn::G20)}, "HNGC p.375, setting 9");
  told("22", 0.5, "how far a peck draws back, mm",
       {micrometres(rule::peck_retract), micrometres(rule::peck_clearance)},
       "HNGC p.377, setting 22, and the pictures of G73 and G83");
  told("33", 0, "what M02 and M30 do to G52: 0 = FANUC, they end it, 1 = HAAS, it stays",
       {entry_while_zero(rule::reset_clears, Cleared::LocalSystem)}, "HNGC p.379, setting 33");
  told("40", 0, "an offset of D is 0 = a radius, 1 = a diameter",
       {bit(rule::radius_offset_diameter)}, "HNGC p.380, setting 40");
  told("43", 0, "the start-up of cutter compensation: 0 = type A, 1 = type B",
       {bit(rule::start_up, StartUp::TypeA, StartUp::TypeB)}, "HNGC p.380, setting 43");
  told("52", 0, "how far above R a peck draws back that clears chips, mm",
       {micrometres(rule::peck_above)}, "HNGC p.382, setting 52");
  told("56", 0, "M30 brings back the G codes of power-on: 0 = no, 1 = yes",
       {entry(rule::reset_clears, Cleared::Codes)}, "HNGC p.382, setting 56");
  told("57", 0, "X and Y stop exactly before a hole; the path is the same", {},
       "HNGC p.382, setting 57");
  told("85", 0.635, "how far a corner may be rounded, mm; no path is drawn otherwise for it", {},
       "HNGC p.387, setting 85: 0.0250 inch");
  told("88", 0, "reset takes back the overrides; no path is drawn otherwise for it", {},
       "HNGC p.388, setting 88");
  told("162", 0, "a number without a point counts 0 = least increments, 1 = mm, inches or degrees",
       {bit(rule::whole_numbers, WholeNumbers::Increments, WholeNumbers::Millimetres)},
       "HNGC p.393, setting 162");
}

/// Add the aliases of codes, by the programs that they call.
void aliases(Control& c) {
  using Form = CodeCall::Form;
  c.code_calls = {{Form::List, 'M', CodeCallKind::Subprogram, 9000, 9000, 10, "", 0, 1, 255, "",
                   "HNGC p.233, aliasing", Manual},
                  {Form::List, 'G', CodeCallKind::Macro, 9010, 9010, 10, "", 0, 1, 255, "65 66 67",
                   "HNGC p.233, aliasing", Manual}};
  for (int program = 9000; program < 9020; ++program)
    c.parameters.push_back({std::to_string(program), 0,
                            std::string("the ") + (program < 9010 ? "M" : "G") +
                                " code that is an alias of O" + std::to_string(program) +
                                ", 0 = none",
                            "HNGC p.233, aliasing", Manual});
}

/// Set the alarms: those that the manual names, and others from memory, since no printed list was
/// found. A cause that is not listed shows no number.
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
      {"313", "NO P CODE IN M97, M98, OR G65", {ProgramNumberMissing}},
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
  c.alarms[EndOfRecord] = {"312", "Program End", "HNGC p.134", Manual};
  c.alarms[ProgramNotFound] = {"314", "Subprogram Not In Memory", "HNGC p.314, G150", Manual};
}

}  // namespace

Control haas_ngc() {
  Control c;
  c.title = "Haas mill, Next Generation Control";
  reading(c);
  calls_and_returns(c);
  macros(c);
  motion(c);
  haas::add_family_variables(c);
  settings(c);
  aliases(c);
  alarms(c);
  return c;
}

}  // namespace cncsub
