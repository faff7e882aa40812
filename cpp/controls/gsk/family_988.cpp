// The rules, variables and parameters that the GSK 988TA and 988T share.
#include "controls/gsk/family.hpp"

namespace cncsub::gsk {
namespace {

// The codes of G code systems A and B that the papers on the 988TA and its alarms name. The rest is
// general knowledge.
constexpr const char* kLatheCodes =
    "0 1 2 3 4 7 7.1 7.9 9 10 11 12.1 13.1 17 18 19 20 21 22 23 25 26 27 28 29 30 31 "
    "32 32.1 32.2 32.3 33 34 36 37 40 41 42 50 50.2 50.3 51.2 51.3 52 53 54 55 56 57 58 59 "
    "61 64 65 66 67 68 68.1 69 69.1 70 71 72 73 74 75 76 77 78 79 "
    "80 83 84 85 87 88 89 90 91 92 92.1 92.2 94 95 96 97 98 99";

void read_988(Control& c) {
  c.reading.semicolon = {Semicolon::EndOfBlock, kTA + "27, example", Manual};
  lacks(c.reading.program_heads, {ProgramHead::Percent},
        kTA + "28 p.1: O and four digits, or a name", Manual);
  lacks(c.reading.program_heads, {ProgramHead::Name}, kTA + "28 p.1: a name is the name of a file",
        Manual);
  lacks(c.reading.program_heads, {ProgramHead::File},
        kPolicy + ": an O word in the file names the program", Inferred);
  c.reading.max_program_number = {9999, k000 + "word P: four digits", SourceDocument};
  c.reading.max_sequence_number = {99999, kTA + "28 p.5: P of M99 has five digits", Manual};
  lacks(c.common.refuses, {Cause::SequenceNumberNotFirst},
        kTA + "27, note 6 asks it of macro statements only", Manual);
  c.reading.cuts_fine_digits = {false, kPolicy, Inferred};
  c.reading.late_sequence_numbers = {true, kPolicy, Inferred};
  c.reading.max_words = {0, kPolicy, Inferred};
  c.reading.max_block_length = {256, kTalm + "002", Manual};
  c.reading.max_digits = {8, kTalm + "003", Manual};
  c.reading.block_skip = {BlockSkip::Anywhere, kGeneral, Inferred};
  c.reading.repeated_address = {RepeatedAddress::LastWins, kTApar + "3403#6 AD2 = 0", Manual};
  c.reading.open_comment = {OpenComment::RestOfBlock, kPolicy, Inferred};
  c.reading.point_addresses = {"ABCDEFIJKQRUVWXYZ", kGeneral, Inferred};
  c.reading.minus_addresses = {"ABCDEFHIJKLQRSUVWXYZ",
                               kGeneral + "; a negative L is a value out of range, TA27", Inferred};
  c.reading.whole_numbers = {WholeNumbers::Millimetres, "inferred from the examples of TA28",
                             Inferred};
  c.reading.missing_end = {MissingEnd::Alarm, kTApar + "3404#6 EOR = 0; Talm 019", Manual};
  c.reading.m_codes_per_block = {1, kTApar + "3404#7 M3B = 0", Manual};
  c.reading.extra_m_codes = {ExtraMCodes::Alarm, kTalm + "012: 3404#7", Secondary};
  c.reading.bare_g = {false, kTalm + "005", Manual};
  c.reading.unlisted_codes = {UnlistedCode::Refused, "inferred: Talm 009, illegal G code",
                              Inferred};
  c.reading.g_codes = {kLatheCodes,
                       kTA + "1 to TA28, titles; motion and offset codes from general knowledge",
                       Inferred};
}

void call_988(Control& c) {
  c.calls.name_marks = {"+-_.", k000 + "format 2", SourceDocument};
  c.calls.program_word = {ProgramWord::CountAndNumber, k000 + "word P, format 1 (1)",
                          SourceDocument};
  c.calls.max_program_digits = {8, k000 + "word P, format 1 (1)", SourceDocument};
  c.calls.count_and_l = {CountAndL::Alarm, k000 + "words L and Q (3)", SourceDocument};
  c.calls.bracket_names = {true, k000 + "word P, format 2", SourceDocument};
  c.calls.wide_names = {false, k000 + "word P, format 2 (1)", SourceDocument};
  c.calls.max_name_length = {32, kPolicy, Inferred};
  c.calls.call_values = {CallValues::Cut, k000 + "word P, formats 1 (2) and 2", SourceDocument};
  c.calls.omitted_program = {OmittedProgram::OwnFromStart, k000 + "word P, format 3",
                             SourceDocument};
  c.calls.start_word = {StartWord::Q, k000 + "words L and Q (1)", SourceDocument};
  c.calls.self_call = {SelfCall::WithStart, k000 + "word P, format 3", SourceDocument};
  c.calls.caller_call = {CallerCall::WithStart, "inferred from Talm 084 and source 000, format 3",
                         Inferred};
  c.calls.max_repeats = {9999, k000 + "M198 (3)", SourceDocument};
  c.calls.zero_repeats = {ZeroRepeats::Alarm, k000 + "words L and Q (2): 0 < L", SourceDocument};
  c.calls.too_many_repeats = {TooManyRepeats::Clamp, k000 + "M198 (3)", SourceDocument};
  c.calls.max_nesting = {12, k000 + "nesting", SourceDocument};
  c.calls.nesting_counts_macros = {true, k000 + "nesting", SourceDocument};
  c.calls.max_macro_nesting = {4, kTA + "27, note 2", Manual};
  c.calls.max_total_nesting = {0, k000 + "nesting: max_nesting counts both kinds", SourceDocument};
  c.calls.mdi_calls = {MdiCalls::OneLevel, k000 + "note 4", SourceDocument};
  give_role(c.calls.roles, "M198", Role::ExternalCall, k000 + "M198", SourceDocument);
  c.calls.device_word = {false, k000 + "M198", SourceDocument};
  c.calls.return_search = {ReturnSearch::NearestBehindCall, k000 + "note 2", SourceDocument};
  c.calls.return_with_p = {ReturnWithP::AtOnce, "inferred from source 000, M99", Inferred};
  c.calls.return_with_l = {ReturnWithL::Ignored, kPolicy, Inferred};
  c.calls.main_return = {MainReturn::Restarts, k000 + "M99", SourceDocument};
  no_role(c.calls.roles, {"M97"}, kTApar + "6003#4: M97 ends a macro interrupt", Manual);
  c.calls.calls_in_modal = {CallsInModal::Refused, kTA + "27, G66, note 1", Manual};
  c.calls.codes_not_with_return = {"28 30 53 36 37", kTalm + "030", Manual};
  c.calls.codes_not_with_call = {"70 71 72 73", kTalm + "132", Manual};
}

void statements_988(Control& c) {
  c.macros.statements = {"# [ IF WHILE DO GOTO DPRNT? BPRNT? POPEN? PCLOS?",
                         kTA + "27, example; Talm 209, 211, 213", Manual};
  has(c.common.reset_clears, {Cleared::Locals}, kTA + "27, parameter 6001#7", Manual);
  has(c.common.reset_clears, {Cleared::Commons}, kTA + "27, parameter 6001#6", Manual);
  c.macros.max_constant_digits = {12, kPolicy, Inferred};
  c.macros.max_condition_length = {0, kPolicy, Inferred};
  c.macros.if_form = {IfForm::GotoThen, kTA + "27, example; THEN from general knowledge", Manual};
  c.macros.loop_form = {LoopForm::DoEnd, kTalm + "209, 211", Manual};
  c.calls.jump_search = {JumpSearch::ForwardThenHead, kGeneral, Inferred};
  c.calls.max_jump_number = {99999, kTalm + "213", Manual};
  c.macros.max_loop_number = {3, kTalm + "211", Manual};
  c.macros.max_loops = {3, "inferred from Talm 211", Inferred};
  c.macros.loops_count_across_calls = {false, kGeneral, Inferred};
  c.macros.max_ifs = {10, kPolicy + "; without effect where IF has no blocks", Inferred};
  c.macros.max_brackets = {5, kTalm + "205", Manual};
  c.macros.angle_unit = {AngleUnit::Degrees, kTApar + "6004#0 counts in degrees", Manual};
  c.macros.atan_range = {AngleRange::FullTurn, kTApar + "6004#0 NAT = 0", Manual};
  c.macros.asin_range = {AngleRange::FullTurn, kTApar + "6004#0 NAT = 0", Manual};
  lacks(c.macros.conditions, {Condition::Symbols}, kGeneral, Inferred);
  lacks(c.macros.conditions, {Condition::Bare}, kTA + "27, example", Manual);
  c.macros.short_functions = {false, kPolicy, Inferred};
  c.macros.functions = {"SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP BIN BCD",
                        kGeneral + "; Talm 206, TApar 6004", Inferred};
  c.macros.vacant_address = {VacantAddress::Ignored, kGeneral, Inferred};
  c.macros.vacant_comparison = {VacantComparison::Distinguished, kGeneral, Inferred};
  c.macros.logic_order = {LogicOrder::LikeArithmetic, kGeneral, Inferred};
}

void macros_988(Control& c) {
  c.macros.codes_not_with_macro_call = {c.reading.g_codes.value, kTA + "27 note 6; Talm 212",
                                        Manual};
  c.macros.m_codes_not_with_macro_call = {"", "M is the argument #13 [TA27]", Manual};
  c.macros.codes_not_with_modal_call = {c.reading.g_codes.value, kTA + "27 note 6; Talm 212",
                                        Manual};
  give_role(c.calls.roles, "G65", Role::MacroCall, kTA + "27", Manual);
  no_role(c.calls.roles, {"G66.1"}, kTA + "27 names G65, G66 and G67", Manual);
  c.macros.max_macro_digits = {4, kTA + "27, format 1 (2)", Manual};
  c.macros.argument_sets = {ArgumentSets::PerLetter, kTA + "27, example J12 K22 J25 I33 J32",
                            Manual};
  c.macros.numbered_axis_arguments = {true, kTA + "27, arguments I", Manual};
  c.macros.call_passes_words = {false, kTA + "27: only G65 and G66 pass arguments", Manual};
  c.macros.words_before_macro_call = {WordsBeforeMacroCall::Alarm, kTA + "27, note 3", Manual};
  c.macros.repeated_argument = {RepeatedAddress::LastWins, kTA + "27, note 1: 3403#6 AD2 = 0",
                                Manual};
  c.macros.modal_locals = {ModalLocals::Rewritten, kTA + "27, example of G66", Manual};
  c.macros.modal_trigger = {ModalTrigger::Move, kTA + "27, G66, note 3 and example", Manual};
  c.macros.second_modal_call = {SecondModal::Stacks,
                                kTA + "27, note 2: G66 counts to the four levels", Manual};
  c.macros.max_modal_calls = {4, kTA + "27, note 2: G66 counts to the four levels", Manual};
  c.macros.cancel_alone = {CancelAlone::Alarm, kTApar + "6000#0 G67 = 0; Talm 218", Manual};
  c.macros.h_codes = {false, kTApar + "6000#7 EMA = 0", Manual};
  c.macros.code_cascade = {CodeCascade::All,
                           "inferred from TA27, M, T and G calls, note 4: only the four levels",
                           Inferred};
  c.macros.user_alarm_offset = {3000, kGeneral, Inferred};
  c.macros.user_alarm_last = {200, kGeneral, Inferred};
  c.macros.h99_offset = {500, kGeneral + ", as on the older GSK lathes", Inferred};
  c.user_alarm_digits = 4;
}

void variables_988(Control& c) {
  const auto add = [&c](std::int32_t first, std::int32_t last, VariableKind kind,
                        Access access = Access::ReadOnly) {
    c.variables.push_back({first, last, kind, access, 0, kGeneral, Inferred});
  };
  add(0, 0, VariableKind::Vacant);
  c.variables.push_back(
      {1, 33, VariableKind::Local, Access::ReadWrite, 0, kTA + "27, arguments", Manual});
  c.macros.commons = {"100-199 500-999", kTApar + "6001#6 and 6031", Manual};
  c.macros.variable_options = {"", kPolicy, Inferred};
  add(1000, 1015, VariableKind::Input);
  add(1032, 1035, VariableKind::InputWord);
  add(1100, 1115, VariableKind::Output, Access::ReadWrite);
  add(1132, 1135, VariableKind::OutputWord, Access::ReadWrite);
  add(3000, 3000, VariableKind::UserAlarm, Access::WriteOnly);
  add(3001, 3001, VariableKind::Milliseconds, Access::ReadWrite);
  add(3002, 3002, VariableKind::Hours, Access::ReadWrite);
  add(3003, 3004, VariableKind::Control1, Access::ReadWrite);
  add(3005, 3005, VariableKind::Settings, Access::ReadWrite);
  add(3006, 3006, VariableKind::Message, Access::WriteOnly);
  add(3011, 3011, VariableKind::Date);
  add(3012, 3012, VariableKind::Time);
  add(3901, 3902, VariableKind::PartsCount, Access::ReadWrite);
  add(4001, 4030, VariableKind::ModalCode);
  modal_words(c, "BDEFHMNOST", kGeneral, Inferred);
  add(5001, 5008, VariableKind::BlockEnd);
  add(5021, 5028, VariableKind::MachinePosition);
  add(5041, 5048, VariableKind::WorkPosition);
  c.variables.push_back({5061, 5068, VariableKind::SkipPosition, Access::ReadOnly, 0,
                         kTApar + "6003#1 names #5061", Manual});
  add(5201, 5328, VariableKind::WorkOffset, Access::ReadWrite);
}

/// The parameters that set rules, and those of codes that call.
const Parameter kParameters[] = {
    {"3403#6",
     0,
     "AD2, an address or a G group twice in a block: 0 the last counts, 1 an alarm",
     kTApar + "3403#6",
     Manual,
     {bit(rule::repeated_address, RepeatedAddress::LastWins, RepeatedAddress::Alarm),
      bit(rule::repeated_argument, RepeatedAddress::LastWins, RepeatedAddress::Alarm)}},
    {"3404#6",
     0,
     "EOR, a program without its end: 0 an alarm, 1 none",
     kTApar + "3404#6",
     Manual,
     {bit(rule::missing_end, MissingEnd::Alarm, MissingEnd::Ends)}},
    {"3404#7",
     0,
     "M3B, M codes in a block: 0 one, 1 three",
     kTApar + "3404#7",
     Manual,
     {bit(rule::m_codes_per_block, 1, 3)}},
    {"6000#0",
     0,
     "G67 without G66: 0 an alarm, 1 ignored",
     kTApar + "6000#0",
     Manual,
     {bit(rule::cancel_alone, CancelAlone::Alarm, CancelAlone::Ignored)}},
    {"6000#7",
     0,
     "EMA, G65: 0 calls a macro, 1 is type A, G65 H",
     kTApar + "6000#7",
     Manual,
     {bit(rule::h_codes)}},
    {"6001#6",
     0,
     "CCV, #100 to #199 at reset: 0 cleared, 1 kept",
     kTApar + "6001#6",
     Manual,
     {entry_while_zero(rule::reset_clears, Cleared::Commons)}},
    {"6001#7",
     0,
     "CLV, #1 to #33 at reset: 0 cleared, 1 kept",
     kTApar + "6001#7",
     Manual,
     {entry_while_zero(rule::reset_clears, Cleared::Locals)}},
    {"6004#0",
     0,
     "NAT, ATAN and ASIN: 0 gives 0 to 360 and 270 to 90, 1 -180 to 180 and -90 to 90",
     kTApar + "6004#0",
     Manual,
     {bit(rule::atan_range, AngleRange::FullTurn, AngleRange::Signed),
      bit(rule::asin_range, AngleRange::FullTurn, AngleRange::Signed)}},
    {"6008#5", 0, "TMP: 1 lets T codes call macros", kTApar + "6008#5", Manual},
    {"6008#6", 0, "MMP: 1 lets M codes call macros", kTApar + "6008#6", Manual},
    {"6008#7", 0, "GMP: 1 lets G codes call macros", kTApar + "6008#7", Manual},
};

/// Add ten codes each of T, M and G that call a macro.
void code_calls_988(Control& c) {
  const auto list = [&c](char address, std::int32_t parameter, std::int32_t program,
                         const std::string& enable, std::int32_t first_code, std::int32_t last_code,
                         const Codes& refused) {
    for (std::int32_t i = 0; i < 10; ++i) {
      const std::string number = std::to_string(parameter + i);
      c.parameters.push_back(
          {number, 0, std::string(1, address) + " code that calls O" + std::to_string(program + i),
           kTApar + number, Manual});
    }
    CodeCall call =
        code_call(CodeCall::Form::List, address, CodeCallKind::Macro, parameter, program, 10);
    call.enable = enable;
    call.first_code = first_code;
    call.last_code = last_code;
    call.refused = refused;
    call.source = kTA + "27, M, T and G codes";
    call.evidence = Manual;
    c.code_calls.push_back(call);
  };
  list('T', 6060, 9010, "6008#5", 1, 9999, "");
  list('M', 6080, 9020, "6008#6", 3, 9999, "30 98 99 198");
  list('G', 6090, 9030, "6008#7", 500, 599, "");
}

const AlarmList& alarms_988t() {
  using enum Cause;
  static const AlarmList list = {"Talm",
                                 Manual,
                                 false,
                                 "",
                                 {
#include "controls/gsk/alarms_988t.def"
                                 }};
  return list;
}

}  // namespace

Control family_988() {
  Control c;
  read_988(c);
  call_988(c);
  statements_988(c);
  macros_988(c);
  take_list(c, alarms_988t());
  // Of these the list has an alarm for another block than the rule means, or the 988TA runs them.
  refuse_listed(
      c, alarms_988t(),
      {Cause::IllegalRepeatCount, Cause::NoFeed, Cause::ToolWithSetting,
       Cause::IllegalWordWithReturn, Cause::ArcAxis, Cause::NoRadius, Cause::ThreadRunOutAcross,
       Cause::GrooveAxis, Cause::GrooveEscape, Cause::IllegalVariableValue});
  c.alarms[Cause::IllegalMacroNumber] = {"291", "P[#] has more than 4 digits", "TA27", Manual};
  variables_988(c);
  add_parameters(c, kParameters);
  code_calls_988(c);
  add_988_motion(c);
  return c;
}

}  // namespace cncsub::gsk
