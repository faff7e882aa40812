// GSK 928TE lathe, the control of source 001.
#include "controls/gsk/family.hpp"

namespace cncsub {

using namespace gsk;

namespace {

/// Set the calls of parts of the same program. M97 jumps; there are no macro statements, and no
/// alarm number is known.
void read_928(Control& c) {
  c.reading.semicolon = {Semicolon::EndOfBlock, kGeneral, Inferred};
  has(c.reading.program_heads, {ProgramHead::Percent}, kT928 + "%254", Manual);
  lacks(c.reading.program_heads, {ProgramHead::Name}, kGeneral, Inferred);
  c.reading.max_program_number = {254, kT928 + "%254", Manual};
  c.reading.max_sequence_number = {9999, k001 + "N of four digits", SourceDocument};
  c.reading.cuts_fine_digits = {false, kPolicy, Inferred};
  c.reading.late_sequence_numbers = {true, kPolicy, Inferred};
  c.reading.max_words = {0, kPolicy, Inferred};
  c.reading.max_block_length = {0, kPolicy, Inferred};
  c.reading.max_digits = {8, kGeneral, Inferred};
  c.reading.block_skip = {BlockSkip::HeadOnly, kGeneral, Inferred};
  c.reading.repeated_address = {RepeatedAddress::LastWins, kPolicy, Inferred};
  c.reading.open_comment = {OpenComment::RestOfBlock, kPolicy, Inferred};
  c.reading.point_addresses = {"ABCDEFIJKQRUVWXYZ", kGeneral, Inferred};
  c.reading.minus_addresses = {"ABCDEFHIJKLQRSUVWXYZ",
                               kGeneral + "; a negative L is a value out of range", Inferred};
  c.reading.whole_numbers = {WholeNumbers::Millimetres, k001 + "Fig. 3-1", SourceDocument};
  c.reading.missing_end = {MissingEnd::Alarm, kPolicy, Inferred};
  c.reading.m_codes_per_block = {1, kGeneral, Inferred};
  c.reading.extra_m_codes = {ExtraMCodes::Dropped, kGeneral, Inferred};
  c.reading.bare_g = {false, kPolicy, Inferred};
  c.reading.g_codes = {"0 1 2 3 4 22 26 27 29 33 50 80 96 97 98 99",
                       "source 001 names G00 and G01, 928Ti G04; the rest " + kGeneral, Inferred};
  c.reading.unlisted_codes = {UnlistedCode::NotKnown, "policy: no list is known", Inferred};
}

void call_928(Control& c) {
  c.calls.name_marks = {"", "general knowledge: there are no names", Inferred};
  c.calls.program_word = {ProgramWord::SequenceNumber, k001 + "M98 P0060 L5", SourceDocument};
  c.calls.max_program_digits = {4, k001 + "N of four digits", SourceDocument};
  c.calls.count_and_l = {CountAndL::AllNumber, k001 + "M98 P0060 L5", SourceDocument};
  c.calls.bracket_names = {false, kGeneral, Inferred};
  c.calls.wide_names = {false, kPolicy + "; programs have no names", Inferred};
  c.calls.max_name_length = {32, kPolicy + "; programs have no names", Inferred};
  c.calls.call_values = {CallValues::Cut, kPolicy, Inferred};
  lacks(c.common.refuses, {Cause::IllegalRepeatCount}, k001 + "P holds no count", SourceDocument);
  c.calls.omitted_program = {OmittedProgram::Alarm, kPolicy, Inferred};
  c.calls.start_word = {StartWord::None, k001 + "P is the start", SourceDocument};
  c.calls.self_call = {SelfCall::Allowed, k001 + "every call is one of the own program",
                       SourceDocument};
  c.calls.caller_call = {CallerCall::Allowed, k001 + "every call is one of the own program",
                         SourceDocument};
  c.calls.max_repeats = {9999, kPolicy, Inferred};
  c.calls.zero_repeats = {ZeroRepeats::Once, kPolicy, Inferred};
  c.calls.too_many_repeats = {TooManyRepeats::Alarm, kPolicy, Inferred};
  c.calls.max_nesting = {18, k001 + "18 levels", SourceDocument};
  c.calls.nesting_counts_macros = {false, kGeneral + ": there are no macro calls", Inferred};
  c.calls.max_macro_nesting = {4, kPolicy + "; there are no macro calls", Inferred};
  c.calls.max_total_nesting = {0, k001 + "18 levels", SourceDocument};
  c.calls.mdi_calls = {MdiCalls::Refused, kGeneral + ": MDI runs single blocks", Inferred};
  no_role(c.calls.roles, {"M198"}, kGeneral, Inferred);
  c.calls.device_word = {false, kGeneral, Inferred};
  c.calls.return_search = {ReturnSearch::FromHead, kPolicy + "; source 001 has two blocks N0140",
                           Inferred};
  c.calls.return_with_p = {ReturnWithP::Refused, "inferred from source 001, which knows M99 alone",
                           Inferred};
  c.calls.return_with_l = {ReturnWithL::Ignored, kPolicy, Inferred};
  c.calls.main_return = {MainReturn::Ends, k001 + "M99 without M98", SourceDocument};
  no_role(c.calls.roles, {"G65", "G66", "G67"}, kGeneral + ": no macro statements", Inferred);
  give_role(c.calls.roles, "M97", Role::Jump, k001 + "M97", SourceDocument);
  give_role(c.calls.roles, "M20", Role::StartOver, kGeneral, Inferred);
  c.calls.calls_in_modal = {CallsInModal::Allowed, kPolicy + "; there are no modal calls",
                            Inferred};
  c.calls.codes_not_with_return = {"", kPolicy, Inferred};
  c.calls.codes_not_with_call = {"", kPolicy, Inferred};
}

/// Leave out macros: its jumps are M97, and the r variables of the 928T are of another kind.
void no_macros_928(Control& c) {
  const std::string none = kGeneral + ": no macro statements";
  leave_out(c, RuleGroup::MacroRules, none, Inferred);
  has(c.common.refuses, {Cause::JumpInMdi}, none, Inferred);
  lacks(c.common.reset_clears, {Cleared::Commons}, kPolicy, Inferred);
  c.calls.jump_search = {JumpSearch::FromHead, kPolicy + "; source 001 has two blocks N0140",
                         Inferred};
  c.calls.max_jump_number = {9999, k001 + "N of four digits", SourceDocument};
}

}  // namespace

Control gsk_928te() {
  Control c;
  c.title = "GSK 928TE lathe";
  read_928(c);
  call_928(c);
  no_macros_928(c);
  add_lathe_motion(c);
  c.motion.machine = {MachineType::LatheA, "source 001, Fig. 3-1: U is a diameter increment",
                      SourceDocument};
  lacks(c.common.power_on, {PowerOn::G95}, "source 001: F80, F500", SourceDocument);
  c.motion.g_meanings = {
      "22=not-computed 26=not-computed 27=not-computed 29=not-computed 33=not-computed "
      "80=not-computed",
      "general knowledge: G22 to G80 is a loop, G26, G27 and G29 return to points", Inferred};
  c.motion.dwell_words = {"PXUD", "928Ti: G4 D1 is a second", Secondary};
  lacks(c.common.power_on, {PowerOn::G01}, kGeneral, Inferred);
  c.motion.arc_tolerance = {0, kPolicy, Inferred};
  return c;
}

}  // namespace cncsub
