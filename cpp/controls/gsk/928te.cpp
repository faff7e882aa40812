// GSK 928TE lathe, the control of source 001.
#include "controls/gsk/family.hpp"

namespace cncsub {

using namespace gsk;

namespace {

/// Calls of parts of the same program; M97 jumps, no macro statements, no alarm number known.
void read_928(Control& c) {
  c.semicolon = {Semicolon::EndOfBlock, kGeneral, Inferred};
  c.percent_programs = {true, kT928 + "%254", Manual};
  c.named_programs = {false, kGeneral, Inferred};
  c.file_name_wins = {false, kPolicy, Inferred};
  c.max_program_number = {254, kT928 + "%254", Manual};
  c.max_sequence_number = {9999, k001 + "N of four digits", SourceDocument};
  c.zero_numbers = {true, kPolicy, Inferred};
  c.sequence_number_first = {false, kPolicy, Inferred};
  c.max_words = {0, kPolicy, Inferred};
  c.max_block_length = {0, kPolicy, Inferred};
  c.max_digits = {8, kGeneral, Inferred};
  c.block_skip = {BlockSkip::HeadOnly, kGeneral, Inferred};
  c.repeated_address = {RepeatedAddress::LastWins, kPolicy, Inferred};
  c.open_comment = {OpenComment::RestOfBlock, kPolicy, Inferred};
  c.point_addresses = {"ABCDEFIJKQRUVWXYZ", kGeneral, Inferred};
  c.minus_addresses = {"ABCDEFHIJKLQRSUVWXYZ", kGeneral + "; a negative L is a value out of range",
                       Inferred};
  c.whole_numbers = {WholeNumbers::Millimetres, k001 + "Fig. 3-1", SourceDocument};
  c.missing_end = {MissingEnd::Alarm, kPolicy, Inferred};
  c.m_codes_per_block = {1, kGeneral, Inferred};
  c.m_codes_alarm = {false, kGeneral, Inferred};
  c.m_codes_alone = {false, kPolicy, Inferred};
  c.bare_g = {false, kPolicy, Inferred};
  c.g_codes = {"0 1 2 3 4 22 26 27 29 33 50 80 96 97 98 99",
               "source 001 names G00 and G01, 928Ti G04; the rest " + kGeneral, Inferred};
  c.g_codes_complete = {false, "no list is known", Inferred};
}

void call_928(Control& c) {
  c.name_marks = {"", "there are no names", Inferred};
  c.return_alone_in_modal = {false, kPolicy, Inferred};
  c.cuts_fine_digits = {false, kPolicy, Inferred};
  c.late_sequence_numbers = {true, kPolicy, Inferred};
  c.program_word = {ProgramWord::SequenceNumber, k001 + "M98 P0060 L5", SourceDocument};
  c.max_program_digits = {4, k001 + "N of four digits", SourceDocument};
  c.count_and_l = {CountAndL::AllNumber, k001 + "M98 P0060 L5", SourceDocument};
  c.bracket_names = {false, kGeneral, Inferred};
  c.wide_names = {false, kPolicy + "; programs have no names", Inferred};
  c.max_name_length = {32, kPolicy + "; programs have no names", Inferred};
  c.call_values = {CallValues::Cut, kPolicy, Inferred};
  c.zero_count_alarms = {false, k001 + "P holds no count", SourceDocument};
  c.omitted_program = {OmittedProgram::Alarm, kPolicy, Inferred};
  c.start_word = {StartWord::None, k001 + "P is the start", SourceDocument};
  c.self_call = {SelfCall::Allowed, k001 + "every call is one of the own program", SourceDocument};
  c.caller_call = {CallerCall::Allowed, k001 + "every call is one of the own program",
                   SourceDocument};
  c.max_repeats = {9999, kPolicy, Inferred};
  c.zero_repeats = {ZeroRepeats::Once, kPolicy, Inferred};
  c.too_many_repeats = {TooManyRepeats::Alarm, kPolicy, Inferred};
  c.max_nesting = {18, k001 + "18 levels", SourceDocument};
  c.nesting_counts_macros = {false, kGeneral + ": there are no macro calls", Inferred};
  c.max_macro_nesting = {4, kPolicy + "; there are no macro calls", Inferred};
  c.max_total_nesting = {0, k001 + "18 levels", SourceDocument};
  c.mdi_calls = {MdiCalls::Refused, kGeneral + ": MDI runs single blocks", Inferred};
  c.external_calls = {false, kGeneral, Inferred};
  c.device_word = {false, kGeneral, Inferred};
  c.return_search = {ReturnSearch::FromHead, kPolicy + "; source 001 has two blocks N0140",
                     Inferred};
  c.return_with_p = {ReturnWithP::Refused, "inferred from source 001, which knows M99 alone",
                     Inferred};
  c.return_with_l = {ReturnWithL::Ignored, kPolicy, Inferred};
  c.main_return = {MainReturn::Ends, k001 + "M99 without M98", SourceDocument};
  c.jump_m97 = {true, k001 + "M97", SourceDocument};
  c.restart_m_code = {20, kGeneral, Inferred};
  c.calls_in_modal = {CallsInModal::Allowed, kPolicy + "; there are no modal calls", Inferred};
  c.codes_not_with_return = {"", kPolicy, Inferred};
  c.codes_not_with_call = {"", kPolicy, Inferred};
  c.words_with_call_in_cycle = {true, kPolicy, Inferred};
}

/// The 928TE has none of these: its jumps are M97, and the r variables of the 928T are of another
/// kind.
void no_macros_928(Control& c) {
  c.reset_clears_locals = {true, kPolicy, Inferred};
  c.reset_clears_commons = {false, kPolicy, Inferred};
  c.vacant_system_writes = {true, kPolicy, Inferred};
  c.max_constant_digits = {12, kPolicy, Inferred};
  c.max_condition_length = {0, kPolicy, Inferred};
  c.codes_not_with_macro_call = {"", "there are no macro calls", Inferred};
  c.m_codes_not_with_macro_call = {"", "there are no macro calls", Inferred};
  c.codes_not_with_modal_call = {"", "there are no macro calls", Inferred};
  const std::string none = kGeneral + ": no macro statements";
  c.statements = {"", none, Inferred};
  c.commons = {"", none, Inferred};
  c.variable_options = {"", none, Inferred};
  c.if_form = {IfForm::GotoThen, none, Inferred};
  c.loop_form = {LoopForm::DoEnd, none, Inferred};
  c.jumps = {false, k001 + "jumps are M97", SourceDocument};
  c.jumps_in_mdi = {false, none, Inferred};
  c.jump_search = {JumpSearch::FromHead, kPolicy + "; source 001 has two blocks N0140", Inferred};
  c.max_jump_number = {9999, k001 + "N of four digits", SourceDocument};
  c.max_loop_number = {3, none, Inferred};
  c.max_loops = {3, none, Inferred};
  c.loops_count_across_calls = {false, none, Inferred};
  c.max_ifs = {10, none, Inferred};
  c.max_brackets = {5, none, Inferred};
  c.angle_unit = {AngleUnit::Degrees, none, Inferred};
  c.atan_range = {AngleRange::FullTurn, none, Inferred};
  c.asin_range = {AngleRange::FullTurn, none, Inferred};
  c.joined_conditions = {false, none, Inferred};
  c.comparison_symbols = {false, none, Inferred};
  c.conditions_without_brackets = {false, none, Inferred};
  c.short_functions = {false, none, Inferred};
  c.functions = {"", none, Inferred};
  c.modulo = {false, none, Inferred};
  c.vacant_address = {VacantAddress::Zero, none, Inferred};
  c.vacant_comparison = {VacantComparison::Zero, none, Inferred};
  c.variable_point = {false, kPolicy, Inferred};
  c.indirect_9nnn = {false, none, Inferred};
  c.negative_logic = {true, none, Inferred};
  c.variable_names = {false, none, Inferred};
  c.logic_binds_last = {false, none, Inferred};
  c.macro_calls = {false, none, Inferred};
  c.modal_every_block = {false, none, Inferred};
  c.max_macro_digits = {4, none, Inferred};
  c.argument_sets = {ArgumentSets::ByOrder, none, Inferred};
  c.numbered_axis_arguments = {false, none, Inferred};
  c.call_passes_words = {false, k001 + "M98 P L", SourceDocument};
  c.words_before_macro_call = {WordsBeforeMacroCall::Alarm, none, Inferred};
  c.repeated_argument = {RepeatedAddress::LastWins, none, Inferred};
  c.modal_locals = {ModalLocals::Rewritten, none, Inferred};
  c.modal_trigger = {ModalTrigger::Move, none, Inferred};
  c.modal_calls_stack = {false, none, Inferred};
  c.max_modal_calls = {4, none, Inferred};
  c.cancel_alone = {CancelAlone::Alarm, none, Inferred};
  c.h_codes = {false, none, Inferred};
  c.code_cascade = {CodeCascade::None, none, Inferred};
  c.user_alarm_offset = {0, none, Inferred};
  c.user_alarm_last = {0, none, Inferred};
  c.h99_offset = {0, none, Inferred};
}

}  // namespace

Control gsk_928te() {
  Control c;
  c.title = "GSK 928TE lathe";
  read_928(c);
  call_928(c);
  no_macros_928(c);
  c.parameters = {
      {"3401#0", 1, "lengths without a point: 0 least increments, 1 millimetres",
       k001 + "Fig. 3-1; " + kStands, Inferred,
       [](Control& k, double value) {
         k.whole_numbers.value = value != 0 ? WholeNumbers::Millimetres : WholeNumbers::Increments;
       }},
  };

  add_lathe_motion(c);
  c.machine = {MachineType::LatheA, "source 001, Fig. 3-1: U is a diameter increment",
               SourceDocument};
  c.power_on_per_minute = {true, "source 001: F80, F500", SourceDocument};
  c.g_meanings = {
      "22=not-computed 26=not-computed 27=not-computed 29=not-computed 33=not-computed "
      "80=not-computed",
      "general knowledge: G22 to G80 is a loop, G26, G27 and G29 return to points", Inferred};
  c.dwell_words = {"PXUD", "928Ti: G4 D1 is a second", Secondary};
  add_parameter(c, {"3402#0", 0, "power-on: 0 in G00, 1 in G01", kGeneral + "; " + kStands,
                    Inferred, set_power_on_line});
  add_parameter(c, {"3410", 0, "how far the radii of an arc's start and end may differ, 0 = any",
                    kStands, Inferred, set_tolerance});
  return c;
}

}  // namespace cncsub
