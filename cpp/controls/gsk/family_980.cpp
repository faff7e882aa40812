// The rules, variables and parameters that the GSK 980TDi and 980MDi share.
#include "controls/gsk/family.hpp"

namespace cncsub::gsk {
namespace {

void read_980(Control& c) {
  c.reading.semicolon = {Semicolon::EndOfBlock, kTDi + "15 1.1.1: a block ends with ;", Manual};
  lacks(c.reading.program_heads, {ProgramHead::Percent},
        kTDi + "15 1.1.1: O and four digits, or a name", Manual);
  lacks(c.reading.program_heads, {ProgramHead::Name},
        kTDi + "15 1.1.1: a name is the name of a file", Manual);
  lacks(c.reading.program_heads, {ProgramHead::File},
        kPolicy + ": an O word in the file names the program", Inferred);
  c.reading.max_program_number = {9999, kTDi + "15 1.1.1", Manual};
  c.reading.max_sequence_number = {99999, kMDib + "0112: 0 to 99999", Manual};
  has(c.common.refuses, {Cause::ProgramNumberZero}, kMDia + "095: O0000 cannot be called", Manual);
  has(c.common.refuses, {Cause::SequenceNumberNotFirst}, kMDia + "006", Manual);
  c.reading.cuts_fine_digits = {false, kPolicy, Inferred};
  c.reading.late_sequence_numbers = {true, kPolicy, Inferred};
  c.reading.max_words = {100, kMDia + "011", Manual};
  c.reading.max_block_length = {256, kMDia + "037", Manual};
  c.reading.max_digits = {10, kMDia + "003: a word has at most 11 characters", Manual};
  c.reading.block_skip = {BlockSkip::HeadOnly, kGeneral, Inferred};
  c.reading.repeated_address = {RepeatedAddress::Alarm, kMDia + "010", Manual};
  c.reading.open_comment = {OpenComment::Alarm, kMDia + "041", Manual};
  c.reading.point_addresses = {"ABCDEFIJKLQRUVWXYZ",
                               kTDi + "11: L and D are lengths; the others from general knowledge",
                               Inferred};
  c.reading.minus_addresses = {
      "ABCDEFHIJKLPQRSUVWXYZ",
      kTDi + "14: a negative time is none; MDib 0140: a negative scale; MDib 0092: L", Manual};
  c.reading.whole_numbers = {WholeNumbers::Millimetres, "inferred from the examples of the manual",
                             Inferred};
  c.reading.missing_end = {MissingEnd::Alarm, kPolicy, Inferred};
  c.reading.m_codes_per_block = {1, kGeneral, Inferred};
  c.reading.extra_m_codes = {ExtraMCodes::Dropped, kGeneral, Inferred};
  c.reading.bare_g = {false, kMDia + "003: a word has at least two characters", Manual};
}

void call_980(Control& c) {
  c.calls.name_marks = {"+-.", kTDi + "15", Manual};
  c.calls.program_word = {ProgramWord::CountAndNumber, kTDi + "15 1.1.7, format 1", Manual};
  c.calls.max_program_digits = {
      10, "inferred from MDib 0092: a count above 9999 is read, and alarms", Inferred};
  c.calls.count_and_l = {CountAndL::NoL, kTDi + "15 1.1.7: L goes with P[] only", Manual};
  c.calls.bracket_names = {true, kTDi + "15 1.1.7, format 2: 878 = 1", Manual};
  c.calls.wide_names = {true, kTDi + "15 1.1.1: names may be Chinese", Manual};
  c.calls.max_name_length = {20, kTDi + "15 1.1.1", Manual};
  c.calls.call_values = {CallValues::Cut, kPolicy + "; as on the 988TA", Inferred};
  has(c.common.refuses, {Cause::IllegalRepeatCount}, "inferred from MDib 0092: a count less than 1",
      Inferred);
  c.calls.omitted_program = {OmittedProgram::Alarm, kMDia + "095", Manual};
  c.calls.start_word = {StartWord::None, kTDi + "15 1.1.7 has no Q", Manual};
  c.calls.self_call = {SelfCall::Refused, kMDia + "097", Manual};
  c.calls.caller_call = {CallerCall::MainRefused, kMDia + "094", Manual};
  c.calls.max_repeats = {9999, kTDi + "15 1.1.7", Manual};
  c.calls.zero_repeats = {ZeroRepeats::Alarm, kMDib + "0092: less than 1", Manual};
  c.calls.too_many_repeats = {TooManyRepeats::Alarm, kMDib + "0092: more than 9999", Manual};
  c.calls.max_nesting = {4, kMDia + "096", Manual};
  c.calls.nesting_counts_macros = {false, kPolicy, Inferred};
  c.calls.max_macro_nesting = {4, kTDi + "28 3.28.3.1: four levels", Manual};
  c.calls.max_total_nesting = {0, kPolicy, Inferred};
  c.calls.mdi_calls = {MdiCalls::Refused, kGeneral + "; MDib 0098 refuses M9000 to M9999",
                       Inferred};
  no_role(c.calls.roles, {"M198", "M97"}, kGeneral, Inferred);
  c.calls.device_word = {false, kGeneral, Inferred};
  c.calls.return_search = {ReturnSearch::FromHead, kPolicy, Inferred};
  c.calls.return_with_p = {ReturnWithP::AtOnce, kPolicy, Inferred};
  c.calls.return_with_l = {ReturnWithL::Ignored, kPolicy, Inferred};
  c.calls.main_return = {MainReturn::Restarts, kGeneral, Inferred};
  c.calls.calls_in_modal = {CallsInModal::EndModal, kTDi + "28 3.28.3.2, note 4; MDia 113", Manual};
  c.calls.codes_not_with_return = {"", kPolicy, Inferred};
  c.calls.codes_not_with_call = {"4 54 54.1", kMDib + "0051", Manual};
}

void statements_980(Control& c) {
  lacks(c.common.reset_clears, {Cleared::Commons}, kPolicy, Inferred);
  has(c.common.refuses, {Cause::IllegalVariableValue}, kMDia + "121", Manual);
  c.macros.max_constant_digits = {12, kPolicy, Inferred};
  c.macros.max_condition_length = {0, kPolicy, Inferred};
  c.macros.statements = {"# [ IF WHILE DO GOTO DPRNT? BPRNT? POPEN? PCLOS?", kTDi + "29 3.29.2",
                         Manual};
  c.macros.if_form = {IfForm::GotoThen, kTDi + "29 3.29.2 (2)", Manual};
  c.macros.loop_form = {LoopForm::DoEnd, kTDi + "29 3.29.2 (3)", Manual};
  has(c.common.refuses, {Cause::JumpInMdi}, kPolicy, Inferred);
  c.calls.jump_search = {JumpSearch::ForwardThenHead, kGeneral, Inferred};
  c.calls.max_jump_number = {99999, kTDi + "29 3.29.2 (1)", Manual};
  c.macros.max_loop_number = {3, kTDi + "29 3.29.2 (3)", Manual};
  c.macros.max_loops = {3, "inferred from TDi29: three numbers", Inferred};
  c.macros.loops_count_across_calls = {false, kGeneral, Inferred};
  c.macros.max_ifs = {10, kPolicy + "; without effect where IF has no blocks", Inferred};
  c.macros.max_brackets = {5, kGeneral, Inferred};
  c.macros.angle_unit = {AngleUnit::Degrees, kTDi + "29, note 1", Manual};
  c.macros.atan_range = {AngleRange::FullTurn, kTDi + "29, note 4: 180#7 NAT = 0", Manual};
  c.macros.asin_range = {AngleRange::Signed, kTDi + "29, note 2: 180#7 NAT = 0", Manual};
  lacks(c.macros.conditions, {Condition::Joined}, kTDi + "29: a condition compares two values",
        Manual);
  has(c.macros.conditions, {Condition::Symbols}, kTDi + "29, conditions", Manual);
  lacks(c.macros.conditions, {Condition::Bare}, kTDi + "29, conditions", Manual);
  c.macros.short_functions = {false, kTDi + "29, table of functions", Manual};
  c.macros.functions = {
      "SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP BIN BCD RAND SRAND",
      kTDi + "29, table of functions", Manual};
  c.macros.vacant_address = {VacantAddress::Zero, kTDi + "28, vacant variables (1)", Manual};
  c.macros.vacant_comparison = {VacantComparison::Zero, kTDi + "28, vacant variables (3)", Manual};
  has(c.macros.variable_forms, {VariableForm::Indirect}, kTDi + "28, variables (2)", Manual);
  c.macros.logic_order = {LogicOrder::LikeArithmetic, kGeneral, Inferred};
}

void macros_980(Control& c) {
  c.macros.codes_not_with_macro_call = {"43 44 49", kMDib + "115", Manual};
  c.macros.m_codes_not_with_macro_call = {"0 1 2 30 98 99", kMDib + "116", Manual};
  c.macros.codes_not_with_modal_call = {
      "0 1 2 3 4 5 6.2 6.3 7.2 7.3 28 30 31 32 33 34 36 37 50 52 53 70 71 72 73 74 75 76 84 88 90 "
      "92 94",
      kMDia + "044", Manual};
  give_role(c.calls.roles, "G65", Role::MacroCall, kTDi + "28 3.28.3", Manual);
  no_role(c.calls.roles, {"G66.1"}, kTDi + "28 3.28.3 names G65, G66 and G67", Manual);
  c.macros.max_macro_digits = {4, kTDi + "28 3.28.3.1: at most four digits", Manual};
  c.macros.argument_sets = {ArgumentSets::PerLetter, kTDi + "28 3.28.3.1, example of O9010",
                            Manual};
  c.macros.numbered_axis_arguments = {false, kTDi + "28 3.28.3.1, arguments I", Manual};
  c.macros.call_passes_words = {false, kTDi + "28 3.28.3 (1): M98 passes nothing", Manual};
  c.macros.words_before_macro_call = {WordsBeforeMacroCall::Alarm, kTDi + "28 3.28.3 (3); MDia 114",
                                      Manual};
  c.macros.repeated_argument = {RepeatedAddress::LastWins, kTDi + "28 3.28.3.1: the last counts",
                                Manual};
  c.macros.modal_locals = {ModalLocals::Rewritten, kTDi + "28 3.28.3.2, note 3", Manual};
  c.macros.modal_trigger = {ModalTrigger::AxisWord,
                            kTDi + "28 3.28.3.2, note 2: blocks with G00, G01, G02, G03, G05",
                            Manual};
  c.macros.second_modal_call = {SecondModal::Stacks, kTDi + "28 3.28.3.2: four levels of G66",
                                Manual};
  c.macros.max_modal_calls = {4, kTDi + "28 3.28.3.2: four levels of G66", Manual};
  c.macros.cancel_alone = {CancelAlone::Ignored, kPolicy, Inferred};
  c.macros.h_codes = {true, kTDi + "28 3.28.2", Manual};
  c.macros.code_cascade = {CodeCascade::None, kPolicy, Inferred};
  c.macros.user_alarm_offset = {5900, kTDi + "28, #3000", Manual};
  c.macros.user_alarm_last = {99, kTDi + "28, #3000: 5900 to 5999", Manual};
  c.macros.h99_offset = {5900, kTDi + "28, G65 H99", Manual};
  c.user_alarm_digits = 4;
}

void variables_980(Control& c) {
  const std::string table = kTDi + "28, variables";
  const auto add = [&](std::int32_t first, std::int32_t last, VariableKind kind,
                       Access access = Access::ReadOnly, const std::string& note = "") {
    c.variables.push_back({first, last, kind, access, 0, table + note, Manual});
  };
  const std::string stored = ": an offset of the lathe, a stored number here";
  add(0, 0, VariableKind::Vacant);
  add(1, 33, VariableKind::Local, Access::ReadWrite);
  // The manual's example of #9100 uses #205.
  c.macros.commons = {"100-999", table, Manual};
  c.macros.variable_options = {"", kPolicy, Inferred};
  add(1000, 1015, VariableKind::Input);
  add(1032, 1034, VariableKind::InputWord);
  add(1100, 1115, VariableKind::Output, Access::ReadWrite);
  add(1132, 1134, VariableKind::OutputWord, Access::ReadWrite);
  add(2001, 2032, VariableKind::Kept, Access::ReadWrite, stored);
  add(2101, 2132, VariableKind::Kept, Access::ReadWrite, stored);
  add(2201, 2232, VariableKind::RadiusWear, Access::ReadWrite);
  add(2301, 2332, VariableKind::Kept, Access::ReadWrite, stored);
  add(2401, 2432, VariableKind::Kept, Access::ReadWrite, stored);
  add(2451, 2482, VariableKind::Kept, Access::ReadWrite, stored);
  add(2501, 2502, VariableKind::Kept, Access::ReadWrite, stored);
  add(2701, 2732, VariableKind::Kept, Access::ReadWrite, stored);
  add(2801, 2832, VariableKind::Kept, Access::ReadWrite, stored);
  add(2901, 2932, VariableKind::RadiusGeometry, Access::ReadWrite);
  add(3000, 3000, VariableKind::UserAlarm, Access::WriteOnly);
  add(3001, 3001, VariableKind::Milliseconds, Access::ReadOnly, ": the control counts in seconds");
  add(3002, 3002, VariableKind::Hours, Access::ReadWrite, ": the control counts in seconds");
  add(3011, 3011, VariableKind::Date, Access::ReadWrite);
  add(3012, 3012, VariableKind::Time, Access::ReadWrite);
  add(3901, 3902, VariableKind::PartsCount, Access::ReadWrite);
  for (const int group : {1, 2, 5, 6, 7, 12, 14, 16})
    add(4000 + group, 4000 + group, VariableKind::ModalCode);
  modal_words(c, "FMNOST", table, Manual);
  add(5001, 5005, VariableKind::BlockEnd);
  add(5021, 5025, VariableKind::MachinePosition);
  add(5041, 5045, VariableKind::WorkPosition);
  add(5201, 5325, VariableKind::WorkOffset);
}

/// The parameters that set rules, and those of codes that call.
const Parameter kParameters[] = {
    {"86", 0, "how many G codes call macros, 0 = none", kTDi + "32", Manual},
    {"87", 0, "the first G code that calls a macro", kTDi + "32", Manual},
    {"88", 0, "the program that the first G code calls", kTDi + "32", Manual},
};

const AlarmList& alarms_980mdi_a() {
  using enum Cause;
  static const AlarmList list = {"MDia",
                                 Manual,
                                 false,
                                 "",
                                 {
#include "controls/gsk/alarms_980mdi_a.def"
                                 }};
  return list;
}

}  // namespace

const AlarmList& alarms_980mdi_b() {
  using enum Cause;
  static const AlarmList list = {"MDib",
                                 Manual,
                                 false,
                                 "",
                                 {
#include "controls/gsk/alarms_980mdi_b.def"
                                 }};
  return list;
}

Control family_980() {
  Control c;
  read_980(c);
  call_980(c);
  statements_980(c);
  macros_980(c);
  take_list(c, alarms_980mdi_a());
  take_list(c, alarms_980mdi_b(), {"0002", "0051"});
  variables_980(c);
  add_parameters(c, kParameters);
  CodeCall macro = code_call(CodeCall::Form::Range, 'G', CodeCallKind::Macro, 87, 88, 86);
  macro.own_codes = false;
  macro.last_code = 9999;
  macro.source = kTDi + "32";
  macro.evidence = Manual;
  c.code_calls = {macro};
  return c;
}

}  // namespace cncsub::gsk
