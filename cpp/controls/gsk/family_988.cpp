// The GSK controls: 988TA (the control of source 000) and 988T, 980TDi and 980MDi, 928TE (the
// control of source 001).
#include "controls/facts.hpp"

namespace cncsub {

namespace {

// Where the facts come from: keys of sources.def.
const std::string k000 = "source 000, ";
const std::string k001 = "source 001, ";
const std::string kTA = "TA";
const std::string kTApar = "TApar ";
const std::string kTalm = "Talm ";
const std::string kTDi = "TDi";
const std::string kTDipar = "TDipar ";
const std::string kMDia = "MDia ";
const std::string kMDib = "MDib ";
const std::string kMDipar = "MDipar ";
const std::string kT928 = "928T1, ";
const std::string kGeneral = "general knowledge";
// A default, to be changed where a machine is known to differ.
const std::string kPolicy = "policy: nobody says";
const std::string kStands = "FANUC's number stands for the control's own";

constexpr Evidence kDocument = Evidence::SourceDocument;
constexpr Evidence kManual = Evidence::Manual;
constexpr Evidence kSecondary = Evidence::Secondary;
constexpr Evidence kInferred = Evidence::Inferred;

/// #4102 to #4120: the modal words of the block before.
void modal_words(Control& c, const std::string& addresses, const std::string& source,
                 Evidence evidence) {
  for (const char address : addresses) {
    const std::int32_t number = modal_word_number(address);
    c.variables.push_back(
        {number, number, VariableKind::ModalWord, Access::ReadOnly, address, source, evidence});
  }
}

CodeCall code_call(CodeCall::Form form, char address, CodeCallKind kind, std::int32_t parameter,
                   std::int32_t program, std::int32_t count) {
  CodeCall call;
  call.form = form;
  call.address = address;
  call.kind = kind;
  call.parameter = parameter;
  call.program = program;
  call.count = count;
  return call;
}

// ---- 988TA and 988T ----

// The codes that the papers on the 988TA and its alarms name, of G code system A and B; the rest is
// general knowledge.
const std::string kLatheCodes =
    "0 1 2 3 4 7 7.1 7.9 9 10 11 12.1 13.1 17 18 19 20 21 22 23 25 26 27 28 29 30 31 "
    "32 32.1 32.2 32.3 33 34 36 37 40 41 42 50 50.2 50.3 51.2 51.3 52 53 54 55 56 57 58 59 "
    "61 64 65 66 67 68 68.1 69 69.1 70 71 72 73 74 75 76 77 78 79 "
    "80 83 84 85 87 88 89 90 91 92 92.1 92.2 94 95 96 97 98 99";

void read_988(Control& c) {
  c.semicolon = {Semicolon::EndOfBlock, kTA + "27, example", kManual};
  c.percent_programs = {false, kTA + "28 p.1: O and four digits, or a name", kManual};
  c.named_programs = {false, kTA + "28 p.1: a name is the name of a file", kManual};
  c.file_name_wins = {false, kPolicy + ": an O word in the file names the program", kInferred};
  c.max_program_number = {9999, k000 + "word P: four digits", kDocument};
  c.max_sequence_number = {99999, kTA + "28 p.5: P of M99 has five digits", kManual};
  c.zero_numbers = {true, kPolicy, kInferred};
  c.sequence_number_first = {false, kTA + "27, note 6 asks it of macro statements only", kManual};
  c.cuts_fine_digits = {false, kPolicy, kInferred};
  c.late_sequence_numbers = {true, kPolicy, kInferred};
  c.max_words = {0, kPolicy, kInferred};
  c.max_block_length = {256, kTalm + "002", kManual};
  c.max_digits = {8, kTalm + "003", kManual};
  c.block_skip = {BlockSkip::Anywhere, kGeneral, kInferred};
  c.repeated_address = {RepeatedAddress::LastWins, kTApar + "3403#6 AD2 = 0", kManual};
  c.open_comment = {OpenComment::RestOfBlock, kPolicy, kInferred};
  c.point_addresses = {"ABCDEFHIJKQRUVWXYZ", kGeneral, kInferred};
  c.minus_addresses = {"ABCDEFHIJKLQRSUVWXYZ",
                       kGeneral + "; a negative L is a value out of range, TA27", kInferred};
  c.whole_numbers = {WholeNumbers::Millimetres, "inferred from the examples of TA28", kInferred};
  c.missing_end = {MissingEnd::Alarm, kTApar + "3404#6 EOR = 0; Talm 019", kManual};
  c.m_codes_per_block = {1, kTApar + "3404#7 M3B = 0", kManual};
  c.m_codes_alarm = {true, kTalm + "012: 3404#7", kSecondary};
  c.m_codes_alone = {false, kPolicy, kInferred};
  c.bare_g = {false, kTalm + "005", kManual};
  c.g_codes_complete = {true, "inferred: Talm 009, illegal G code", kInferred};
  c.g_codes = {kLatheCodes,
               kTA + "1 to TA28, titles; motion and offset codes from general knowledge",
               kInferred};
}

void call_988(Control& c) {
  c.name_marks = {"+-_.", k000 + "format 2", kDocument};
  c.return_alone_in_modal = {false, kPolicy, kInferred};
  c.program_word = {ProgramWord::CountAndNumber, k000 + "word P, format 1 (1)", kDocument};
  c.max_program_digits = {8, k000 + "word P, format 1 (1)", kDocument};
  c.count_and_l = {CountAndL::Alarm, k000 + "words L and Q (3)", kDocument};
  c.bracket_names = {true, k000 + "word P, format 2", kDocument};
  c.wide_names = {false, k000 + "word P, format 2 (1)", kDocument};
  c.max_name_length = {32, kPolicy, kInferred};
  c.call_values = {CallValues::Cut, k000 + "word P, formats 1 (2) and 2", kDocument};
  c.zero_count_alarms = {false, kPolicy, kInferred};
  c.omitted_program = {OmittedProgram::OwnFromStart, k000 + "word P, format 3", kDocument};
  c.start_word = {StartWord::Q, k000 + "words L and Q (1)", kDocument};
  c.self_call = {SelfCall::WithStart, k000 + "word P, format 3", kDocument};
  c.caller_call = {CallerCall::WithStart, "inferred from Talm 084 and source 000, format 3",
                   kInferred};
  c.max_repeats = {9999, k000 + "M198 (3)", kDocument};
  c.zero_repeats = {ZeroRepeats::Alarm, k000 + "words L and Q (2): 0 < L", kDocument};
  c.too_many_repeats = {TooManyRepeats::Clamp, k000 + "M198 (3)", kDocument};
  c.max_nesting = {12, k000 + "nesting", kDocument};
  c.nesting_counts_macros = {true, k000 + "nesting", kDocument};
  c.max_macro_nesting = {4, kTA + "27, note 2", kManual};
  c.max_total_nesting = {0, k000 + "nesting: max_nesting counts both kinds", kDocument};
  c.mdi_calls = {MdiCalls::OneLevel, k000 + "note 4", kDocument};
  c.external_calls = {true, k000 + "M198", kDocument};
  c.device_word = {false, k000 + "M198", kDocument};
  c.return_search = {ReturnSearch::NearestBehindCall, k000 + "note 2", kDocument};
  c.return_with_p = {ReturnWithP::AtOnce, "inferred from source 000, M99", kInferred};
  c.return_with_l = {ReturnWithL::Ignored, kPolicy, kInferred};
  c.main_return = {MainReturn::Restarts, k000 + "M99", kDocument};
  c.jump_m97 = {false, kTApar + "6003#4: M97 ends a macro interrupt", kManual};
  c.restart_m_code = {0, kGeneral, kInferred};
  c.calls_in_modal = {CallsInModal::Refused, kTA + "27, G66, note 1", kManual};
  c.codes_not_with_return = {"28 30 53 36 37", kTalm + "030", kManual};
  c.codes_not_with_call = {"", kPolicy, kInferred};
  c.words_with_call_in_cycle = {true, kPolicy, kInferred};
}

void statements_988(Control& c) {
  c.statements = {"# [ IF WHILE DO DPRNT? BPRNT? POPEN? PCLOS?", kTA + "27, example; Talm 209, 211",
                  kManual};
  c.reset_clears_locals = {true, kTA + "27, parameter 6001#7", kManual};
  c.reset_clears_commons = {true, kTA + "27, parameter 6001#6", kManual};
  c.vacant_system_writes = {true, kPolicy, kInferred};
  c.max_constant_digits = {12, kPolicy, kInferred};
  c.max_condition_length = {0, kPolicy, kInferred};
  c.if_form = {IfForm::GotoThen, kTA + "27, example; THEN from general knowledge", kManual};
  c.loop_form = {LoopForm::DoEnd, kTalm + "209, 211", kManual};
  c.jumps = {true, kTalm + "213", kManual};
  c.jumps_in_mdi = {false, kTalm + "208", kManual};
  c.jump_search = {JumpSearch::ForwardThenHead, kGeneral, kInferred};
  c.max_jump_number = {99999, kTalm + "213", kManual};
  c.max_loop_number = {3, kTalm + "211", kManual};
  c.max_loops = {3, "inferred from Talm 211", kInferred};
  c.loops_count_across_calls = {false, kGeneral, kInferred};
  c.max_ifs = {10, kPolicy + "; without effect where IF has no blocks", kInferred};
  c.max_brackets = {5, kTalm + "205", kManual};
  c.angle_unit = {AngleUnit::Degrees, kTApar + "6004#0 counts in degrees", kManual};
  c.atan_range = {AngleRange::FullTurn, kTApar + "6004#0 NAT = 0", kManual};
  c.asin_range = {AngleRange::FullTurn, kTApar + "6004#0 NAT = 0", kManual};
  c.joined_conditions = {false, kPolicy, kInferred};
  c.comparison_symbols = {false, kGeneral, kInferred};
  c.conditions_without_brackets = {false, kTA + "27, example", kManual};
  c.short_functions = {false, kPolicy, kInferred};
  c.functions = {"SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP BIN BCD",
                 kGeneral + "; Talm 206, TApar 6004", kInferred};
  c.modulo = {false, kPolicy, kInferred};
  c.vacant_address = {VacantAddress::Ignored, kGeneral, kInferred};
  c.vacant_comparison = {VacantComparison::Distinguished, kGeneral, kInferred};
  c.variable_point = {false, kPolicy, kInferred};
  c.indirect_9nnn = {false, kPolicy, kInferred};
  c.negative_logic = {false, kTalm + "217", kManual};
  c.variable_names = {false, kPolicy, kInferred};
  c.logic_binds_last = {false, kGeneral, kInferred};
}

void macros_988(Control& c) {
  c.codes_not_with_macro_call = {c.g_codes.value, kTA + "27 note 6; Talm 212", kManual};
  c.m_codes_not_with_macro_call = {"", "M is the argument #13 [TA27]", kManual};
  c.codes_not_with_modal_call = {c.g_codes.value, kTA + "27 note 6; Talm 212", kManual};
  c.macro_calls = {true, kTA + "27", kManual};
  c.modal_every_block = {false, kTA + "27 names G65, G66 and G67", kManual};
  c.max_macro_digits = {4, kTA + "27, format 1 (2)", kManual};
  c.argument_sets = {ArgumentSets::PerLetter, kTA + "27, example J12 K22 J25 I33 J32", kManual};
  c.numbered_axis_arguments = {true, kTA + "27, arguments I", kManual};
  c.call_passes_words = {false, kTA + "27: only G65 and G66 pass arguments", kManual};
  c.words_before_macro_call = {WordsBeforeMacroCall::Alarm, kTA + "27, note 3", kManual};
  c.repeated_argument = {RepeatedAddress::LastWins, kTA + "27, note 1: 3403#6 AD2 = 0", kManual};
  c.modal_locals = {ModalLocals::Rewritten, kTA + "27, example of G66", kManual};
  c.modal_trigger = {ModalTrigger::Move, kTA + "27, G66, note 3 and example", kManual};
  c.modal_calls_stack = {true, kTA + "27, note 2: G66 counts to the four levels", kManual};
  c.max_modal_calls = {4, kTA + "27, note 2: G66 counts to the four levels", kManual};
  c.cancel_alone = {CancelAlone::Alarm, kTApar + "6000#0 G67 = 0; Talm 218", kManual};
  c.h_codes = {false, kTApar + "6000#7 EMA = 0", kManual};
  c.code_cascade = {CodeCascade::All,
                    "inferred from TA27, M, T and G calls, note 4: only the four levels",
                    kInferred};
  c.user_alarm_offset = {3000, kGeneral, kInferred};
  c.user_alarm_last = {200, kGeneral, kInferred};
  c.h99_offset = {500, kGeneral + ", as on the older GSK lathes", kInferred};
  c.user_alarm_digits = 4;
}

/// The list of the 988T. No list of the 988TA was found; its numbers up to 289 are those of the
/// 988T.
void alarms_988(Control& c) {
  const auto add = [&c](Cause cause, const std::string& number, const std::string& text) {
    c.alarms[cause] = {number, text, kTalm + number, kManual};
  };
  const std::string range = "value out of range, or more than 8 digits";
  const std::string missing = "program number not found";
  const std::string above = "call of an upper program or of itself";
  const std::string command = "wrong command in a macro";
  const std::string formula = "format of a formula";
  add(Cause::AddressWithoutValue, "005", "no data behind the address");
  add(Cause::ValueWithoutAddress, "004", "block starts without an address");
  add(Cause::IllegalMinusSign, "006", "minus sign misused");
  add(Cause::IllegalDecimalPoint, "007", "decimal point misused");
  add(Cause::TooManyDigits, "003", range);
  add(Cause::ValueOutOfRange, "003", range);
  add(Cause::IllegalSequenceNumber, "003", range);
  add(Cause::IllegalRepeatCount, "003", range);
  add(Cause::RepeatCountDigits, "003", range);
  add(Cause::AddressNotUsable, "008", "illegal address");
  add(Cause::AddressGivenTwice, "010", "same address or G code of one group twice");
  add(Cause::BlockTooLong, "002", "block longer than 256 characters");
  add(Cause::GCodeNotAvailable, "009", "illegal G code");
  add(Cause::IllegalMCombination, "012", "too many M codes");
  add(Cause::ProgramNumberMissing, "081", "address P not defined");
  add(Cause::ProgramNotFound, "083", missing);
  add(Cause::NamedProgramNotFound, "083", missing);
  add(Cause::ExternalProgramNotFound, "083", missing);
  add(Cause::StartNotFound, "083", missing);
  add(Cause::ReturnTargetNotFound, "083", missing);
  add(Cause::NestingTooDeep, "082", "more than 12 levels of subprograms");
  add(Cause::MacroNestingTooDeep, "207", "more than 4 levels of macro calls");
  add(Cause::ProgramCallsItself, "084", above);
  add(Cause::ProgramCallsCaller, "084", above);
  add(Cause::CallInMdi, "085", "call not allowed in MDI and DNC");
  add(Cause::MacroCallNotFirst, "212", "NC and macro call in one block");
  add(Cause::CodeWithMacroCall, "212", "NC and macro call in one block");
  add(Cause::CodeWithModalCall, "212", "NC and macro call in one block");
  add(Cause::ModalCallsTooMany, "207", "more than 4 levels of macro calls");
  add(Cause::CallInModalCall, "204", "M98, G65 or G66 in G66 mode");
  add(Cause::IllegalWordWithReturn, "030", "G28, G30, G53, G36, G37 with M99");
  add(Cause::EndOfRecord, "019", "% reached, or no program end");
  add(Cause::NcAndMacroInBlock, "212", "NC code and macro call in one block");
  add(Cause::StatementFormat, "201", command);
  add(Cause::StatementNotAvailable, "201", command);
  add(Cause::IfFormat, "201", command);
  add(Cause::WhileFormat, "201", command);
  add(Cause::ExpressionFormat, "202", formula);
  add(Cause::MissingEquals, "202", formula);
  add(Cause::MissingComma, "202", formula);
  add(Cause::BracketNotOpened, "202", formula);
  add(Cause::BracketNotClosed, "202", formula);
  add(Cause::BracketsTooDeep, "205", "more than 5 brackets");
  add(Cause::IllegalVariable, "203", "illegal variable number");
  add(Cause::VacantAssigned, "210", "no permission to assign");
  add(Cause::VariableWriteProtected, "220", "variable is read only");
  add(Cause::IllegalVariableValue, "216", "illegal variable value");
  add(Cause::DivisionByZero, "014", "division by zero");
  add(Cause::TangentInfinite, "014", "division by zero");
  add(Cause::SquareRootOfNegative, "206", "SQRT of a negative value, or argument of BIN, BCD");
  add(Cause::ArgumentOutOfRange, "206", "SQRT of a negative value, or argument of BIN, BCD");
  add(Cause::LogicOfNegative, "217", "OR, XOR, AND of a negative value");
  add(Cause::Overflow, "221", "overflow");
  add(Cause::JumpTargetNotFound, "213", "sequence number not 1 to 99999, or not found");
  add(Cause::IllegalJumpNumber, "213", "sequence number not 1 to 99999, or not found");
  add(Cause::IllegalLoopNumber, "211", "DO number is not 1 to 3");
  add(Cause::MissingEnd, "209", "DO and END not paired, or jump into a loop");
  add(Cause::MissingDo, "209", "DO and END not paired, or jump into a loop");
  add(Cause::JumpInMdi, "208", "macro branch in DNC or MDI");
  add(Cause::IllegalArgument, "214", "illegal argument address");
  add(Cause::ModalCallMissing, "218", "G67 without G66");
  add(Cause::CodeMayNotCall, "222", "M code may not call a macro");
}

void variables_988(Control& c) {
  const auto add = [&c](std::int32_t first, std::int32_t last, VariableKind kind,
                        Access access = Access::ReadOnly) {
    c.variables.push_back({first, last, kind, access, 0, kGeneral, kInferred});
  };
  add(0, 0, VariableKind::Vacant);
  c.variables.push_back(
      {1, 33, VariableKind::Local, Access::ReadWrite, 0, kTA + "27, arguments", kManual});
  c.commons = {"100-199 500-999", kTApar + "6001#6 and 6031", kManual};
  c.variable_options = {"", kPolicy, kInferred};
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
  modal_words(c, "BDEFHMNOST", kGeneral, kInferred);
  add(5001, 5008, VariableKind::BlockEnd);
  add(5021, 5028, VariableKind::MachinePosition);
  add(5041, 5048, VariableKind::WorkPosition);
  c.variables.push_back({5061, 5068, VariableKind::SkipPosition, Access::ReadOnly, 0,
                         kTApar + "6003#1 names #5061", kManual});
  add(5201, 5328, VariableKind::WorkOffset, Access::ReadWrite);
}

void parameters_988(Control& c) {
  c.parameters = {
      {"3401#0", 1, "lengths without a point: 0 least increments, 1 millimetres",
       "inferred from the examples of TA28; TApar has no such bit, " + kStands, kInferred,
       [](Control& k, double value) {
         k.whole_numbers.value = value != 0 ? WholeNumbers::Millimetres : WholeNumbers::Increments;
       }},
      {"3401#1", 0, "CPQ, unit of P and Q of cycles: 0 millimetres, 1 least increments",
       kTApar + "3401#1", kManual, nullptr},
      {"3401#6", 0, "GSB, G code system: 0 A, 1 B", kTApar + "3401#6", kManual, nullptr},
      {"3402#0", 0, "G01, power-on: 0 in G00, 1 in G01", kTApar + "3402#0", kManual, nullptr},
      {"3402#3", 0, "G91, power-on: 0 in G90, 1 in G91", kTApar + "3402#3", kManual, nullptr},
      {"3402#4", 0, "FPM, power-on: 0 feed per revolution, 1 per minute", kTApar + "3402#4",
       kManual, nullptr},
      {"3402#6", 0, "CLR, M30 and reset: 0 keep the modal codes, 1 go to the power-on state",
       kTApar + "3402#6", kManual, nullptr},
      {"3403#4", 0, "RER, radius too small for the end point: 0 a half circle, 1 an alarm",
       kTApar + "3403#4", kManual, nullptr},
      {"3403#5", 0, "CIR, an arc without R, I, J, K: 0 a straight line, 1 an alarm",
       kTApar + "3403#5", kManual, nullptr},
      {"3403#6", 0, "AD2, an address or a G group twice in a block: 0 the last counts, 1 an alarm",
       kTApar + "3403#6", kManual,
       [](Control& k, double value) {
         const RepeatedAddress rule =
             value != 0 ? RepeatedAddress::Alarm : RepeatedAddress::LastWins;
         k.repeated_address.value = rule;
         k.repeated_argument.value = rule;
       }},
      {"3404#6", 0, "EOR, a program without its end: 0 an alarm, 1 none", kTApar + "3404#6",
       kManual,
       [](Control& k, double value) {
         k.missing_end.value = value != 0 ? MissingEnd::Ends : MissingEnd::Alarm;
       }},
      {"3404#7", 0, "M3B, M codes in a block: 0 one, 1 three", kTApar + "3404#7", kManual,
       [](Control& k, double value) { k.m_codes_per_block.value = value != 0 ? 3 : 1; }},
      {"3410", 0, "how far the radii of an arc's start and end may differ, 0 = any",
       kTApar + "3410", kManual, nullptr},
      {"5101#2", 0, "RTR, G83 and G87: 0 short retract, 1 full retract", kTApar + "5101#2", kManual,
       nullptr},
      {"5102#1", 0, "MRC, G71 to G73: 1 checks that the profile is monotone", kTApar + "5102#1",
       kManual, nullptr},
      {"5114", 0, "return of the fast peck cycle", kTApar + "5114", kManual, nullptr},
      {"5115", 0, "clearance of the peck cycle", kTApar + "5115", kManual, nullptr},
      {"5130", 0, "thread run-out, tenths of the lead", kTApar + "5130", kManual, nullptr},
      {"5132", 0, "depth of cut of G71 and G72", kTApar + "5132", kManual, nullptr},
      {"5133", 0, "retract of G71 and G72", kTApar + "5133", kManual, nullptr},
      {"6000#0", 0, "G67 without G66: 0 an alarm, 1 ignored", kTApar + "6000#0", kManual,
       [](Control& k, double value) {
         k.cancel_alone.value = value != 0 ? CancelAlone::Ignored : CancelAlone::Alarm;
       }},
      {"6000#7", 0, "EMA, G65: 0 calls a macro, 1 is type A, G65 H", kTApar + "6000#7", kManual,
       [](Control& k, double value) { k.h_codes.value = value != 0; }},
      {"6001#6", 0, "CCV, #100 to #199 at reset: 0 cleared, 1 kept", kTApar + "6001#6", kManual,
       [](Control& k, double value) { k.reset_clears_commons.value = value == 0; }},
      {"6001#7", 0, "CLV, #1 to #33 at reset: 0 cleared, 1 kept", kTApar + "6001#7", kManual,
       [](Control& k, double value) { k.reset_clears_locals.value = value == 0; }},
      {"6004#0", 0,
       "NAT, ATAN and ASIN: 0 gives 0 to 360 and 270 to 90, 1 -180 to 180 and -90 to 90",
       kTApar + "6004#0", kManual,
       [](Control& k, double value) {
         const AngleRange range = value != 0 ? AngleRange::Signed : AngleRange::FullTurn;
         k.atan_range.value = range;
         k.asin_range.value = range;
       }},
      {"6008#5", 0, "TMP: 1 lets T codes call macros", kTApar + "6008#5", kManual, nullptr},
      {"6008#6", 0, "MMP: 1 lets M codes call macros", kTApar + "6008#6", kManual, nullptr},
      {"6008#7", 0, "GMP: 1 lets G codes call macros", kTApar + "6008#7", kManual, nullptr},
  };
}

/// Ten codes each of T, M and G that call a macro.
void code_calls_988(Control& c) {
  const auto list = [&c](char address, std::int32_t parameter, std::int32_t program,
                         const std::string& enable, std::int32_t first_code, std::int32_t last_code,
                         const std::string& refused) {
    for (std::int32_t i = 0; i < 10; ++i) {
      const std::string number = std::to_string(parameter + i);
      c.parameters.push_back(
          {number, 0, std::string(1, address) + " code that calls O" + std::to_string(program + i),
           kTApar + number, kManual, nullptr});
    }
    CodeCall call =
        code_call(CodeCall::Form::List, address, CodeCallKind::Macro, parameter, program, 10);
    call.enable = enable;
    call.first_code = first_code;
    call.last_code = last_code;
    call.refused = refused;
    call.source = kTA + "27, M, T and G codes";
    call.evidence = kManual;
    c.code_calls.push_back(call);
  };
  list('T', 6060, 9010, "6008#5", 1, 9999, "");
  list('M', 6080, 9020, "6008#6", 3, 9999, "30 98 99 198");
  list('G', 6090, 9030, "6008#7", 500, 599, "");
}

Control gsk_988ta() {
  Control c;
  c.name = "gsk-988ta";
  c.title = "GSK 988TA lathe";
  read_988(c);
  call_988(c);
  statements_988(c);
  macros_988(c);
  alarms_988(c);
  c.alarms[Cause::IllegalProgramNumber] = {"291", "P[#] has more than 4 digits",
                                           k000 + "word P, format 2 (1)", kDocument};
  c.alarms[Cause::IllegalMacroNumber] = {"291", "P[#] has more than 4 digits", "TA27", kManual};
  c.alarms[Cause::RepeatGivenTwice] = {"293", "count given in P and in L",
                                       k000 + "words L and Q (3)", kDocument};
  variables_988(c);
  parameters_988(c);
  code_calls_988(c);
  return c;
}

/// Like the 988TA, but no call in MDI, none of an open program, and no M98 without P.
Control gsk_988t() {
  Control c = gsk_988ta();
  c.name = "gsk-988t";
  c.title = "GSK 988T lathe";
  c.omitted_program = {OmittedProgram::Alarm, kTalm + "081", kManual};
  c.self_call = {SelfCall::Refused, kTalm + "084", kManual};
  c.caller_call = {CallerCall::Refused, kTalm + "084", kManual};
  c.mdi_calls = {MdiCalls::Refused, kTalm + "085", kManual};
  c.max_nesting = {12, kTalm + "082", kManual};
  c.max_macro_nesting = {4, kTalm + "207", kManual};
  c.calls_in_modal = {CallsInModal::Refused, kTalm + "204", kManual};
  c.alarms.erase(Cause::IllegalProgramNumber);
  c.alarms.erase(Cause::RepeatGivenTwice);
  return c;
}

// ---- 980TDi and 980MDi ----

const std::string kTDiCodes =
    "0 1 2 3 4 5 5.1 6.2 6.3 7.1 7.2 7.3 10 11 12.1 13.1 17 18 19 20 21 22 23 "
    "28 30 31 32 32.1 32.2 32.3 33 34 36 37 40 41 42 50 50.2 51.2 52 53 "
    "54 55 56 57 58 59 65 66 67 70 71 72 73 74 74.1 75 75.1 76 78 80 83 83.1 83.2 "
    "84 84.1 84.2 86 87 87.1 88 88.1 90 92 92.1 92.3 94 96 97 98 99";

// G111 is a code of this control too, but it serves as the unknown code of the motion cases.
const std::string kMDiCodes =
    "0 1 2 3 4 7.1 9 10 11 15 16 17 18 19 20 21 28 29 30 31 37 40 41 42 43 44 49 "
    "50 50.1 51 51.1 52 53 54 54.1 55 56 57 58 59 61 62 63 64 65 66 67 68 69 "
    "73 74 76 80 81 82 83 84 85 86 87 88 89 90 91 92 94 95 96 97 98 99 107 "
    "110 112 113 114 115 116 117 126 127 132 133 134 135 136 137 138 139 140 141 142 143 144";

void read_980(Control& c) {
  c.semicolon = {Semicolon::EndOfBlock, kTDi + "15 1.1.1: a block ends with ;", kManual};
  c.percent_programs = {false, kTDi + "15 1.1.1: O and four digits, or a name", kManual};
  c.named_programs = {false, kTDi + "15 1.1.1: a name is the name of a file", kManual};
  c.file_name_wins = {false, kPolicy + ": an O word in the file names the program", kInferred};
  c.max_program_number = {9999, kTDi + "15 1.1.1", kManual};
  c.max_sequence_number = {99999, kMDib + "0112: 0 to 99999", kManual};
  c.zero_numbers = {false, kMDia + "095: O0000 cannot be called", kManual};
  c.sequence_number_first = {true, kMDia + "006", kManual};
  c.cuts_fine_digits = {false, kPolicy, kInferred};
  c.late_sequence_numbers = {true, kPolicy, kInferred};
  c.max_words = {100, kMDia + "011", kManual};
  c.max_block_length = {256, kMDia + "037", kManual};
  c.max_digits = {10, kMDia + "003: a word has at most 11 characters", kManual};
  c.block_skip = {BlockSkip::HeadOnly, kGeneral, kInferred};
  c.repeated_address = {RepeatedAddress::Alarm, kMDia + "010", kManual};
  c.open_comment = {OpenComment::Alarm, kMDia + "041", kManual};
  c.point_addresses = {"ABCDEFHIJKLQRUVWXYZ",
                       kTDi + "11: L and D are lengths; the others from general knowledge",
                       kInferred};
  c.minus_addresses = {
      "ABCDEFHIJKLPQRSUVWXYZ",
      kTDi + "14: a negative time is none; MDib 0140: a negative scale; MDib 0092: L", kManual};
  c.whole_numbers = {WholeNumbers::Millimetres, "inferred from the examples of the manual",
                     kInferred};
  c.missing_end = {MissingEnd::Alarm, kPolicy, kInferred};
  c.m_codes_per_block = {1, kGeneral, kInferred};
  c.m_codes_alarm = {false, kGeneral, kInferred};
  c.m_codes_alone = {false, kPolicy, kInferred};
  c.bare_g = {false, kMDia + "003: a word has at least two characters", kManual};
  c.g_codes = {kTDiCodes, kTDi + "2 to TDi37, titles", kManual};
}

void call_980(Control& c) {
  c.name_marks = {"+-.", kTDi + "15", kManual};
  c.return_alone_in_modal = {false, kPolicy, kInferred};
  c.program_word = {ProgramWord::CountAndNumber, kTDi + "15 1.1.7, format 1", kManual};
  c.max_program_digits = {10, "inferred from MDib 0092: a count above 9999 is read, and alarms",
                          kInferred};
  c.count_and_l = {CountAndL::NoL, kTDi + "15 1.1.7: L goes with P[] only", kManual};
  c.bracket_names = {true, kTDi + "15 1.1.7, format 2: 878 = 1", kManual};
  c.wide_names = {true, kTDi + "15 1.1.1: names may be Chinese", kManual};
  c.max_name_length = {20, kTDi + "15 1.1.1", kManual};
  c.call_values = {CallValues::Cut, kPolicy + "; as on the 988TA", kInferred};
  c.zero_count_alarms = {true, "inferred from MDib 0092: a count less than 1", kInferred};
  c.omitted_program = {OmittedProgram::Alarm, kMDia + "095", kManual};
  c.start_word = {StartWord::None, kTDi + "15 1.1.7 has no Q", kManual};
  c.self_call = {SelfCall::Refused, kMDia + "097", kManual};
  c.caller_call = {CallerCall::MainRefused, kMDia + "094", kManual};
  c.max_repeats = {9999, kTDi + "15 1.1.7", kManual};
  c.zero_repeats = {ZeroRepeats::Alarm, kMDib + "0092: less than 1", kManual};
  c.too_many_repeats = {TooManyRepeats::Alarm, kMDib + "0092: more than 9999", kManual};
  c.max_nesting = {4, kMDia + "096", kManual};
  c.nesting_counts_macros = {false, kPolicy, kInferred};
  c.max_macro_nesting = {4, kTDi + "28 3.28.3.1: four levels", kManual};
  c.max_total_nesting = {0, kPolicy, kInferred};
  c.mdi_calls = {MdiCalls::Refused, kGeneral + "; MDib 0098 refuses M9000 to M9999", kInferred};
  c.external_calls = {false, kGeneral, kInferred};
  c.device_word = {false, kGeneral, kInferred};
  c.return_search = {ReturnSearch::FromHead, kPolicy, kInferred};
  c.return_with_p = {ReturnWithP::AtOnce, kPolicy, kInferred};
  c.return_with_l = {ReturnWithL::Ignored, kPolicy, kInferred};
  c.main_return = {MainReturn::Restarts, kGeneral, kInferred};
  c.jump_m97 = {false, kGeneral, kInferred};
  c.restart_m_code = {0, kGeneral, kInferred};
  c.calls_in_modal = {CallsInModal::EndModal, kTDi + "28 3.28.3.2, note 4; MDia 113", kManual};
  c.codes_not_with_return = {"", kPolicy, kInferred};
  c.codes_not_with_call = {"4 54 54.1", kMDib + "0051", kManual};
  c.words_with_call_in_cycle = {true, kPolicy, kInferred};
}

void statements_980(Control& c) {
  c.reset_clears_locals = {true, kPolicy, kInferred};
  c.reset_clears_commons = {false, kPolicy, kInferred};
  c.vacant_system_writes = {false, kMDia + "121", kManual};
  c.max_constant_digits = {12, kPolicy, kInferred};
  c.max_condition_length = {0, kPolicy, kInferred};
  c.statements = {"# [ IF WHILE DO DPRNT? BPRNT? POPEN? PCLOS?", kTDi + "29 3.29.2", kManual};
  c.if_form = {IfForm::GotoThen, kTDi + "29 3.29.2 (2)", kManual};
  c.loop_form = {LoopForm::DoEnd, kTDi + "29 3.29.2 (3)", kManual};
  c.jumps = {true, kTDi + "29 3.29.2 (1)", kManual};
  c.jumps_in_mdi = {false, kPolicy, kInferred};
  c.jump_search = {JumpSearch::ForwardThenHead, kGeneral, kInferred};
  c.max_jump_number = {99999, kTDi + "29 3.29.2 (1)", kManual};
  c.max_loop_number = {3, kTDi + "29 3.29.2 (3)", kManual};
  c.max_loops = {3, "inferred from TDi29: three numbers", kInferred};
  c.loops_count_across_calls = {false, kGeneral, kInferred};
  c.max_ifs = {10, kPolicy + "; without effect where IF has no blocks", kInferred};
  c.max_brackets = {5, kGeneral, kInferred};
  c.angle_unit = {AngleUnit::Degrees, kTDi + "29, note 1", kManual};
  c.atan_range = {AngleRange::FullTurn, kTDi + "29, note 4: 180#7 NAT = 0", kManual};
  c.asin_range = {AngleRange::Signed, kTDi + "29, note 2: 180#7 NAT = 0", kManual};
  c.joined_conditions = {false, kTDi + "29: a condition compares two values", kManual};
  c.comparison_symbols = {true, kTDi + "29, conditions", kManual};
  c.conditions_without_brackets = {false, kTDi + "29, conditions", kManual};
  c.short_functions = {false, kTDi + "29, table of functions", kManual};
  c.functions = {"SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP BIN BCD RAND SRAND",
                 kTDi + "29, table of functions", kManual};
  c.modulo = {false, kTDi + "29, table of functions", kManual};
  c.vacant_address = {VacantAddress::Zero, kTDi + "28, vacant variables (1)", kManual};
  c.vacant_comparison = {VacantComparison::Zero, kTDi + "28, vacant variables (3)", kManual};
  c.variable_point = {false, kPolicy, kInferred};
  c.indirect_9nnn = {true, kTDi + "28, variables (2)", kManual};
  c.negative_logic = {true, kPolicy, kInferred};
  c.variable_names = {false, kPolicy, kInferred};
  c.logic_binds_last = {false, kGeneral, kInferred};
}

void macros_980(Control& c) {
  c.codes_not_with_macro_call = {"43 44 49", kMDib + "115", kManual};
  c.m_codes_not_with_macro_call = {"0 1 2 30 98 99", kMDib + "116", kManual};
  c.codes_not_with_modal_call = {
      "0 1 2 3 4 5 6.2 6.3 7.2 7.3 28 30 31 32 33 34 36 37 50 52 53 70 71 72 73 74 75 76 84 88 90 "
      "92 94",
      kMDia + "044", kManual};
  c.macro_calls = {true, kTDi + "28 3.28.3", kManual};
  c.modal_every_block = {false, kTDi + "28 3.28.3 names G65, G66 and G67", kManual};
  c.max_macro_digits = {4, kTDi + "28 3.28.3.1: at most four digits", kManual};
  c.argument_sets = {ArgumentSets::PerLetter, kTDi + "28 3.28.3.1, example of O9010", kManual};
  c.numbered_axis_arguments = {false, kTDi + "28 3.28.3.1, arguments I", kManual};
  c.call_passes_words = {false, kTDi + "28 3.28.3 (1): M98 passes nothing", kManual};
  c.words_before_macro_call = {WordsBeforeMacroCall::Alarm, kTDi + "28 3.28.3 (3); MDia 114",
                               kManual};
  c.repeated_argument = {RepeatedAddress::LastWins, kTDi + "28 3.28.3.1: the last counts", kManual};
  c.modal_locals = {ModalLocals::Rewritten, kTDi + "28 3.28.3.2, note 3", kManual};
  c.modal_trigger = {ModalTrigger::AxisWord,
                     kTDi + "28 3.28.3.2, note 2: blocks with G00, G01, G02, G03, G05", kManual};
  c.modal_calls_stack = {true, kTDi + "28 3.28.3.2: four levels of G66", kManual};
  c.max_modal_calls = {4, kTDi + "28 3.28.3.2: four levels of G66", kManual};
  c.cancel_alone = {CancelAlone::Ignored, kPolicy, kInferred};
  c.h_codes = {true, kTDi + "28 3.28.2", kManual};
  c.code_cascade = {CodeCascade::None, kPolicy, kInferred};
  c.user_alarm_offset = {5900, kTDi + "28, #3000", kManual};
  c.user_alarm_last = {99, kTDi + "28, #3000: 5900 to 5999", kManual};
  c.h99_offset = {5900, kTDi + "28, G65 H99", kManual};
  c.user_alarm_digits = 4;
}

/// The list of the 980MDi; none of the 980TDi was found.
void alarms_980(Control& c) {
  const auto add = [&c](Cause cause, const std::string& number, const std::string& text) {
    c.alarms[cause] = {number, text, kMDia + number, kManual};
  };
  const std::string length = "word has too few or too many characters";
  const std::string value = "value illegal or out of range";
  const std::string number = "O0000, no program number, or an illegal one";
  const std::string target = "sequence number of GOTO or M99 missing or out of range";
  const std::string format = "format of a macro statement";
  const std::string loop = "format of DO and END, or jump into a loop";
  const std::string brackets = "brackets not paired, or wrong format";
  add(Cause::AddressWithoutValue, "0003", length);
  add(Cause::TooManyDigits, "0003", length);
  add(Cause::IllegalMinusSign, "0012", value);
  add(Cause::IllegalDecimalPoint, "0012", value);
  add(Cause::ValueOutOfRange, "0012", value);
  add(Cause::AddressGivenTwice, "0010", "same address twice in a block");
  add(Cause::TooManyWords, "0011", "more than 100 words in a block");
  add(Cause::BlockTooLong, "0037", "block longer than 256 characters");
  add(Cause::CommentNotClosed, "0041", "format of a comment, brackets not paired");
  add(Cause::SequenceNumberNotFirst, "0006",
      "sequence number not at the head of the block, or out of range");
  add(Cause::IllegalSequenceNumber, "0006",
      "sequence number not at the head of the block, or out of range");
  add(Cause::ProgramNumberZero, "0095", number);
  add(Cause::ProgramNumberMissing, "0095", number);
  add(Cause::IllegalProgramNumber, "0095", number);
  add(Cause::IllegalProgramName, "0095", number);
  add(Cause::ProgramNotFound, "0001", "called program does not exist or cannot be opened");
  add(Cause::NamedProgramNotFound, "0001", "called program does not exist or cannot be opened");
  add(Cause::ReturnTargetNotFound, "0112", target);
  add(Cause::JumpTargetNotFound, "0112", target);
  add(Cause::IllegalJumpNumber, "0112", target);
  add(Cause::IllegalRepeatCount, "0092", "wrong count of a subprogram call");
  add(Cause::RepeatCountDigits, "0092", "wrong count of a subprogram call");
  add(Cause::NestingTooDeep, "0096", "more than 4 levels of subprograms");
  add(Cause::MacroNestingTooDeep, "0096", "more than 4 levels of subprograms");
  add(Cause::ProgramCallsItself, "0097", "called program is the current program");
  add(Cause::ProgramCallsCaller, "0094", "subprogram calls the main program");
  add(Cause::MacroCallNotFirst, "0114", "G65 or G66 is not the first word");
  add(Cause::CodeWithMacroCall, "0115", "G65 with G43, G44 or G49");
  add(Cause::MCodeWithMacroCall, "0116", "G65 with M00, M01, M02, M30, M98 or M99");
  add(Cause::CodeWithModalCall, "0044", "G66 with a G code of group 00 or 01");
  add(Cause::IllegalMacroNumber, "0119", "P of a macro call out of range");
  add(Cause::CallInModalCall, "0113", "M98 or M99 P in G66 mode");
  add(Cause::NcAndMacroInBlock, "0114", "G65 or G66 not at the head of the block");
  add(Cause::StatementFormat, "0101", format);
  add(Cause::StatementNotAvailable, "0101", format);
  add(Cause::ExpressionFormat, "0101", format);
  add(Cause::MissingEquals, "0101", format);
  add(Cause::MissingComma, "0101", format);
  add(Cause::IfFormat, "0101", format);
  add(Cause::WhileFormat, "0101", format);
  add(Cause::BracketNotOpened, "0104", brackets);
  add(Cause::BracketNotClosed, "0104", brackets);
  add(Cause::BracketsTooDeep, "0104", brackets);
  add(Cause::IllegalVariable, "0111", "variable does not exist");
  add(Cause::VariableWriteProtected, "0120", "variable is read only");
  add(Cause::VacantAssigned, "0117", "#0 cannot take a result");
  add(Cause::IllegalVariableValue, "0121", "a system variable cannot be made vacant");
  add(Cause::DivisionByZero, "0105", "division by zero");
  add(Cause::SquareRootOfNegative, "0108", "square root of a negative value");
  add(Cause::LogarithmOfNonPositive, "0107", "LN of zero or of a negative value");
  add(Cause::TangentInfinite, "0109", "tangent is infinite");
  add(Cause::ArcSineOutOfRange, "0110", "ASIN or ACOS outside -1 to 1");
  add(Cause::ArgumentOutOfRange, "0127", "not a whole number, cannot be made binary");
  add(Cause::Overflow, "0043", "overflow");
  add(Cause::LogicOfBits, "0133", "operand or result of AND, OR, XOR is neither 0 nor 1");
  add(Cause::IllegalLoopNumber, "0102", "DO or END number is not 1, 2, 3");
  add(Cause::MissingEnd, "0103", loop);
  add(Cause::MissingDo, "0103", loop);
  add(Cause::TooManyArgumentSets, "0118", "more than 10 of I, J or K");
  add(Cause::HCodeMissing, "0122", "no P in G65 or G66, or no H in G65");
  add(Cause::HCodeFormat, "0123", "format of G65 H");
  add(Cause::IllegalHCode, "0124", "illegal H code");
  add(Cause::HCodeOperand, "0125", "wrong count of operands");
  add(Cause::IllegalUserAlarm, "0126", "alarm number outside 0 to 99");
  c.alarms[Cause::GCodeNotAvailable] = {"0002", "illegal G code", kMDib + "0002", kManual};
  c.alarms[Cause::IllegalWordWithCall] = {"0051", "G04, G54 or G54.1 with M98", kMDib + "0051",
                                          kManual};
}

void variables_980(Control& c) {
  const std::string table = kTDi + "28, variables";
  const auto add = [&](std::int32_t first, std::int32_t last, VariableKind kind,
                       Access access = Access::ReadOnly, const std::string& note = "") {
    c.variables.push_back({first, last, kind, access, 0, table + note, kManual});
  };
  const std::string stored = ": an offset of the lathe, a stored number here";
  add(0, 0, VariableKind::Vacant);
  add(1, 33, VariableKind::Local, Access::ReadWrite);
  // The manual's example of #9100 uses #205.
  c.commons = {"100-999", table, kManual};
  c.variable_options = {"", kPolicy, kInferred};
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
  modal_words(c, "FMNOST", table, kManual);
  add(5001, 5005, VariableKind::BlockEnd);
  add(5021, 5025, VariableKind::MachinePosition);
  add(5041, 5045, VariableKind::WorkPosition);
  add(5201, 5325, VariableKind::WorkOffset);
}

void parameters_980(Control& c) {
  c.parameters = {
      {"001#0", 0, "input unit: 0 millimetres, 1 inches", kTDipar + "1", kManual, nullptr},
      {"86", 0, "how many G codes call macros, 0 = none", kTDi + "32", kManual, nullptr},
      {"87", 0, "the first G code that calls a macro", kTDi + "32", kManual, nullptr},
      {"88", 0, "the program that the first G code calls", kTDi + "32", kManual, nullptr},
      {"89", 0, "the first M code that calls a subprogram", kTDi + "17", kManual, nullptr},
      {"90", 0, "the program that the first M code calls", kTDi + "17", kManual, nullptr},
      {"91", 0, "how many M codes call subprograms, 0 = none", kTDi + "17", kManual, nullptr},
      {"180#7", 0, "ATAN and ASIN: 0 gives 0 to 360 and -90 to 90, 1 -180 to 180 and 90 to 270",
       kTDi + "29, notes 2 and 4", kManual,
       [](Control& k, double value) {
         k.atan_range.value = value != 0 ? AngleRange::Signed : AngleRange::FullTurn;
         k.asin_range.value = value != 0 ? AngleRange::FullTurn : AngleRange::Signed;
       }},
      {"878", 1, "program names of any kind: 0 no, 1 yes",
       kTDi + "15 1.1.2; set here, so that P[name] works", kManual,
       [](Control& k, double value) { k.bracket_names.value = value != 0; }},
      {"3401#0", 1, "lengths without a point: 0 least increments, 1 millimetres",
       "inferred from the examples of the manual; " + kStands, kInferred,
       [](Control& k, double value) {
         k.whole_numbers.value = value != 0 ? WholeNumbers::Millimetres : WholeNumbers::Increments;
       }},
      {"3402#0", 0, "power-on: 0 in G00, 1 in G01", kTDi + "2: G00; " + kStands, kInferred,
       nullptr},
      {"3403#4", 1, "radius too small for the end point: 0 a half circle, 1 an alarm",
       kTDi + "4, note 3; " + kStands, kInferred, nullptr},
      {"3403#5", 1, "an arc without R, I, K: 0 a straight line, 1 an alarm",
       kTDi + "4, note 1; " + kStands, kInferred, nullptr},
      {"3410", 0, "how far the radii of an arc's start and end may differ, 0 = any",
       kTDipar + "154 in its place; " + kStands, kInferred, nullptr},
      {"5114", 0, "return of the fast peck cycle", kStands, kInferred, nullptr},
      {"5115", 0, "clearance of the peck cycle", kStands, kInferred, nullptr},
  };
}

Control gsk_980tdi() {
  Control c;
  c.name = "gsk-980tdi";
  c.title = "GSK 980TDi lathe";
  read_980(c);
  call_980(c);
  statements_980(c);
  macros_980(c);
  alarms_980(c);
  variables_980(c);
  parameters_980(c);
  CodeCall macro = code_call(CodeCall::Form::Range, 'G', CodeCallKind::Macro, 87, 88, 86);
  macro.own_codes = false;
  macro.last_code = 9999;
  macro.source = kTDi + "32";
  macro.evidence = kManual;
  CodeCall subprogram = code_call(CodeCall::Form::Range, 'M', CodeCallKind::Subprogram, 89, 90, 91);
  subprogram.first_code = 3;
  subprogram.last_code = 8999;
  subprogram.source = kTDi + "17";
  subprogram.evidence = kManual;
  c.code_calls = {macro, subprogram};
  return c;
}

/// The mill: no names, M-code calls at 6044, the length offsets of a mill, G codes of a mill.
Control gsk_980mdi() {
  Control c = gsk_980tdi();
  c.name = "gsk-980mdi";
  c.title = "GSK 980MDi mill";
  c.logic_of_bits = {true, kMDib + "0133", kManual};
  for (const int group : {3, 4, 8, 9, 10, 11, 13, 15})
    c.variables.push_back({4000 + group, 4000 + group, VariableKind::ModalCode, Access::ReadOnly, 0,
                           kGeneral, kInferred});
  modal_words(c, "BDH", kGeneral, kInferred);
  c.bracket_names = {false, kGeneral, kInferred};
  c.wide_names = {false, kGeneral, kInferred};
  c.count_and_l = {CountAndL::NoL, kGeneral, kInferred};
  c.g_codes = {kMDiCodes, kMDib + "names them; motion codes from general knowledge", kInferred};
  c.point_addresses = {
      "ABCDEFHIJKLQRUVWXYZ",
      kMDia + "093: L and U are lengths of a chamfer; the others from general knowledge",
      kInferred};
  c.atan_range = {AngleRange::FullTurn, kMDipar + "520#7 = 0", kManual};
  c.asin_range = {AngleRange::FullTurn, kMDipar + "520#7 = 0", kManual};
  std::vector<Parameter> kept;
  for (const Parameter& p : c.parameters) {
    const bool of_lathe = p.name == "89" || p.name == "90" || p.name == "91" || p.name == "180#7" ||
                          p.name == "878" || p.name == "001#0" || p.name == "3410";
    if (!of_lathe) kept.push_back(p);
  }
  c.parameters = std::move(kept);
  c.parameters.push_back(
      {"520#7", 0, "ATAN and ASIN: 0 gives 0 to 360 and 90 to 270, 1 -180 to 180 and -90 to 90",
       kMDipar + "520#7", kManual, [](Control& k, double value) {
         const AngleRange range = value != 0 ? AngleRange::Signed : AngleRange::FullTurn;
         k.atan_range.value = range;
         k.asin_range.value = range;
       }});
  c.parameters.push_back(
      {"027", 0, "the largest cutting feed, 0 = any", kMDib + "0023", kManual, nullptr});
  c.parameters.push_back({"3410", 0,
                          "how far the radii of an arc's start and end may differ, 0 = any",
                          kMDipar + "3410", kManual, nullptr});
  c.parameters.push_back(
      {"6044", 0, "the first M code that calls a subprogram", kMDipar + "6044", kManual, nullptr});
  c.parameters.push_back(
      {"6045", 0, "the program that the first M code calls", kMDipar + "6045", kManual, nullptr});
  c.parameters.push_back({"6046", 0, "how many M codes call subprograms, 0 = none",
                          kMDipar + "6046", kManual, nullptr});
  CodeCall& subprogram = c.code_calls[1];
  subprogram.parameter = 6044;
  subprogram.program = 6045;
  subprogram.count = 6046;
  subprogram.source = kMDipar + "6044 to 6046";
  subprogram.evidence = kManual;
  return c;
}

// ---- 928TE ----

/// Calls of parts of the same program; M97 jumps, no macro statements, no alarm number known.
void read_928(Control& c) {
  c.semicolon = {Semicolon::EndOfBlock, kGeneral, kInferred};
  c.percent_programs = {true, kT928 + "%254", kManual};
  c.named_programs = {false, kGeneral, kInferred};
  c.file_name_wins = {false, kPolicy, kInferred};
  c.max_program_number = {254, kT928 + "%254", kManual};
  c.max_sequence_number = {9999, k001 + "N of four digits", kDocument};
  c.zero_numbers = {true, kPolicy, kInferred};
  c.sequence_number_first = {false, kPolicy, kInferred};
  c.max_words = {0, kPolicy, kInferred};
  c.max_block_length = {0, kPolicy, kInferred};
  c.max_digits = {8, kGeneral, kInferred};
  c.block_skip = {BlockSkip::HeadOnly, kGeneral, kInferred};
  c.repeated_address = {RepeatedAddress::LastWins, kPolicy, kInferred};
  c.open_comment = {OpenComment::RestOfBlock, kPolicy, kInferred};
  c.point_addresses = {"ABCDEFHIJKQRUVWXYZ", kGeneral, kInferred};
  c.minus_addresses = {"ABCDEFHIJKLQRSUVWXYZ", kGeneral + "; a negative L is a value out of range",
                       kInferred};
  c.whole_numbers = {WholeNumbers::Millimetres, k001 + "Fig. 3-1", kDocument};
  c.missing_end = {MissingEnd::Alarm, kPolicy, kInferred};
  c.m_codes_per_block = {1, kGeneral, kInferred};
  c.m_codes_alarm = {false, kGeneral, kInferred};
  c.m_codes_alone = {false, kPolicy, kInferred};
  c.bare_g = {false, kPolicy, kInferred};
  c.g_codes = {"0 1 2 3 4 22 26 27 29 33 50 80 96 97 98 99",
               "source 001 names G00 and G01, 928Ti G04; the rest " + kGeneral, kInferred};
  c.g_codes_complete = {false, "no list is known", kInferred};
}

void call_928(Control& c) {
  c.name_marks = {"", "there are no names", kInferred};
  c.return_alone_in_modal = {false, kPolicy, kInferred};
  c.cuts_fine_digits = {false, kPolicy, kInferred};
  c.late_sequence_numbers = {true, kPolicy, kInferred};
  c.program_word = {ProgramWord::SequenceNumber, k001 + "M98 P0060 L5", kDocument};
  c.max_program_digits = {4, k001 + "N of four digits", kDocument};
  c.count_and_l = {CountAndL::AllNumber, k001 + "M98 P0060 L5", kDocument};
  c.bracket_names = {false, kGeneral, kInferred};
  c.wide_names = {false, kPolicy + "; programs have no names", kInferred};
  c.max_name_length = {32, kPolicy + "; programs have no names", kInferred};
  c.call_values = {CallValues::Cut, kPolicy, kInferred};
  c.zero_count_alarms = {false, k001 + "P holds no count", kDocument};
  c.omitted_program = {OmittedProgram::Alarm, kPolicy, kInferred};
  c.start_word = {StartWord::None, k001 + "P is the start", kDocument};
  c.self_call = {SelfCall::Allowed, k001 + "every call is one of the own program", kDocument};
  c.caller_call = {CallerCall::Allowed, k001 + "every call is one of the own program", kDocument};
  c.max_repeats = {9999, kPolicy, kInferred};
  c.zero_repeats = {ZeroRepeats::Once, kPolicy, kInferred};
  c.too_many_repeats = {TooManyRepeats::Alarm, kPolicy, kInferred};
  c.max_nesting = {18, k001 + "18 levels", kDocument};
  c.nesting_counts_macros = {false, kGeneral + ": there are no macro calls", kInferred};
  c.max_macro_nesting = {4, kPolicy + "; there are no macro calls", kInferred};
  c.max_total_nesting = {0, k001 + "18 levels", kDocument};
  c.mdi_calls = {MdiCalls::Refused, kGeneral + ": MDI runs single blocks", kInferred};
  c.external_calls = {false, kGeneral, kInferred};
  c.device_word = {false, kGeneral, kInferred};
  c.return_search = {ReturnSearch::FromHead, kPolicy + "; source 001 has two blocks N0140",
                     kInferred};
  c.return_with_p = {ReturnWithP::Refused, "inferred from source 001, which knows M99 alone",
                     kInferred};
  c.return_with_l = {ReturnWithL::Ignored, kPolicy, kInferred};
  c.main_return = {MainReturn::Ends, k001 + "M99 without M98", kDocument};
  c.jump_m97 = {true, k001 + "M97", kDocument};
  c.restart_m_code = {20, kGeneral, kInferred};
  c.calls_in_modal = {CallsInModal::Allowed, kPolicy + "; there are no modal calls", kInferred};
  c.codes_not_with_return = {"", kPolicy, kInferred};
  c.codes_not_with_call = {"", kPolicy, kInferred};
  c.words_with_call_in_cycle = {true, kPolicy, kInferred};
}

/// The 928TE has none of these: its jumps are M97, and the r variables of the 928T are of another
/// kind.
void no_macros_928(Control& c) {
  c.reset_clears_locals = {true, kPolicy, kInferred};
  c.reset_clears_commons = {false, kPolicy, kInferred};
  c.vacant_system_writes = {true, kPolicy, kInferred};
  c.max_constant_digits = {12, kPolicy, kInferred};
  c.max_condition_length = {0, kPolicy, kInferred};
  c.codes_not_with_macro_call = {"", "there are no macro calls", kInferred};
  c.m_codes_not_with_macro_call = {"", "there are no macro calls", kInferred};
  c.codes_not_with_modal_call = {"", "there are no macro calls", kInferred};
  const std::string none = kGeneral + ": no macro statements";
  c.statements = {"", none, kInferred};
  c.commons = {"", none, kInferred};
  c.variable_options = {"", none, kInferred};
  c.if_form = {IfForm::GotoThen, none, kInferred};
  c.loop_form = {LoopForm::DoEnd, none, kInferred};
  c.jumps = {false, k001 + "jumps are M97", kDocument};
  c.jumps_in_mdi = {false, none, kInferred};
  c.jump_search = {JumpSearch::FromHead, kPolicy + "; source 001 has two blocks N0140", kInferred};
  c.max_jump_number = {9999, k001 + "N of four digits", kDocument};
  c.max_loop_number = {3, none, kInferred};
  c.max_loops = {3, none, kInferred};
  c.loops_count_across_calls = {false, none, kInferred};
  c.max_ifs = {10, none, kInferred};
  c.max_brackets = {5, none, kInferred};
  c.angle_unit = {AngleUnit::Degrees, none, kInferred};
  c.atan_range = {AngleRange::FullTurn, none, kInferred};
  c.asin_range = {AngleRange::FullTurn, none, kInferred};
  c.joined_conditions = {false, none, kInferred};
  c.comparison_symbols = {false, none, kInferred};
  c.conditions_without_brackets = {false, none, kInferred};
  c.short_functions = {false, none, kInferred};
  c.functions = {"", none, kInferred};
  c.modulo = {false, none, kInferred};
  c.vacant_address = {VacantAddress::Zero, none, kInferred};
  c.vacant_comparison = {VacantComparison::Zero, none, kInferred};
  c.variable_point = {false, kPolicy, kInferred};
  c.indirect_9nnn = {false, none, kInferred};
  c.negative_logic = {true, none, kInferred};
  c.variable_names = {false, none, kInferred};
  c.logic_binds_last = {false, none, kInferred};
  c.macro_calls = {false, none, kInferred};
  c.modal_every_block = {false, none, kInferred};
  c.max_macro_digits = {4, none, kInferred};
  c.argument_sets = {ArgumentSets::ByOrder, none, kInferred};
  c.numbered_axis_arguments = {false, none, kInferred};
  c.call_passes_words = {false, k001 + "M98 P L", kDocument};
  c.words_before_macro_call = {WordsBeforeMacroCall::Alarm, none, kInferred};
  c.repeated_argument = {RepeatedAddress::LastWins, none, kInferred};
  c.modal_locals = {ModalLocals::Rewritten, none, kInferred};
  c.modal_trigger = {ModalTrigger::Move, none, kInferred};
  c.modal_calls_stack = {false, none, kInferred};
  c.max_modal_calls = {4, none, kInferred};
  c.cancel_alone = {CancelAlone::Alarm, none, kInferred};
  c.h_codes = {false, none, kInferred};
  c.code_cascade = {CodeCascade::None, none, kInferred};
  c.user_alarm_offset = {0, none, kInferred};
  c.user_alarm_last = {0, none, kInferred};
  c.h99_offset = {0, none, kInferred};
}

Control gsk_928te() {
  Control c;
  c.name = "gsk-928te";
  c.title = "GSK 928TE lathe";
  read_928(c);
  call_928(c);
  no_macros_928(c);
  c.parameters = {
      {"3401#0", 1, "lengths without a point: 0 least increments, 1 millimetres",
       k001 + "Fig. 3-1; " + kStands, kInferred,
       [](Control& k, double value) {
         k.whole_numbers.value = value != 0 ? WholeNumbers::Millimetres : WholeNumbers::Increments;
       }},
      {"3402#0", 0, "power-on: 0 in G00, 1 in G01", kGeneral + "; " + kStands, kInferred, nullptr},
      {"3410", 0, "how far the radii of an arc's start and end may differ, 0 = any", kStands,
       kInferred, nullptr},
  };
  return c;
}

}  // namespace

std::vector<Control> gsk_controls() {
  return {gsk_988ta(), gsk_988t(), gsk_980tdi(), gsk_980mdi(), gsk_928te()};
}

}  // namespace cncsub
