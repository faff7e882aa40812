// Mazak MAZATROL Smooth, the EIA/ISO programs of its machining centres. A member of the Mitsubishi
// family with Q for H and numbers of its own.
// The keys of the sources stand in sources.def. MZL is its maker's list of alarms, MZG its maker's
// list of G codes, OB the maker's chapter on M98. What they do not say is as on a Mitsubishi.
#include "controls/mitsubishi/family.hpp"

namespace cncsub {
namespace {

using namespace mitsubishi;

const std::string kMZL = "MZL ";
const std::string kMZG = "MZG, ";
const std::string kKin = "general knowledge: as on a Mitsubishi";

// The codes of the milling machine, and those that a turning centre has besides: INTEGREX e-670H.
constexpr const char* kGCodes =
    "0 1 1.1 2 2.1 3 3.1 4 5 6.1 6.2 7 7.1 9 10 10.1 10.9 11 12.1 13.1 15 16 17 18 19 20 21 22 23 "
    "27 28 29 30 31 31.1 31.2 31.3 32 33 34 34.1 35 36 37 37.1 38 39 40 41 41.2 41.5 42 42.2 42.5 "
    "43 43.1 43.4 43.5 43.8 43.9 44 45 46 47 48 49 50 50.1 50.2 51 51.1 51.2 52 53 53.1 "
    "54 54.1 54.2 54.4 55 56 57 58 59 60 61 61.1 61.2 62 63 64 65 66 66.1 67 68 68.2 68.3 68.4 69 "
    "71.1 72.1 73 74 75 76 77 78 79 80 81 82 82.2 83 84 84.2 84.3 85 86 87 88 89 90 91 92 92.5 93 "
    "94 95 96 97 98 99 109 110 111 112 113 114.3 130 136 137 140 148 149 "
    "270 271 272 273 274 275 276 283 284 284.2 285 287 288 288.2 289 290 292 294";

void reading(Control& c) {
  c.reading.max_program_number = {
      99999999, "general knowledge: eight digits; the remedy of MZL 811 says 1 to 999999",
      Inferred};
  c.reading.max_sequence_number = {99999, kMZL + "811: N from 1 to 99999", Secondary};
  has(c.common.refuses, {Cause::ProgramNumberZero}, kMZL + "811", Secondary);
  has(c.reading.program_heads, {ProgramHead::Name, ProgramHead::File}, kKin, Inferred);
  c.reading.max_digits = {15, kPolicy + "; ranges are checked address by address, " + kMZL + "809",
                          Inferred};
  c.reading.missing_end = {MissingEnd::Alarm, kMZL + "810: M02, M30 or M99 ends a program",
                           Secondary};
  c.reading.bare_g = {true, kKin, Inferred};
  c.reading.g_codes = {kGCodes, kMZG + "pp. 3-11 to 3-14", Secondary};
}

void calling(Control& c) {
  c.calls.start_word = {StartWord::Q, kOB + "M98 P Q L", Secondary};
  c.calls.program_word = {ProgramWord::Number, kOB + "P is the program number", Secondary};
  c.calls.max_program_digits = {8, kKin, Inferred};
  c.calls.count_and_l = {CountAndL::AllNumber, kOB + "P is the program number", Secondary};
  c.calls.max_name_length = {32, kKin, Inferred};
  c.calls.omitted_program = {OmittedProgram::Own, kKin, Inferred};
  c.calls.max_repeats = {9999, kKin, Inferred};
  c.calls.zero_repeats = {ZeroRepeats::Skip, kKin, Inferred};
  c.calls.too_many_repeats = {TooManyRepeats::Alarm, kMZL + "809", Secondary};
  c.calls.max_nesting = {8, kMZL + "842: more than eight; OB: eight levels", Secondary};
  c.calls.nesting_counts_macros = {true, kKin, Inferred};
  c.calls.max_macro_nesting = {4, kKin + "; MZL 855 says no number", Inferred};
  c.calls.max_total_nesting = {0, kKin, Inferred};
  c.calls.mdi_calls = {MdiCalls::Allowed, kKin, Inferred};
  c.calls.device_word = {false, "general knowledge: ,D is the M700's", Inferred};
  c.calls.main_return = {MainReturn::Restarts,
                         kMZL +
                             "842: M99 is refused in a main program only where it runs from a "
                             "disk or from Ethernet",
                         Secondary};
  c.calls.max_jump_number = {99999, kMZL + "811: N from 1 to 99999", Secondary};
  c.calls.call_words_not_computed = {
      "IJK", kMZL + "823, 848 to 850: M98 that rotates a figure; its words general knowledge",
      Inferred};
  give_role(c.calls.roles, "M198", Role::ExternalCall, kKin + "; MZL 842, programs of a disk",
            Inferred);
}

void macros(Control& c) {
  give_role(c.calls.roles, "G65", Role::MacroCall, kMZG + "G65, p. 13-114", Secondary);
  give_role(c.calls.roles, "G66", Role::ModalCall,
            kMZG + "G66, p. 13-114: after each block that moves, until G67", Secondary);
  give_role(c.calls.roles, "G66.1", Role::ModalCallEveryBlock, kMZG + "G66.1, modal call B",
            Secondary);
  c.macros.modal_trigger = {ModalTrigger::Move, kMZG + "G66, p. 13-114", Secondary};
  c.macros.max_macro_digits = {8, kKin, Inferred};
  c.macros.max_modal_calls = {4, kKin, Inferred};
  c.macros.second_modal_call = {SecondModal::Stacks, kKin, Inferred};
  c.macros.call_passes_words = {false, kKin, Inferred};
  c.macros.argument_sets = {ArgumentSets::ByOrder,
                            kMZL + "856: sets of type II, too many; their number general knowledge",
                            Secondary};
  c.macros.cancel_alone = {CancelAlone::Alarm, kMZL + "857", Secondary};
  c.macros.if_form = {IfForm::GotoThen, kMZL + "864: IF GOTO; IF THEN is general knowledge",
                      Inferred};
  c.macros.loop_form = {LoopForm::DoEnd, kMZL + "865, 868", Secondary};
  c.macros.max_loops = {27, kMZL + "867: more than 27", Secondary};
  c.macros.max_brackets = {5, kMZL + "858: more than five", Secondary};
  c.macros.word_arithmetic = {true, kKin, Inferred};
  c.macros.vacant_comparison = {VacantComparison::Distinguished, kKin, Inferred};
  lacks(c.macros.conditions, {Condition::Bare}, kMZL + "864: a condition", Secondary);
  has(c.macros.variable_forms, {VariableForm::Point}, kKin, Inferred);
  has(c.macros.variable_forms, {VariableForm::Names}, kMZL + "866, 870, 871: SETVN", Secondary);
  c.macros.statements.tell("GOTO", kMZL + "864: IF and GOTO", Secondary);
  c.macros.user_alarm_offset = {979, kMZL + "980 to 999: #3000=1 is 980", Secondary};
  c.macros.user_alarm_numbers = {20, kMZL + "979: n from 21 on", Secondary};
  c.macros.user_alarm_last = {9999, kKin, Inferred};
  c.user_alarm_number.clear();
}

/// Set the variables that are the same on a Mitsubishi. Of others nothing is known here.
void variables(Control& c) {
  c.variable_choices.clear();
  for (VariableRange& range : c.variables) {
    range.source = kKin;
    range.evidence = Inferred;
  }
  c.macros.commons = {"100-199 500-999", kKin, Inferred};
  c.macros.unlisted_variables = {
      UnlistedVariable::NotKnown,
      "general knowledge: tool data and others have variables of the maker's own", Inferred};
}

/// Set what codes mean. Those of turning centres, five axes and measuring are not computed.
void codes(Control& c) {
  leave_out(c, RuleGroup::TurningRules,
            kMZG + "the turning cycles are G270 to G294, which are not computed", Secondary);
  c.motion.g_meanings = {
      "31.1=skip 31.2=skip 31.3=skip 16=not-computed 37=not-computed 37.1=not-computed "
      "113=not-computed 114.3=not-computed",
      kMZG + "the list of codes; G16 beside G12.1 alone, p. 5-7", Secondary};
  c.motion.modal_groups = {"work=12 path=13 macro=14 rotation=16 surface=17 polar=18 mirror=19",
                           kMZG + "the groups of the list", Secondary};
  c.motion.max_extra_systems = {300, kMZG + "G54.1 P1 to P300, p. 14-4", Secondary};
  c.motion.other_system = {OtherSystem::First, kMZG + "G10 L2: other P count as P1", Secondary};
  c.motion.max_rotation = {360, kMZG + "G68: R is -360. to 360.", Secondary};
  c.motion.rotation_words = {"R", kMZG + "G68 R", Secondary};
  c.motion.stroke_area = {StrokeCheck::InsideForbidden, kMZG + "G22: an area that is forbidden",
                          Secondary};
  c.motion.dwell_words = {"XP", kMZG + "G04 X or P, p. 8-1", Secondary};
  c.motion.dwell_unit = {DwellUnit::Milliseconds, kMZG + "G04: 0.001 seconds", Secondary};
  c.motion.dwell_point = {DwellPoint::Refused, kMZG + "G04: a point at P alarms", Secondary};
}

void cycles(Control& c) {
  c.motion.tap_feed = {TapFeed::Lead,
                       kMZG +
                           "G74, G84: without H the tapping is synchronous, and F its pitch; "
                           "MZL 908: F is the pitch",
                       Secondary};
  c.motion.cycle_words_not_computed = {
      "BDEHIJK",
      kMZG +
          "chapter 13-1: distances before and after the levels, a second feed, the order of "
          "spindle codes, asynchronous tapping",
      Secondary};
  c.motion.peck_retract = {c.motion.peck_retract.value,
                           kMZG + "G73: F12 sets it; its value " + kPolicy, Inferred};
  c.motion.peck_clearance = {c.motion.peck_clearance.value,
                             kMZG + "G83: F13 sets it; its value " + kPolicy, Inferred};
}

/// Set what the numbers of a Mitsubishi's parameters set there.
void without_parameters(Control& c) {
  c.parameters.clear();
  c.motion.measuring = {Measuring::None, kMZG + "G37, which is not computed", Secondary};
  c.motion.skip_own_feed = {true, kMZL + "922: F stands in the block of G31", Secondary};
  c.motion.skip_signals = {SkipSignals::Any, kMZG + "G31.1: K69 to K73 choose the signals",
                           Secondary};
  c.motion.max_skip_signals = {0, kPolicy, Inferred};
  c.motion.one_way_overrun = {0, kPolicy, Inferred};
  c.motion.arc_tolerance = {100, kPolicy + ": as on a Mitsubishi", Inferred};
  c.motion.start_up = {StartUp::TypeA, kPolicy + ": as on a Mitsubishi", Inferred};
  has(c.common.power_on, {PowerOn::G01}, kMZL + "816: G01 is in force at power-on", Secondary);
}

const AlarmList& alarms_smooth() {
  using enum Cause;
  static const AlarmList list = {"MZL",
                                 Secondary,
                                 true,
                                 "",
                                 {
#include "controls/mazak/alarms_smooth.def"
                                 }};
  return list;
}

void alarms(Control& c) {
  c.alarms.clear();
  take_list(c, alarms_smooth());
  refuse_listed(c, alarms_smooth());
}

}  // namespace

Control mazak_smooth() {
  Control c = family();
  c.title = "Mazak MAZATROL Smooth, EIA/ISO";
  reading(c);
  calling(c);
  macros(c);
  variables(c);
  codes(c);
  cycles(c);
  without_parameters(c);
  alarms(c);
  return c;
}

}  // namespace cncsub
