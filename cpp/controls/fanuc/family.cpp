// The rules that the FANUC controls share. The keys of the sources stand in sources.def.
#include "controls/fanuc/family.hpp"

namespace cncsub::fanuc {
namespace {

void reading(Control& c) {
  c.semicolon = {Semicolon::EndOfBlock, cite({kPb155, "that a typed one ends the block is policy"}),
                 Inferred};
  c.percent_programs = {false, cite({kGed, "% opens and closes the file"}), Secondary};
  c.named_programs = {false, kKnown, Inferred};
  c.file_name_wins = {false, kKnown, Inferred};
  c.max_program_number = {9999, cite({kKnown, "eight digits are an option"}), Inferred};
  c.max_sequence_number = {99999, cite({kPb155, kXGo}), Manual};
  c.zero_numbers = {true, cite({kPb155, "0 must not be used, but no alarm is named: policy"}),
                    Inferred};
  c.sequence_number_first = {false, kPolicy, Inferred};
  c.cuts_fine_digits = {true, "general knowledge", Inferred};
  c.late_sequence_numbers = {true, kPolicy, Inferred};
  c.max_words = {26,
                 cite({kAlm, "5006", "not counted: the arguments of a macro call, up to 33 (ZAP)"}),
                 Secondary};
  c.max_block_length = {0, kPolicy, Inferred};
  c.max_digits = {8, cite({kKnown, "alarm text from ALM"}), Inferred};
  c.block_skip = {BlockSkip::Anywhere,
                  cite({kGed, kIso, "the slash inside a block general knowledge"}), Inferred};
  c.repeated_address = {RepeatedAddress::LastWins, cite({kKnown, "3403#6 AD2"}), Inferred};
  c.open_comment = {OpenComment::RestOfBlock, kPolicy, Inferred};
  c.point_addresses = {"ABCEFIJKQRUVWXYZ",
                       cite({kSin, kAlm, "the list, and E of threads, general knowledge"}),
                       Inferred};
  c.minus_addresses = {"ABCEFHIJKQRSUVWXYZ", cite({kKnown, "alarm 006 for M and P from ALM"}),
                       Inferred};
  c.whole_numbers = {WholeNumbers::Increments, cite({kKnown, "3401#0 DPI; GED has seen both"}),
                     Inferred};
  c.missing_end = {MissingEnd::Alarm, cite({kAlm, "5010; 3404#6 EOR"}), Secondary};
  c.m_codes_per_block = {1, cite({kKnown, "3404#7 M3B", kCex487}), Inferred};
  c.m_codes_alarm = {false, cite({kKnown, "3404#7 M3B"}), Inferred};
  c.m_codes_alone = {true, cite({kKnown, "alarm text 5016 from ALM"}), Inferred};
  c.bare_g = {false, cite({kKnown, "005"}), Inferred};
}

void calls_and_returns(Control& c) {
  c.name_marks = {"+-_.", "general knowledge", Inferred};
  c.return_alone_in_modal = {false, "no such alarm is known here", Inferred};
  c.program_word = {ProgramWord::CountAndNumber, cite({kGed, kRob}), Secondary};
  c.max_program_digits = {8, kGed, Secondary};
  c.count_and_l = {CountAndL::AllNumber, kKnown, Inferred};
  c.bracket_names = {false, kKnown, Inferred};
  c.max_name_length = {32, kKnown, Inferred};
  c.wide_names = {false, kKnown, Inferred};
  c.call_values = {CallValues::Rounded, cite({kSin, kJix}), Secondary};
  c.zero_count_alarms = {false, kPolicy, Inferred};
  c.omitted_program = {OmittedProgram::Alarm, cite({kKnown, "076"}), Inferred};
  c.start_word = {StartWord::None, cite({kKnown, "GED knows M98 Q on an 18i-T"}), Inferred};
  c.self_call = {SelfCall::Allowed, cite({kKnown, "only the nesting limit ends it"}), Inferred};
  c.caller_call = {CallerCall::Allowed, cite({kKnown, "only the nesting limit ends it"}), Inferred};
  c.max_repeats = {9999, kRob, Secondary};
  c.zero_repeats = {ZeroRepeats::Once, kPolicy, Inferred};
  c.too_many_repeats = {TooManyRepeats::Alarm, kPolicy, Inferred};
  c.max_nesting = {4, cite({kGed, kCwS, "MC52"}), Secondary};
  c.nesting_counts_macros = {false, cite({kRw, "4 + 4 levels"}), Secondary};
  c.max_macro_nesting = {4, kPb304, Manual};
  c.max_total_nesting = {8, cite({kRw, "4 + 4 levels"}), Secondary};
  c.mdi_calls = {MdiCalls::Allowed, "general knowledge; source 003 says no, for older controls",
                 Inferred};
  c.external_calls = {true, kCl198, Secondary};
  c.device_word = {false, kKnown, Inferred};
  c.return_search = {ReturnSearch::FromHead, cite({"policy", kFin}), Inferred};
  c.return_with_p = {ReturnWithP::AtOnce, kPolicy, Inferred};
  c.return_with_l = {ReturnWithL::Ignored, cite({kKnown, "unsure"}), Inferred};
  c.main_return = {MainReturn::Restarts, cite({kSource003, kGed, "WEI"}), SourceDocument};
  c.jump_m97 = {false, kKnown, Inferred};
  c.restart_m_code = {0, kKnown, Inferred};
  c.calls_in_modal = {CallsInModal::Allowed, kKnown, Inferred};
  c.codes_not_with_return = {"", kKnown, Inferred};
  c.codes_not_with_call = {"", kKnown, Inferred};
  c.words_with_call_in_cycle = {true, cite({kKnown, "5329 only in late editions"}), Inferred};
}

void macro_statements(Control& c) {
  c.reset_clears_locals = {true, "CW-G, parameter 6001#7 CLV", Secondary};
  c.reset_clears_commons = {true, "CW-G, parameter 6001#6 CCV", Secondary};
  c.vacant_system_writes = {true, kPolicy, Inferred};
  c.max_constant_digits = {8, "general knowledge", Inferred};
  c.max_condition_length = {0, kPolicy, Inferred};
  c.statements = {"# [ IF WHILE DO DPRNT BPRNT POPEN PCLOS", cite({kXGo, kFin, kAlm}), Secondary};
  c.if_form = {IfForm::GotoThen, cite({kXGo, kFin}), Secondary};
  c.loop_form = {LoopForm::DoEnd, cite({kXGo, kAlm}), Secondary};
  c.jumps = {true, kXGo, Secondary};
  c.jumps_in_mdi = {false, cite({kAlm, "0123"}), Secondary};
  c.jump_search = {JumpSearch::ForwardThenHead, cite({kFin, "the order is policy"}), Inferred};
  c.max_jump_number = {99999, kXGo, Secondary};
  c.max_loop_number = {3, cite({kAlm, kIso}), Secondary};
  c.max_loops = {3, cite({kKnown, kIso}), Inferred};
  c.loops_count_across_calls = {false, kPolicy, Inferred};
  c.max_ifs = {0, cite({kFin, "no IF blocks: THEN takes one statement"}), Secondary};
  c.max_brackets = {5, cite({kXNul, kAlm}), Secondary};
  c.angle_unit = {AngleUnit::Degrees, kAli, Secondary};
  c.atan_range = {AngleRange::FullTurn, cite({kAli, "6004#0 NAT"}), Secondary};
  c.asin_range = {AngleRange::FullTurn, cite({kAli, "6004#0 NAT"}), Secondary};
  c.joined_conditions = {false, kKnown, Inferred};
  c.comparison_symbols = {false, kKnown, Inferred};
  c.conditions_without_brackets = {false, kXGo, Secondary};
  c.short_functions = {true, kKnown, Inferred};
  c.functions = {"SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP BIN BCD", kAli,
                 Secondary};
  c.modulo = {false, kKnown, Inferred};
  c.vacant_address = {VacantAddress::Ignored, cite({kXia, kJix}), Secondary};
  c.vacant_comparison = {VacantComparison::Distinguished, cite({kM7v, "TSN"}), Secondary};
  c.variable_point = {false, kPolicy, Inferred};
  c.indirect_9nnn = {false, kKnown, Inferred};
  c.negative_logic = {true, cite({kAli, "on 32-bit whole numbers, general knowledge"}), Inferred};
  c.variable_names = {false, kKnown, Inferred};
}

void macro_calls(Control& c) {
  c.codes_not_with_macro_call = {"", "G as an argument is illegal-argument", Inferred};
  c.m_codes_not_with_macro_call = {"", "M is the argument #13", Inferred};
  c.codes_not_with_modal_call = {"", "G as an argument is illegal-argument", Inferred};
  c.macro_calls = {true, cite({kSource002, kPb304}), SourceDocument};
  c.modal_every_block = {false, kKnown, Inferred};
  c.max_macro_digits = {8, cite({kKnown, "a number that no program has is not found"}), Inferred};
  c.argument_sets = {ArgumentSets::ByOrder,
                     cite({kKnown, "6008#7 IJK; agrees with source 002 and PB304"}), Inferred};
  c.numbered_axis_arguments = {false, cite({kZap, "INT"}), Secondary};
  c.call_passes_words = {false, kPb304, Manual};
  c.words_before_macro_call = {WordsBeforeMacroCall::Alarm, cite({"policy", kX65, kPmi39}),
                               Inferred};
  c.repeated_argument = {RepeatedAddress::LastWins, kKnown, Inferred};
  c.modal_locals = {ModalLocals::Kept, kKnown, Inferred};
  c.modal_trigger = {ModalTrigger::Move, cite({kM7v, kNct, kCwA}), Secondary};
  c.modal_calls_stack = {true, cite({kNct, kM7v}), Secondary};
  c.max_modal_calls = {3, "general knowledge: 122, the macro modal call is specified four-fold",
                       Inferred};
  c.cancel_alone = {CancelAlone::Ignored, cite({kKnown, "unsure"}), Inferred};
  c.h_codes = {false, kKnown, Inferred};
  c.code_cascade = {CodeCascade::None, cite({kRw, kKnown}), Secondary};
  c.user_alarm_offset = {3000, cite({kKnown, kGed}), Inferred};
  c.user_alarm_last = {200, kKnown, Inferred};
  c.h99_offset = {0, kKnown, Inferred};
  c.logic_binds_last = {false, cite({kNct, kKnown}), Secondary};
}

}  // namespace

Control family() {
  Control c;
  reading(c);
  calls_and_returns(c);
  macro_statements(c);
  macro_calls(c);
  add_family_parameters(c);
  add_family_variables(c);
  add_family_motion(c);
  return c;
}

void code_calls(Control& c, int last_g, int first_sub_m, int last_sub_m, int first_macro_m,
                int last_macro_m) {
  using Form = CodeCall::Form;
  using Kind = CodeCallKind;
  const std::string sub_source = cite({kSource002, "the limits general knowledge"});
  c.code_calls = {
      // A negative number makes the call modal.
      {Form::List, 'G', Kind::Macro, 6050, 9010, 10, "", 0, 1, last_g, "", sub_source,
       SourceDocument},
      {Form::Range, 'G', Kind::Macro, 6038, 6039, 6040, "", 0, 1, last_g, "", kKnown, Inferred},
      {Form::List, 'M', Kind::Macro, 6080, 9020, 10, "", 0, first_macro_m, last_macro_m, "",
       sub_source, SourceDocument},
      {Form::Range, 'M', Kind::Macro, 6047, 6048, 6049, "", 0, first_macro_m, last_macro_m, "",
       kKnown, Inferred},
      {Form::List, 'M', Kind::Subprogram, 6071, 9001, 9, "", 0, first_sub_m, last_sub_m, "",
       sub_source, SourceDocument},
      {Form::Range, 'M', Kind::Subprogram, 6044, 6045, 6046, "", 0, first_sub_m, last_sub_m, "",
       kKnown, Inferred},
      {Form::Switch, 'T', Kind::Subprogram, 0, 9000, 0, "6001#5", 149, 0, 99999999, "",
       cite({kSource002, kPmi39}), SourceDocument},
      {Form::Switch, 'S', Kind::Subprogram, 0, 9029, 0, "6007#1", 147, 0, 99999999, "", kKnown,
       Inferred},
      {Form::Switch, 'B', Kind::Subprogram, 0, 9028, 0, "6007#2", 146, 0, 99999999, "", kKnown,
       Inferred},
      // The parameter holds the letter.
      {Form::List, '@', Kind::Subprogram, 6090, 9004, 1, "", 146, 0, 99999999, "", kPmi39, Manual},
      {Form::List, '@', Kind::Subprogram, 6091, 9005, 1, "", 147, 0, 99999999, "", kPmi39, Manual},
  };
}

void domain_alarms(Control& c, Cause shown) {
  for (const Cause cause : {Cause::LogarithmOfNonPositive, Cause::ArcSineOutOfRange}) {
    c.alarms[cause] = c.alarms[shown];
    c.alarms[cause].source += " has the number; that it is raised here is inferred";
    c.alarms[cause].evidence = Inferred;
  }
}

}  // namespace cncsub::fanuc
