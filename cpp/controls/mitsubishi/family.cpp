// The rules, variables and parameters that the Mitsubishi controls share.
#include "controls/mitsubishi/family.hpp"

namespace cncsub::mitsubishi {
namespace {

// The codes of milling and turning together, since a library may be run on either machine.
constexpr const char* kGCodes =
    "0 1 1.1 2 2.1 2.3 2.4 3 3.1 3.3 3.4 4 5 5.1 6.2 7 7.1 8 9 10 11 "
    "12 12.1 13 13.1 14 15 16 17 18 19 20 21 22 22.1 23 23.1 24 25 26 27 28 29 30 "
    "30.1 30.2 30.3 30.4 30.5 30.6 31 31.1 31.2 31.3 32 33 34 35 36 37 37.1 38 39 "
    "40 40.1 41 41.1 41.2 42 42.1 42.2 43 43.1 43.4 43.5 44 45 46 47 48 49 "
    "50 50.1 50.2 51 51.1 51.2 52 53 53.1 54 54.1 54.4 55 56 57 58 59 "
    "60 61 61.1 61.2 62 62.1 63 63.1 63.2 64 65 66 66.1 67 68 68.1 68.2 68.3 69 69.1 "
    "70 71 72 73 74 75 76 77 78 79 80 81 82 83 84 85 86 87 88 89 "
    "90 91 92 92.1 93 94 95 96 97 98 99 "
    "107 112 113 114.1 114.2 114.3 115 116 117 118 119 120.1 121 122 160";

void reading(Control& c) {
  c.reading.semicolon = {Semicolon::EndOfBlock, k004 + "form of M98", SourceDocument};
  lacks(c.reading.program_heads, {ProgramHead::Percent}, kGeneral + ": % is the end of record",
        Inferred);
  has(c.reading.program_heads, {ProgramHead::Name}, kIMD + "<file name>", Secondary);
  has(c.reading.program_heads, {ProgramHead::File}, kIMD2 + "the O word is a label", Secondary);
  c.reading.max_program_number = {99999999, kIMD + "P has eight digits", Secondary};
  c.reading.max_sequence_number = {99999, kIMD + "H from 1 to 99999", Secondary};
  has(c.common.refuses, {Cause::ProgramNumberZero}, kMZ + "811: zero as program or sequence number",
      Secondary);
  lacks(c.common.refuses, {Cause::SequenceNumberNotFirst},
        kGeneral + ": only a target must have its N at the head", Inferred);
  c.reading.cuts_fine_digits = {false, kPolicy, Inferred};
  c.reading.late_sequence_numbers = {
      false, kGeneral + ": the N of a target stands at the head of its block", Inferred};
  c.reading.max_words = {0, kPolicy, Inferred};
  c.reading.max_block_length = {0, kPolicy, Inferred};
  c.reading.max_digits = {15, kPolicy + "; ranges are checked address by address, " + kSK + "P35",
                          Inferred};
  c.reading.block_skip = {BlockSkip::HeadOnly,
                          kGeneral + ": before or after N, elsewhere by a parameter", Inferred};
  c.reading.repeated_address = {RepeatedAddress::LastWins, kGeneral + "; a parameter may change it",
                                Inferred};
  c.reading.open_comment = {OpenComment::RestOfBlock, kPolicy, Inferred};
  c.reading.point_addresses = {"ABCEFIJKQRUVWXYZ", kM7 + "p.40 (3); P has a point in scaling only",
                               Manual};
  c.reading.minus_addresses = {"ABCDEFHIJKLQRSUVWXYZ",
                               kGeneral + "; a negative L is a value out of range", Inferred};
  c.reading.whole_numbers = {WholeNumbers::Millimetres,
                             "inferred from the worked examples, which count in millimetres",
                             Inferred};
  c.reading.missing_end = {MissingEnd::Alarm, kSK + "P36", Manual};
  c.reading.m_codes_per_block = {4, kGeneral, Inferred};
  c.reading.extra_m_codes = {ExtraMCodes::Dropped, kGeneral, Inferred};
  c.reading.bare_g = {true, kM7 + "p.45: G without a number is G00", Manual};
  c.reading.g_codes = {kGCodes, kGeneral + "; " + kM7 + "for the milling groups", Inferred};
}

void calling(Control& c) {
  c.calls.name_marks = {"+-_.", kPolicy, Inferred};
  c.calls.program_word = {ProgramWord::Number, kIMD + "P is the program number", Secondary};
  c.calls.max_program_digits = {8, kIMD + "P has eight digits", Secondary};
  c.calls.count_and_l = {CountAndL::AllNumber, kIMD + "P holds no count", Secondary};
  c.calls.bracket_names = {false, kIMD + "names stand in < >", Secondary};
  c.calls.wide_names = {false, kGeneral, Inferred};
  c.calls.max_name_length = {32, kIMD + "32 characters with the extension", Secondary};
  c.calls.call_values = {CallValues::Rounded, kGeneral, Inferred};
  lacks(c.common.refuses, {Cause::IllegalRepeatCount}, kIMD + "P holds no count", Secondary);
  c.calls.omitted_program = {OmittedProgram::Own,
                             kIMD + "P omitted: subroutine of the same program", Secondary};
  c.calls.start_word = {StartWord::H, k004 + "H", SourceDocument};
  c.calls.self_call = {SelfCall::Allowed, kIMD + "P omitted: a program calls itself", Secondary};
  c.calls.caller_call = {CallerCall::Allowed, kGeneral + ": only the levels count", Inferred};
  c.calls.max_repeats = {9999, k004 + "at most 9999 times", SourceDocument};
  c.calls.zero_repeats = {ZeroRepeats::Skip, k004 + "note 3, L0", SourceDocument};
  c.calls.too_many_repeats = {TooManyRepeats::Alarm, kSK + "P35", Manual};
  c.calls.max_nesting = {8, kSM + "difference (6): eight levels combined", Manual};
  c.calls.nesting_counts_macros = {true, kSM + "difference (6): eight levels combined", Manual};
  c.calls.max_macro_nesting = {4, kSM + "difference (6): four levels of G65, G66, G66.1", Manual};
  c.calls.max_total_nesting = {0, kSM + "difference (6): max_nesting counts both kinds", Manual};
  c.calls.mdi_calls = {MdiCalls::Allowed, kIMD + "P omitted: memory and MDI", Secondary};
  give_role(c.calls.roles, "M198", Role::ExternalCall, kCW + "M198", Secondary);
  c.calls.device_word = {true, kIMD + ",D from 0 to 4", Secondary};
  c.calls.return_search = {ReturnSearch::FromHead, kPolicy, Inferred};
  c.calls.return_with_p = {ReturnWithP::LastPass, kPolicy, Inferred};
  c.calls.return_with_l = {ReturnWithL::ReplacesCount, kOB + "M99 L", Secondary};
  c.calls.main_return = {MainReturn::Restarts, k004 + "M99 in the main program", SourceDocument};
  no_role(c.calls.roles, {"M97"}, kGeneral + ": M96 and M97 are macro interrupts", Inferred);
  c.calls.calls_in_modal = {CallsInModal::Allowed, kGeneral, Inferred};
  c.calls.codes_not_with_return = {"", kPolicy, Inferred};
  c.calls.codes_not_with_call = {"", kPolicy, Inferred};
  lacks(c.common.refuses, {Cause::CallWithWordsInCycle}, kGeneral, Inferred);
}

void statements(Control& c) {
  lacks(c.common.reset_clears, {Cleared::Commons}, kPolicy, Inferred);
  c.macros.max_constant_digits = {12, kPolicy, Inferred};
  c.macros.max_condition_length = {0, kPolicy, Inferred};
  c.macros.if_form = {IfForm::GotoThen, kGeneral + "; a single IF THEN, to be verified", Inferred};
  c.macros.loop_form = {LoopForm::DoEnd, kMZ + "865, 868", Secondary};
  lacks(c.common.refuses, {Cause::JumpInMdi}, kGeneral + ": only tape and DNC refuse them",
        Inferred);
  c.calls.jump_search = {JumpSearch::ForwardThenHead, kGeneral, Inferred};
  c.calls.max_jump_number = {99999, kIMD + "sequence numbers from 1 to 99999", Secondary};
  c.macros.max_loop_number = {127, kGeneral, Inferred};
  c.macros.max_loops = {27, kMZ + "867: more than 27", Secondary};
  c.macros.loops_count_across_calls = {true, kGeneral, Inferred};
  c.macros.max_ifs = {10, kGeneral + ": without effect where IF has no blocks", Inferred};
  c.macros.max_brackets = {5, kMZ + "858: more than five", Secondary};
}

void expressions(Control& c) {
  c.macros.angle_unit = {AngleUnit::Degrees, kGeneral, Inferred};
  c.macros.atan_range = {AngleRange::FullTurn, kPolicy, Inferred};
  c.macros.asin_range = {AngleRange::Signed, kGeneral + ": #1273 bit 0 is 0", Inferred};
  has(c.macros.conditions, {Condition::Joined},
      kGeneral + ": AND, OR and XOR rank after the comparisons", Inferred);
  lacks(c.macros.conditions, {Condition::Symbols}, kGeneral, Inferred);
  lacks(c.macros.conditions, {Condition::Bare}, kMZ + "864: the form of IF", Secondary);
  c.macros.short_functions = {false, kGeneral + ": names of their own (RND) instead", Inferred};
  c.macros.functions = {
      "SIN COS TAN ASIN ACOS ATAN SQRT SQR ABS ROUND RND FIX FUP LN EXP BIN BCD MOD", kGeneral,
      Inferred};
  c.macros.word_arithmetic = {true, kM7 + "p.326: G0 X#1 + 10 Y1000", Manual};
  c.macros.vacant_address = {VacantAddress::Ignored, kGeneral, Inferred};
  c.macros.vacant_comparison = {VacantComparison::Distinguished,
                                kM7 + "p.326: EQ and NE tell a vacant variable from 0", Manual};
  has(c.macros.variable_forms, {VariableForm::Point},
      "real programs: #504. in a macro of the maker", Secondary);
  lacks(c.macros.variable_forms, {VariableForm::Indirect}, kGeneral, Inferred);
  has(c.macros.variable_forms, {VariableForm::Names}, kMZ + "866, 870, 871: SETVN", Secondary);
  c.macros.statements = {"# [ IF WHILE DO GOTO DPRNT BPRNT? POPEN PCLOS",
                         kGeneral + "; of BPRNT nobody says", Inferred};
  c.macros.statements.tell("GOTO", kMZ + "864: IF and GOTO", Secondary);
  c.macros.logic_order = {LogicOrder::LastOfConditions,
                          kGeneral +
                              ": functions, * / MOD, + -, comparisons, AND, OR XOR; "
                              "added.md: IF[#120AND3EQ3] in programs of a machine",
                          Inferred};
}

void macros(Control& c) {
  c.macros.codes_not_with_macro_call = {"", kPolicy, Inferred};
  c.macros.m_codes_not_with_macro_call = {"", kPolicy, Inferred};
  c.macros.codes_not_with_modal_call = {"", kPolicy, Inferred};
  give_role(c.calls.roles, "G65", Role::MacroCall, kSM + "differences of M98 and G65", Manual);
  give_role(c.calls.roles, "G66.1", Role::ModalCallEveryBlock, kSM + "difference (6) names G66.1",
            Manual);
  c.macros.max_macro_digits = {8, kIMD + "P has eight digits", Secondary};
  c.macros.argument_sets = {ArgumentSets::ByOrder, kGeneral + ": ten groups of I, J, K", Inferred};
  c.macros.numbered_axis_arguments = {false, kGeneral, Inferred};
  c.macros.call_passes_words = {false, kSM + "difference (1): only G65 takes arguments", Manual};
  c.macros.words_before_macro_call = {WordsBeforeMacroCall::Ordinary, kGeneral, Inferred};
  c.macros.repeated_argument = {RepeatedAddress::LastWins, kGeneral, Inferred};
  c.macros.modal_locals = {ModalLocals::Rewritten, kPolicy, Inferred};
  c.macros.modal_trigger = {ModalTrigger::Move, kM7 + "p.320: after each block that moves an axis",
                            Manual};
  c.macros.second_modal_call = {SecondModal::Stacks, kM7 + "p.320, note 2: the last one first",
                                Manual};
  c.macros.max_modal_calls = {4, kSM + "difference (6): four levels of G65, G66, G66.1", Manual};
  c.macros.cancel_alone = {CancelAlone::Alarm, kMZ + "857", Secondary};
  c.macros.h_codes = {false, kGeneral, Inferred};
  c.macros.code_cascade = {CodeCascade::OtherKind,
                           kGeneral + ": no G-code call inside a macro called by a G code",
                           Inferred};
  c.macros.user_alarm_offset = {0, kGeneral + ": P277 shows n itself", Inferred};
  c.macros.user_alarm_last = {9999, kGeneral, Inferred};
  c.macros.h99_offset = {0, kGeneral + ": there is no G65 H", Inferred};
}

/// Add the last words and those of the running block.
void last_words(Control& c) {
  for (const char address : std::string_view("BDEFHMNOST")) {
    const std::int32_t number = modal_word_number(address);
    for (const auto& [first, kind] :
         {std::pair{number, VariableKind::ModalWord}, {number + 200, VariableKind::ActiveWord}})
      c.variables.push_back(
          {first, first, kind, Access::ReadOnly, address, kM7 + "printed p.331", Manual});
  }
}

void variables(Control& c) {
  const auto add = [&c](std::int32_t first, std::int32_t last, VariableKind kind,
                        Access access = Access::ReadOnly, char address = 0) {
    c.variables.push_back({first, last, kind, access, address, kGeneral, Inferred});
  };
  add(0, 0, VariableKind::Vacant);
  c.variables.push_back(
      {1, 33, VariableKind::Local, Access::ReadWrite, 0, kSM + "difference (5)", Manual});
  add(1000, 1031, VariableKind::Input);
  add(1032, 1035, VariableKind::InputWord);
  add(1100, 1131, VariableKind::Output, Access::ReadWrite);
  add(1132, 1135, VariableKind::OutputWord, Access::ReadWrite);
  add(2001, 2200, VariableKind::LengthGeometry, Access::ReadWrite);
  add(3000, 3000, VariableKind::UserAlarm, Access::WriteOnly);
  add(3001, 3001, VariableKind::Milliseconds, Access::ReadWrite);
  add(3002, 3002, VariableKind::Hours, Access::ReadWrite);
  add(3003, 3004, VariableKind::Control1, Access::ReadWrite);
  add(3006, 3006, VariableKind::Message, Access::WriteOnly);
  add(3007, 3007, VariableKind::Mirror);
  add(3011, 3011, VariableKind::Date);
  add(3012, 3012, VariableKind::Time);
  add(3901, 3902, VariableKind::PartsCount, Access::ReadWrite);
  add(4001, 4021, VariableKind::ModalCode);
  add(4201, 4221, VariableKind::ActiveCode);
  last_words(c);
  add(5001, 5008, VariableKind::BlockEnd);
  add(5021, 5028, VariableKind::MachinePosition);
  add(5041, 5048, VariableKind::WorkPosition);
  add(5061, 5068, VariableKind::SkipPosition);
  add(5101, 5108, VariableKind::ServoError);
  add(5201, 5328, VariableKind::WorkOffset, Access::ReadWrite);
  add(7001, 7948, VariableKind::ExtraWorkOffset, Access::ReadWrite);
  add(10001, 10200, VariableKind::LengthGeometry, Access::ReadWrite);
  add(11001, 11200, VariableKind::LengthWear, Access::ReadWrite);
  add(16001, 16200, VariableKind::RadiusGeometry, Access::ReadWrite);
  add(17001, 17200, VariableKind::RadiusWear, Access::ReadWrite);
}

/// Add the commons, which come in sets by how many a part system has. The names of the sets are
/// general knowledge.
void variable_choices(Control& c) {
  const std::string programs = "real programs of an M700-class machine use them; their name ";
  c.macros.commons = {"100-199 500-999", kGeneral + ": 600 sets", Inferred};
  c.macros.variable_options = {"", kPolicy, Inferred};
  const auto sets = [&c](const char* name, const char* meaning, const Ranges& commons,
                         const std::string& source) {
    c.variable_choices.push_back({name, meaning, commons, {}, source, Inferred});
  };
  sets("200-sets", "200 sets of common variables", "100-199 500-599", kGeneral);
  sets("300-sets", "300 sets of common variables", "100-199 500-699", kGeneral);
  sets("600-sets", "600 sets of common variables", "100-199 500-999", kGeneral);
  sets("700-sets", "700 sets of common variables", "100-199 400-999", programs + kGeneral);
  sets("8000-sets", "8000 sets of common variables", "100-199 400-999 900000-907399",
       programs + kGeneral);
  const auto option = [&](const char* name, const char* meaning,
                          std::vector<VariableRange> variables) {
    c.variable_choices.push_back(
        {name, meaning, "", std::move(variables), programs + kGeneral, Inferred});
  };
  const auto range = [&](std::int32_t first, std::int32_t last, VariableKind kind,
                         Access access = Access::ReadWrite) {
    return VariableRange{first, last, kind, access, 0, programs + kGeneral, Inferred};
  };
  option(
      "offsets-from-2201", "tool wear and radius as #2201 to #2800",
      {range(2201, 2400, VariableKind::LengthWear), range(2401, 2600, VariableKind::RadiusGeometry),
       range(2601, 2800, VariableKind::RadiusWear)});
  option("parameter-reading", "parameters read by #100000 to #100010",
         {range(100000, 100002, VariableKind::ParameterChoice),
          range(100010, 100010, VariableKind::ParameterValue, Access::ReadOnly)});
}

/// Set the call codes. The control registers them on a screen: they have no numbers of their own.
void call_codes(Control& c) {
  const std::string source =
      kGeneral + ": ten G codes and ten M codes; S, T and B each one program";
  c.calls.registered_codes = {"", source + "; none is registered", Inferred};
  CodeCall list;
  list.first_code = 1;
  list.source = source;
  list.evidence = Inferred;
  list.address = 'G';
  c.code_calls.push_back(list);
  list.address = 'T';
  list.variable = 149;
  c.code_calls.push_back(list);
  list.address = 'M';
  list.variable = 0;
  list.refused = "1 2 30 96 97 98 99 198";
  c.code_calls.push_back(list);
}

/// The parameters that set rules, and those that the engine reads.
const Parameter kParameters[] = {
    read_by(rule::skip_own_feed, {"1174", 0, "skip_F, the feed of G31 without F, mm/min",
                                  kM7 + "p.547; its default " + kPolicy, Manual}),
    read_by(rule::measuring, {"8004", 0, "SPEED, the measuring feed of G37.1 without F, mm/min",
                              kM7 + "p.555; its default " + kPolicy, Manual}),
    read_by(rule::measuring,
            {"8005", 0, "ZONE r, how far before the point that feed begins without R, mm",
             kM7 + "p.555; its default " + kPolicy, Manual}),
    read_by(rule::measuring,
            {"8006", 0, "ZONE d, within what distance of the point the tool arrives without D, mm",
             kM7 + "p.555; its default " + kPolicy, Manual}),
    read_by(rule::skip_signals,
            {"1173", 0, "dwlskp, the skip signals that end G04: bit 0 is signal 1",
             kM7 + "p.554; its default " + kPolicy, Manual}),
    read_by(rule::skip_signals,
            {"1175", 1, "skip1, the skip signals of G31.1: bit 0 is signal 1",
             kM7 + "p.552; its number and its default from " + kGeneral, Inferred}),
    read_by(rule::skip_signals,
            {"1177", 2, "skip2, the skip signals of G31.2: bit 0 is signal 1",
             kM7 + "p.552; its number and its default from " + kGeneral, Inferred}),
    read_by(rule::skip_signals,
            {"1179", 4, "skip3, the skip signals of G31.3: bit 0 is signal 1",
             kM7 + "p.552; its number and its default from " + kGeneral, Inferred}),
    read_by(rule::skip_own_feed, {"1176", 0, "skip1f, the feed of G31.1 without F, mm/min",
                                  kM7 + "p.552; its default " + kPolicy, Manual}),
    read_by(rule::skip_own_feed, {"1178", 0, "skip2f, the feed of G31.2 without F, mm/min",
                                  kM7 + "p.552; its default " + kPolicy, Manual}),
    read_by(rule::skip_own_feed, {"1180", 0, "skip3f, the feed of G31.3 without F, mm/min",
                                  kM7 + "p.552; its default " + kPolicy, Manual}),
};

const AlarmList& alarms_m700() {
  using enum Cause;
  static const AlarmList list = {"",
                                 Inferred,
                                 false,
                                 "",
                                 {
#include "controls/mitsubishi/alarms_m700.def"
                                 }};
  return list;
}

}  // namespace

Control family() {
  Control c;
  reading(c);
  calling(c);
  statements(c);
  expressions(c);
  macros(c);
  take_list(c, alarms_m700());
  c.user_alarm_number = "P277";
  variables(c);
  variable_choices(c);
  add_parameters(c, kParameters);
  call_codes(c);
  add_family_motion(c);
  return c;
}

}  // namespace cncsub::mitsubishi
