// Huazhong HNC-21M milling.
// The keys of the sources stand in sources.def.
// The HNC-21 shows its alarms as sentences; no source gives a number or the exact words, so it has
// no alarm table.
#include "controls/facts.hpp"
#include "controls/settings.hpp"

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
  c.semicolon = {Semicolon::Comment, kHd, Secondary};
  c.percent_programs = {true, kHd, Secondary};
  c.named_programs = {false, kKnown, Inferred};
  c.file_name_wins = {false, kKnown, Inferred};
  c.max_program_number = {9999, "general knowledge; HD shows %1000 and %1001", Inferred};
  c.max_sequence_number = {99999999, kPolicy, Inferred};
  c.zero_numbers = {true, kPolicy, Inferred};
  c.sequence_number_first = {false, kPolicy, Inferred};
  c.cuts_fine_digits = {false, kPolicy, Inferred};
  c.late_sequence_numbers = {true, kPolicy, Inferred};
  c.max_words = {0, kPolicy, Inferred};
  c.max_block_length = {0, "policy; only a condition is limited, to 128 characters (HS)", Inferred};
  c.max_digits = {8, kPolicy, Inferred};
  c.block_skip = {BlockSkip::HeadOnly, kUnsure, Inferred};
  c.repeated_address = {RepeatedAddress::LastWins, kPolicy, Inferred};
  c.open_comment = {OpenComment::RestOfBlock, kPolicy, Inferred};
  // P too: it is the seconds of G04.
  c.point_addresses = {"ABCDEFHIJKPQRSUVWXYZ", kKnown, Inferred};
  c.minus_addresses = {"ABCDEFHIJKQRSUVWXYZ", kKnown, Inferred};
  c.whole_numbers = {WholeNumbers::Millimetres, kKnown, Inferred};
  c.missing_end = {MissingEnd::Alarm, kKnown, Inferred};
  c.m_codes_per_block = {2, "source 003, M06: T1 M06 M03 S500", SourceDocument};
  c.m_codes_alarm = {false, kUnsure, Inferred};
  c.m_codes_alone = {false, kPolicy, Inferred};
  c.bare_g = {false, kPolicy, Inferred};
  c.g_codes = {
      "0 1 2 3 4 7 9 11 12 17 18 19 20 21 22 24 25 28 29 34 40 41 42 43 44 49 50 51 52 53 54 55 56 "
      "57 58 59 60 61 64 65 68 69 73 74 76 80 81 82 83 84 85 86 87 88 89 90 91 92 94 95 98 99",
      "general knowledge; no complete list was found", Inferred};
  c.g_codes_complete = {false, "no complete list was found", Inferred};
}

void calls_and_returns(Control& c) {
  c.name_marks = {"+-_.", kPolicy, Inferred};
  c.return_alone_in_modal = {false, kPolicy, Inferred};
  c.program_word = {ProgramWord::Number, "general knowledge; HD shows M98 P1001", Inferred};
  c.max_program_digits = {8, kKnown, Inferred};
  c.count_and_l = {CountAndL::AllNumber, kKnown, Inferred};
  c.bracket_names = {false, kKnown, Inferred};
  c.max_name_length = {8, "general knowledge: of a file's name", Inferred};
  c.wide_names = {false, kKnown, Inferred};
  c.call_values = {CallValues::Rounded, kPolicy, Inferred};
  c.zero_count_alarms = {false, kNone, Inferred};
  c.omitted_program = {OmittedProgram::Alarm, kKnown, Inferred};
  c.start_word = {StartWord::None, kKnown, Inferred};
  c.self_call = {SelfCall::Allowed, kPolicy, Inferred};
  c.caller_call = {CallerCall::Allowed, kPolicy, Inferred};
  c.max_repeats = {9999, kPolicy, Inferred};
  c.zero_repeats = {ZeroRepeats::Once, kPolicy, Inferred};
  c.too_many_repeats = {TooManyRepeats::Alarm, kPolicy, Inferred};
  c.max_nesting = {9, kHs, Inferred};
  c.nesting_counts_macros = {false, kNone, Inferred};
  c.max_macro_nesting = {0, kNone, Inferred};
  c.max_total_nesting = {9, kHs, Inferred};
  c.mdi_calls = {MdiCalls::Allowed, kPolicy, Inferred};
  c.external_calls = {false, kKnown, Inferred};
  c.device_word = {false, kKnown, Inferred};
  c.return_search = {ReturnSearch::FromHead, kNone, Inferred};
  c.return_with_p = {ReturnWithP::Refused, kUnsure, Inferred};
  c.return_with_l = {ReturnWithL::Ignored, kPolicy, Inferred};
  c.main_return = {MainReturn::Restarts, kKnown, Inferred};
  c.jump_m97 = {false, kKnown, Inferred};
  c.restart_m_code = {0, kKnown, Inferred};
  c.calls_in_modal = {CallsInModal::Allowed, kNone, Inferred};
  c.codes_not_with_return = {"", kPolicy, Inferred};
  c.codes_not_with_call = {"", kPolicy, Inferred};
  c.words_with_call_in_cycle = {true, kPolicy, Inferred};
}

void macro_statements(Control& c) {
  c.reset_clears_locals = {true, kPolicy, Inferred};
  c.reset_clears_commons = {false, kPolicy, Inferred};
  c.vacant_system_writes = {true, kPolicy, Inferred};
  c.max_constant_digits = {12, kPolicy, Inferred};
  c.max_condition_length = {128, "HS MAX_CONDITION_LEN of an HNC-8 header", Secondary};
  c.statements = {"# [ IF WHILE DPRNT? BPRNT? POPEN? PCLOS?", "HD; of outputs nobody says",
                  Inferred};
  c.if_form = {IfForm::Blocks, kHd, Secondary};
  c.loop_form = {LoopForm::WhileEndw, kHd, Secondary};
  c.jumps = {false, kUnsure, Inferred};
  c.jumps_in_mdi = {false, kPolicy, Inferred};
  c.jump_search = {JumpSearch::FromHead, kNone, Inferred};
  c.max_jump_number = {99999999, kNone, Inferred};
  c.max_loop_number = {0, "HD: loops have no numbers", Secondary};
  c.max_loops = {9, kHs, Inferred};
  c.loops_count_across_calls = {false, kPolicy, Inferred};
  c.max_ifs = {9, kHs, Inferred};
  c.max_brackets = {64, "HS: a condition has at most 128 characters, so 64 pairs", Inferred};
  c.angle_unit = {AngleUnit::Radians, kKnown, Inferred};
  c.atan_range = {AngleRange::Signed, kUnsure, Inferred};
  c.asin_range = {AngleRange::Signed, kNone, Inferred};
  c.joined_conditions = {true, kH9, Secondary};
  c.comparison_symbols = {false, kHd, Secondary};
  c.conditions_without_brackets = {true, kHd, Secondary};
  c.short_functions = {false, kPolicy, Inferred};
  c.functions = {"SIN COS TAN ATAN ATAN2 ABS INT SIGN SQRT EXP AR PI TRUE FALSE",
                 "general knowledge; the constants H9", Inferred};
  c.modulo = {false, kKnown, Inferred};
  c.vacant_address = {VacantAddress::Zero, kKnown, Inferred};
  c.vacant_comparison = {VacantComparison::Zero, kKnown, Inferred};
  c.variable_point = {false, kPolicy, Inferred};
  c.indirect_9nnn = {false, kKnown, Inferred};
  c.negative_logic = {true, kNone, Inferred};
  c.variable_names = {false, kKnown, Inferred};
}

void macro_calls(Control& c) {
  c.codes_not_with_macro_call = {"", "there are no macro calls", Inferred};
  c.m_codes_not_with_macro_call = {"", "there are no macro calls", Inferred};
  c.codes_not_with_modal_call = {"", "there are no macro calls", Inferred};
  c.macro_calls = {false, "general knowledge: M98 does what G65 does elsewhere", Inferred};
  c.modal_every_block = {false, kKnown, Inferred};
  c.max_macro_digits = {4, kNone, Inferred};
  c.argument_sets = {ArgumentSets::First, kKnown, Inferred};
  c.numbered_axis_arguments = {false, kKnown, Inferred};
  c.call_passes_words = {true, kKnown, Inferred};
  c.words_before_macro_call = {WordsBeforeMacroCall::Ordinary, kNone, Inferred};
  c.repeated_argument = {RepeatedAddress::LastWins, kPolicy, Inferred};
  c.modal_locals = {ModalLocals::Kept, kNone, Inferred};
  c.modal_trigger = {ModalTrigger::Move, kNone, Inferred};
  c.modal_calls_stack = {true, kNone, Inferred};
  c.max_modal_calls = {0, kNone, Inferred};
  c.cancel_alone = {CancelAlone::Ignored, kNone, Inferred};
  c.h_codes = {false, kKnown, Inferred};
  c.code_cascade = {CodeCascade::None, kNone, Inferred};
  c.user_alarm_offset = {0, kNone, Inferred};
  c.user_alarm_last = {0, kNone, Inferred};
  c.h99_offset = {0, kNone, Inferred};
  c.logic_binds_last = {true, kKnown, Inferred};
}

/// The HNC-21 numbers its parameters otherwise; these FANUC numbers stand for the same choices.
void parameters(Control& c) {
  c.parameters.push_back(
      {"3401#0", 1, "stands for: a length without a point is 0 = increments, 1 = mm", kKnown,
       Inferred, [](Control& k, double v) {
         k.whole_numbers.value = v != 0 ? WholeNumbers::Millimetres : WholeNumbers::Increments;
       }});
}

void variables(Control& c) {
  c.variables.push_back({0, 49, VariableKind::Local, Access::ReadWrite, 0, kH9, Secondary});
  c.commons = {"50-199", kH9, Secondary};
  c.variable_options = {"", kPolicy, Inferred};
  c.variables.push_back({200, 599, VariableKind::LevelImage, Access::ReadWrite, 0, kH9, Secondary});
  c.variables.push_back(
      {600, 699, VariableKind::LengthGeometry, Access::ReadWrite, 0, kH9, Secondary});
  c.variables.push_back(
      {700, 799, VariableKind::RadiusGeometry, Access::ReadWrite, 0, kH9, Secondary});
  // Tool life: plain storage here.
  c.variables.push_back({800, 899, VariableKind::Kept, Access::ReadWrite, 0, kH9, Secondary});
}

void motion(Control& c) {
  c.g_meanings = {
      "22=pulses 24=mirror 25=mirror-off 7=not-computed 11=not-computed 12=not-computed "
      "34=not-computed 65=not-computed 10=none 15=none 16=none 31=none 96=none 45=none 46=none "
      "47=none 48=none",
      "source 003, G22; the others from general knowledge", SourceDocument};
  c.power_on_line = {false, "inferred from source 003, typical example: Z5 before any F", Inferred};
  c.dwell_p_seconds = {true, "source 003, G04", SourceDocument};
  c.no_radius = {NoRadius::Alarm, kKnown, Inferred};
  c.cycle_repeats = {"L", kKnown, Inferred};
  c.peck_words = {PeckWords::K, kKnown, Inferred};
  c.scale_thousandths = {false, kKnown, Inferred};
  c.machine_move = {MachineMove::Rapid, "source 003, G53", SourceDocument};
  c.unit_change = {UnitChange::AtHead, "source 003, G20 G21 G22, and its typical example",
                   SourceDocument};
  c.rotation_words = {"P", kKnown, Inferred};
  add_parameter(c, {"3402#0", 0, "stands for: at power-on 0 = G00, 1 = G01",
                    "inferred from source 003, typical example: Z5 before any F", Inferred,
                    set_power_on_line});
  add_parameter(c, {"3403#5", 1,
                    "stands for: an arc without R, I, J and K is 0 = a straight line, 1 = an alarm",
                    kUnsure, Inferred, set_no_radius});
  add_parameter(
      c, {"3410", 0, "stands for: how much the radius of an arc's end may differ, 0 = not checked",
          kPolicy, Inferred, set_tolerance});
}

}  // namespace

Control hnc_21m() {
  Control c;
  c.title = "Huazhong HNC-21M";
  reading(c);
  calls_and_returns(c);
  macro_statements(c);
  macro_calls(c);
  parameters(c);
  variables(c);

  motion(c);
  return c;
}

}  // namespace cncsub
