// Huazhong HNC-21M milling.
// The keys of the sources stand in sources.def.
// The HNC-21 shows its alarms as sentences; no source gives a number or the exact words, so it has
// no alarm table.
#include "controls/facts.hpp"

namespace cncsub {
namespace {

using enum Evidence;

constexpr const char* kH9 = "H9";
constexpr const char* kHd = "HD";
constexpr const char* kHs = "HS";
constexpr const char* kUnsure = "general knowledge, unsure";
constexpr const char* kPolicy = "policy, nobody says";
constexpr const char* kNone = "general knowledge: the HNC-21 has nothing this could apply to";

void reading(Control& c) {
  c.reading.semicolon = {Semicolon::Comment, kHd, Secondary};
  has(c.reading.program_heads, {ProgramHead::Percent}, kHd, Secondary);
  lacks(c.reading.program_heads, {ProgramHead::Name, ProgramHead::File}, kKnown, Inferred);
  c.reading.max_program_number = {9999, "general knowledge; HD shows %1000 and %1001", Inferred};
  c.reading.max_sequence_number = {99999999, kPolicy, Inferred};
  c.reading.cuts_fine_digits = {false, kPolicy, Inferred};
  c.reading.late_sequence_numbers = {true, kPolicy, Inferred};
  c.reading.max_words = {0, kPolicy, Inferred};
  c.reading.max_block_length = {0, "policy; only a condition is limited, to 128 characters (HS)",
                                Inferred};
  c.reading.max_digits = {8, kPolicy, Inferred};
  c.reading.block_skip = {BlockSkip::HeadOnly, kUnsure, Inferred};
  c.reading.repeated_address = {RepeatedAddress::LastWins, kPolicy, Inferred};
  c.reading.open_comment = {OpenComment::RestOfBlock, kPolicy, Inferred};
  // P is included: it gives the seconds of G04.
  c.reading.point_addresses = {"ABCDEFHIJKPQRSUVWXYZ", kKnown, Inferred};
  c.reading.minus_addresses = {"ABCDEFHIJKQRSUVWXYZ", kKnown, Inferred};
  c.reading.whole_numbers = {WholeNumbers::Millimetres, kKnown, Inferred};
  c.reading.missing_end = {MissingEnd::Alarm, kKnown, Inferred};
  c.reading.m_codes_per_block = {2, "source 003, M06: T1 M06 M03 S500", SourceDocument};
  c.reading.extra_m_codes = {ExtraMCodes::Dropped, kUnsure, Inferred};
  c.reading.bare_g = {false, kPolicy, Inferred};
  c.reading.g_codes = {
      "0 1 2 3 4 7 9 11 12 15 16 17 18 19 20 21 22 24 25 28 29 34 40 41 42 43 44 49 50 51 52 53 54 "
      "55 56 "
      "57 58 59 60 61 64 65 68 69 73 74 76 80 81 82 83 84 85 86 87 88 89 90 91 92 94 95 98 99",
      "general knowledge; no complete list was found", Inferred};
  c.reading.unlisted_codes = {UnlistedCode::NotKnown, "policy: no complete list was found",
                              Inferred};
}

void calls_and_returns(Control& c) {
  c.calls.name_marks = {"+-_.", kPolicy, Inferred};
  c.calls.program_word = {ProgramWord::Number, "general knowledge; HD shows M98 P1001", Inferred};
  c.calls.max_program_digits = {8, kKnown, Inferred};
  c.calls.count_and_l = {CountAndL::AllNumber, kKnown, Inferred};
  c.calls.bracket_names = {false, kKnown, Inferred};
  c.calls.max_name_length = {8, "general knowledge: of a file's name", Inferred};
  c.calls.wide_names = {false, kKnown, Inferred};
  c.calls.call_values = {CallValues::Rounded, kPolicy, Inferred};
  c.calls.omitted_program = {OmittedProgram::Alarm, kKnown, Inferred};
  c.calls.start_word = {StartWord::None, kKnown, Inferred};
  c.calls.self_call = {SelfCall::Allowed, kPolicy, Inferred};
  c.calls.caller_call = {CallerCall::Allowed, kPolicy, Inferred};
  c.calls.max_repeats = {9999, kPolicy, Inferred};
  c.calls.zero_repeats = {ZeroRepeats::Once, kPolicy, Inferred};
  c.calls.too_many_repeats = {TooManyRepeats::Alarm, kPolicy, Inferred};
  c.calls.max_nesting = {9, kHs, Inferred};
  c.calls.nesting_counts_macros = {false, kNone, Inferred};
  c.calls.max_macro_nesting = {0, kNone, Inferred};
  c.calls.max_total_nesting = {9, kHs, Inferred};
  c.calls.mdi_calls = {MdiCalls::Refused, "source 003, M98 does not run in MDI", SourceDocument};
  no_role(c.calls.roles, {"M198", "M97"}, kKnown, Inferred);
  c.calls.device_word = {false, kKnown, Inferred};
  c.calls.return_search = {ReturnSearch::FromHead, kPolicy, Inferred};
  c.calls.return_with_p = {ReturnWithP::AtOnce,
                           "source 003, M99 Pn; of passes that remain nobody says", SourceDocument};
  c.calls.return_with_l = {ReturnWithL::Ignored, kPolicy, Inferred};
  c.calls.main_return = {MainReturn::Restarts, "source 003, M99 in the main program",
                         SourceDocument};
  c.calls.calls_in_modal = {CallsInModal::Allowed, kNone, Inferred};
  c.calls.codes_not_with_return = {"", kPolicy, Inferred};
  c.calls.codes_not_with_call = {"", kPolicy, Inferred};
}

void macro_statements(Control& c) {
  lacks(c.common.reset_clears, {Cleared::Commons}, kPolicy, Inferred);
  c.macros.max_constant_digits = {12, kPolicy, Inferred};
  c.macros.max_condition_length = {128, "HS MAX_CONDITION_LEN of an HNC-8 header", Secondary};
  c.macros.statements = {"# [ IF WHILE DPRNT? BPRNT? POPEN? PCLOS?", "HD; of outputs nobody says",
                         Inferred};
  c.macros.statements.tell("GOTO", kUnsure, Inferred);
  c.macros.if_form = {IfForm::Blocks, kHd, Secondary};
  c.macros.loop_form = {LoopForm::WhileEndw, kHd, Secondary};
  has(c.common.refuses, {Cause::JumpInMdi}, kPolicy, Inferred);
  c.calls.jump_search = {JumpSearch::FromHead, kNone, Inferred};
  c.calls.max_jump_number = {99999999, kNone, Inferred};
  c.macros.max_loop_number = {0, "HD: loops have no numbers", Secondary};
  c.macros.max_loops = {9, kHs, Inferred};
  c.macros.loops_count_across_calls = {false, kPolicy, Inferred};
  c.macros.max_ifs = {9, kHs, Inferred};
  c.macros.max_brackets = {64, "HS: a condition has at most 128 characters, so 64 pairs", Inferred};
  c.macros.angle_unit = {AngleUnit::Radians, kKnown, Inferred};
  c.macros.atan_range = {AngleRange::Signed, kUnsure, Inferred};
  c.macros.asin_range = {AngleRange::Signed, kNone, Inferred};
  has(c.macros.conditions, {Condition::Joined}, kH9, Secondary);
  lacks(c.macros.conditions, {Condition::Symbols}, kHd, Secondary);
  has(c.macros.conditions, {Condition::Bare}, kHd, Secondary);
  c.macros.short_functions = {false, kPolicy, Inferred};
  c.macros.functions = {"SIN COS TAN ATAN ATAN2 ABS INT SIGN SQRT EXP AR PI TRUE FALSE",
                        "general knowledge; the constants H9", Inferred};
  c.macros.vacant_address = {VacantAddress::Zero, kKnown, Inferred};
  c.macros.vacant_comparison = {VacantComparison::Zero, kKnown, Inferred};
  lacks(c.macros.variable_forms, {VariableForm::Indirect, VariableForm::Names}, kKnown, Inferred);
}

void macro_calls(Control& c) {
  c.macros.codes_not_with_macro_call = {"", "general knowledge: there are no macro calls",
                                        Inferred};
  c.macros.m_codes_not_with_macro_call = {"", "general knowledge: there are no macro calls",
                                          Inferred};
  c.macros.codes_not_with_modal_call = {"", "general knowledge: there are no macro calls",
                                        Inferred};
  no_role(c.calls.roles, {"G65", "G66", "G67"},
          "general knowledge: M98 does what G65 does elsewhere", Inferred);
  no_role(c.calls.roles, {"G66.1"}, kKnown, Inferred);
  c.macros.h_codes = {false, kKnown, Inferred};
  c.macros.max_macro_digits = {4, kNone, Inferred};
  c.macros.argument_sets = {ArgumentSets::First, kKnown, Inferred};
  c.macros.numbered_axis_arguments = {false, kKnown, Inferred};
  c.macros.call_passes_words = {true, kKnown, Inferred};
  c.macros.words_before_macro_call = {WordsBeforeMacroCall::Ordinary, kNone, Inferred};
  c.macros.repeated_argument = {RepeatedAddress::LastWins, kPolicy, Inferred};
  c.macros.modal_locals = {ModalLocals::Kept, kNone, Inferred};
  c.macros.modal_trigger = {ModalTrigger::Move, kNone, Inferred};
  c.macros.second_modal_call = {SecondModal::Stacks, kNone, Inferred};
  c.macros.max_modal_calls = {0, kNone, Inferred};
  c.macros.cancel_alone = {CancelAlone::Ignored, kNone, Inferred};
  c.macros.code_cascade = {CodeCascade::None, kNone, Inferred};
  c.macros.user_alarm_offset = {0, kNone, Inferred};
  c.macros.user_alarm_last = {0, kNone, Inferred};
  c.macros.h99_offset = {0, kNone, Inferred};
  c.macros.logic_order = {LogicOrder::Last, kKnown, Inferred};
}

void variables(Control& c) {
  c.variables.push_back({0, 49, VariableKind::Local, Access::ReadWrite, 0, kH9, Secondary});
  c.macros.commons = {"50-199", kH9, Secondary};
  c.macros.variable_options = {"", kPolicy, Inferred};
  c.variables.push_back({200, 599, VariableKind::LevelImage, Access::ReadWrite, 0, kH9, Secondary});
  c.variables.push_back(
      {600, 699, VariableKind::LengthGeometry, Access::ReadWrite, 0, kH9, Secondary});
  c.variables.push_back(
      {700, 799, VariableKind::RadiusGeometry, Access::ReadWrite, 0, kH9, Secondary});
  // The variables of tool life are plain storage here.
  c.variables.push_back({800, 899, VariableKind::Kept, Access::ReadWrite, 0, kH9, Secondary});
}

void motion(Control& c) {
  c.motion.g_meanings = {
      "22=pulses 24=mirror 25=mirror-off 7=not-computed 11=not-computed 12=not-computed "
      "34=not-computed 65=not-computed 10=none 31=none 96=none 45=none 46=none "
      "47=none 48=none",
      "source 003, G22; the others from general knowledge", SourceDocument};
  lacks(c.common.power_on, {PowerOn::G01},
        "inferred from source 003, typical example: Z5 before any F", Inferred);
  c.motion.parallel_axes = {true, "source 003, arcs end in X, Y, Z, U, V, W", SourceDocument};
  c.motion.dwell_unit = {DwellUnit::PSeconds, "source 003, G04", SourceDocument};
  c.motion.no_radius = {NoRadius::Alarm, kKnown, Inferred};
  c.motion.cycle_repeats = {"L", kKnown, Inferred};
  c.motion.peck_words = {PeckWords::K, kKnown, Inferred};
  c.motion.scale_unit = {ScaleUnit::Factor, kKnown, Inferred};
  c.motion.machine_move = {MachineMove::Rapid, "source 003, G53", SourceDocument};
  c.motion.unit_change = {UnitChange::AtHead, "source 003, G20 G21 G22, and its typical example",
                          SourceDocument};
  c.motion.rotation_words = {"P", kKnown, Inferred};
  c.motion.arc_tolerance = {0, kPolicy, Inferred};
}

}  // namespace

Control hnc_21m() {
  Control c;
  c.title = "Huazhong HNC-21M";
  leave_out(c, RuleGroup::TurningRules, "source 003, a text on milling", Inferred);
  reading(c);
  calls_and_returns(c);
  macro_statements(c);
  macro_calls(c);
  variables(c);

  motion(c);
  return c;
}

}  // namespace cncsub
