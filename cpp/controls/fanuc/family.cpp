// The rules that the FANUC controls share. The keys of the sources stand in sources.def.
#include "controls/fanuc/family.hpp"

namespace cncsub::fanuc {
namespace {

// The list of a SINUMERIK that runs programs for FANUC mills.
constexpr const char* kIsoM = "802DM p.44, list of M commands";

void reading(Control& c) {
  c.reading.semicolon = {Semicolon::EndOfBlock,
                         cite({kPb155, "that a typed one ends the block is policy"}), Inferred};
  lacks(c.reading.program_heads, {ProgramHead::Percent},
        cite({kGed, "% opens and closes the file"}), Secondary);
  lacks(c.reading.program_heads, {ProgramHead::Name, ProgramHead::File}, kKnown, Inferred);
  c.reading.max_program_number = {9999, cite({kKnown, "eight digits are an option"}), Inferred};
  c.reading.max_sequence_number = {99999, cite({kPb155, kXGo}), Manual};
  lacks(c.common.refuses, {Cause::ProgramNumberZero},
        cite({kPb155, "0 must not be used, but no alarm is named: policy"}), Inferred);
  c.reading.cuts_fine_digits = {true, "general knowledge", Inferred};
  c.reading.late_sequence_numbers = {true, kPolicy, Inferred};
  c.reading.max_words = {
      26, cite({kAlm, "5006", "not counted: the arguments of a macro call, up to 33 (ZAP)"}),
      Secondary};
  c.reading.max_block_length = {0, kPolicy, Inferred};
  c.reading.max_digits = {8, cite({kKnown, "alarm text from ALM"}), Inferred};
  c.reading.block_skip = {BlockSkip::Anywhere,
                          cite({kGed, kIso, "the slash inside a block general knowledge"}),
                          Inferred};
  c.reading.repeated_address = {RepeatedAddress::LastWins, cite({kKnown, "3403#6 AD2"}), Inferred};
  c.reading.open_comment = {OpenComment::RestOfBlock, kPolicy, Inferred};
  c.reading.point_addresses = {
      "ABCEFIJKQRUVWXYZ",
      cite({kGed, "whole numbers at O N G M T H D P L, threads at E", kSin, "whole numbers at S"}),
      Secondary};
  c.reading.computed_whole = {"PS", cite({kSin, "of all addresses of whole numbers"}), Secondary};
  c.reading.minus_addresses = {"ABCEFHIJKQRSUVWXYZ",
                               cite({kKnown, "alarm 006 for M and P from ALM"}), Inferred};
  c.reading.whole_numbers = {WholeNumbers::Increments,
                             cite({kKnown, "3401#0 DPI; GED has seen both"}), Inferred};
  c.reading.missing_end = {MissingEnd::Alarm, cite({kAlm, "5010; 3404#6 EOR"}), Secondary};
  c.reading.m_codes_per_block = {1, cite({kKnown, "3404#7 M3B", kCex487}), Inferred};
  c.reading.extra_m_codes = {ExtraMCodes::EndsAlone,
                             cite({kKnown, "3404#7 M3B", "alarm text 5016 from ALM"}), Inferred};
  c.reading.bare_g = {false, cite({kKnown, "005"}), Inferred};
}

void roles_of_codes(Control& c) {
  give_role(c.calls.roles, "M198", Role::ExternalCall, kCl198, Secondary);
  give_role(c.calls.roles, "M98", Role::Call, "source 003, M98 P", SourceDocument);
  give_role(c.calls.roles, "M99", Role::Return, "source 003, M99", SourceDocument);
  give_role(c.calls.roles, "M30", Role::End, "source 003, end of the program", SourceDocument);
  give_role(c.calls.roles, "M03", Role::SpindleForward, "source 003, M03", SourceDocument);
  give_role(c.calls.roles, "M05", Role::SpindleStop, "source 003, M05", SourceDocument);
  give_role(c.calls.roles, "M00", Role::Stop, kIsoM, Secondary);
  give_role(c.calls.roles, "M01", Role::OptionalStop, kIsoM, Secondary);
  give_role(c.calls.roles, "M02", Role::End, kIsoM, Secondary);
  give_role(c.calls.roles, "M04", Role::SpindleBackward, kIsoM, Secondary);
  give_role(c.calls.roles, "M06", Role::ToolChange, kIsoM, Secondary);
  give_role(c.calls.roles, "M29", Role::RigidTapping, "0iB p.540: M29 S1000 before G84", Manual);
}

void calls_and_returns(Control& c) {
  c.calls.name_marks = {"+-_.", "general knowledge", Inferred};
  lacks(c.common.refuses, {Cause::IllegalWordWithReturn}, "general knowledge: no such alarm",
        Inferred);
  c.calls.program_word = {ProgramWord::CountAndNumber, cite({kGed, kRob}), Secondary};
  c.calls.max_program_digits = {8, kGed, Secondary};
  c.calls.count_and_l = {CountAndL::AllNumber, kKnown, Inferred};
  c.calls.bracket_names = {false, kKnown, Inferred};
  c.calls.max_name_length = {32, kKnown, Inferred};
  c.calls.wide_names = {false, kKnown, Inferred};
  c.calls.call_values = {CallValues::Rounded, cite({kSin, kJix}), Secondary};
  c.calls.omitted_program = {OmittedProgram::Alarm, cite({kKnown, "076"}), Inferred};
  c.calls.start_word = {StartWord::None, cite({kKnown, "GED knows M98 Q on an 18i-T"}), Inferred};
  c.calls.self_call = {SelfCall::Allowed, cite({kKnown, "only the nesting limit ends it"}),
                       Inferred};
  c.calls.caller_call = {CallerCall::Allowed, cite({kKnown, "only the nesting limit ends it"}),
                         Inferred};
  c.calls.max_repeats = {9999, kRob, Secondary};
  c.calls.zero_repeats = {ZeroRepeats::Once, kPolicy, Inferred};
  c.calls.too_many_repeats = {TooManyRepeats::Alarm, kPolicy, Inferred};
  c.calls.max_nesting = {4, cite({kGed, kCwS, "MC52"}), Secondary};
  c.calls.nesting_counts_macros = {false, cite({kRw, "4 + 4 levels"}), Secondary};
  c.calls.max_macro_nesting = {4, kPb304, Manual};
  c.calls.max_total_nesting = {8, cite({kRw, "4 + 4 levels"}), Secondary};
  c.calls.mdi_calls = {MdiCalls::Allowed,
                       "general knowledge; source 003 says no, for older controls", Inferred};
  roles_of_codes(c);
  c.calls.device_word = {false, kKnown, Inferred};
  c.calls.return_search = {ReturnSearch::FromHead, cite({"policy", kFin}), Inferred};
  c.calls.return_with_p = {ReturnWithP::AtOnce, kPolicy, Inferred};
  c.calls.return_with_l = {ReturnWithL::Ignored, cite({kKnown, "unsure"}), Inferred};
  c.calls.main_return = {MainReturn::Restarts, cite({kSource003, kGed, "WEI"}), SourceDocument};
  no_role(c.calls.roles, {"M97"}, kKnown, Inferred);
  c.calls.calls_in_modal = {CallsInModal::Allowed, kKnown, Inferred};
  c.calls.codes_not_with_return = {"", kKnown, Inferred};
  c.calls.codes_not_with_call = {"", kKnown, Inferred};
  lacks(c.common.refuses, {Cause::CallWithWordsInCycle},
        cite({kKnown, "5329 only in late editions"}), Inferred);
}

void macro_statements(Control& c) {
  has(c.common.reset_clears, {Cleared::Locals}, "CW-G, parameter 6001#7 CLV", Secondary);
  has(c.common.reset_clears, {Cleared::Commons}, "CW-G, parameter 6001#6 CCV", Secondary);
  c.macros.max_constant_digits = {8, "general knowledge", Inferred};
  c.macros.max_condition_length = {0, kPolicy, Inferred};
  c.macros.statements = {"# [ IF WHILE DO GOTO DPRNT BPRNT POPEN PCLOS", cite({kXGo, kFin, kAlm}),
                         Secondary};
  c.macros.if_form = {IfForm::GotoThen, cite({kXGo, kFin}), Secondary};
  c.macros.loop_form = {LoopForm::DoEnd, cite({kXGo, kAlm}), Secondary};
  has(c.common.refuses, {Cause::JumpInMdi}, cite({kAlm, "0123"}), Secondary);
  c.calls.jump_search = {JumpSearch::ForwardThenHead, cite({kFin, "the order is policy"}),
                         Inferred};
  c.calls.max_jump_number = {99999, kXGo, Secondary};
  c.macros.max_loop_number = {3, cite({kAlm, kIso}), Secondary};
  c.macros.max_loops = {3, cite({kKnown, kIso}), Inferred};
  c.macros.loops_count_across_calls = {false, kPolicy, Inferred};
  c.macros.max_ifs = {0, cite({kFin, "no IF blocks: THEN takes one statement"}), Secondary};
  c.macros.max_brackets = {5, cite({kXNul, kAlm}), Secondary};
  c.macros.angle_unit = {AngleUnit::Degrees, kAli, Secondary};
  c.macros.atan_range = {AngleRange::FullTurn, cite({kAli, "6004#0 NAT"}), Secondary};
  c.macros.asin_range = {AngleRange::FullTurn, cite({kAli, "6004#0 NAT"}), Secondary};
  lacks(c.macros.conditions, {Condition::Joined, Condition::Symbols}, kKnown, Inferred);
  lacks(c.macros.conditions, {Condition::Bare}, kXGo, Secondary);
  c.macros.short_functions = {true, kKnown, Inferred};
  c.macros.functions = {"SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP BIN BCD", kAli,
                        Secondary};
  c.macros.vacant_address = {VacantAddress::Ignored, cite({kXia, kJix}), Secondary};
  c.macros.vacant_comparison = {VacantComparison::Distinguished, cite({kM7v, "TSN"}), Secondary};
  lacks(c.macros.variable_forms, {VariableForm::Indirect, VariableForm::Names}, kKnown, Inferred);
  lacks(c.common.refuses, {Cause::LogicOfNegative},
        cite({kAli, "on 32-bit whole numbers, general knowledge"}), Inferred);
}

void macro_calls(Control& c) {
  c.macros.codes_not_with_macro_call = {
      "", "general knowledge: G as an argument is illegal-argument", Inferred};
  c.macros.m_codes_not_with_macro_call = {"", "general knowledge: M is the argument #13", Inferred};
  c.macros.codes_not_with_modal_call = {
      "", "general knowledge: G as an argument is illegal-argument", Inferred};
  give_role(c.calls.roles, "G65", Role::MacroCall, cite({kSource002, kPb304}), SourceDocument);
  give_role(c.calls.roles, "G66", Role::ModalCall, kPb304, Manual);
  give_role(c.calls.roles, "G67", Role::CancelModal, "CW-A", Secondary);
  no_role(c.calls.roles, {"G66.1"}, kKnown, Inferred);
  c.macros.h_codes = {false, kKnown, Inferred};
  c.macros.max_macro_digits = {8, cite({kKnown, "a number that no program has is not found"}),
                               Inferred};
  c.macros.argument_sets = {ArgumentSets::ByOrder,
                            cite({kKnown, "6008#7 IJK; agrees with source 002 and PB304"}),
                            Inferred};
  c.macros.numbered_axis_arguments = {false, cite({kZap, "INT"}), Secondary};
  c.macros.call_passes_words = {false, kPb304, Manual};
  c.macros.words_before_macro_call = {WordsBeforeMacroCall::Alarm, cite({"policy", kX65, kPmi39}),
                                      Inferred};
  c.macros.repeated_argument = {RepeatedAddress::LastWins, kKnown, Inferred};
  c.macros.modal_locals = {ModalLocals::Kept, kKnown, Inferred};
  c.macros.modal_trigger = {ModalTrigger::Move, cite({kM7v, kNct, kCwA}), Secondary};
  c.macros.second_modal_call = {SecondModal::Stacks, cite({kNct, kM7v}), Secondary};
  c.macros.max_modal_calls = {
      3, "general knowledge: 122, the macro modal call is specified four-fold", Inferred};
  c.macros.cancel_alone = {CancelAlone::Ignored, cite({kKnown, "unsure"}), Inferred};
  c.macros.code_cascade = {CodeCascade::None, cite({kRw, kKnown}), Secondary};
  c.macros.user_alarm_offset = {3000, cite({kKnown, kGed}), Inferred};
  c.macros.user_alarm_last = {200, kKnown, Inferred};
  c.macros.h99_offset = {0, kKnown, Inferred};
  c.macros.logic_order = {LogicOrder::LikeArithmetic, cite({kNct, kKnown}), Secondary};
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
       SourceDocument, true, false, "6007#3"},
      {Form::Range, 'G', Kind::Macro, 6038, 6039, 6040, "", 0, 1, last_g, "", kKnown, Inferred,
       true, false, "6007#3"},
      {Form::Range, 'G', Kind::Macro, 6041, 6042, 6043, "", 0, 1, last_g, "", kKnown, Inferred,
       true, true, "6007#3"},
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
