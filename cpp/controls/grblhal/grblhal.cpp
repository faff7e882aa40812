// grblHAL: a mill of three axes that runs its programs from files, as the core is built where
// expressions are switched on and everything else is as delivered: no tool table, no radius
// compensation, a spindle without an encoder. The keys of the sources stand in sources.def.
#include <utility>

#include "controls/alarm_list.hpp"
#include "controls/facts.hpp"

namespace cncsub {
namespace {

using enum Evidence;
using enum Cause;

constexpr const char* kBlock = "gHg, gc_execute_block";
constexpr const char* kCycle = "gHmc, mc_canned_drill";
constexpr const char* kMacro = "gHm, macro_execute";
constexpr const char* kLevels = "gHp, ngc_call_push";

void language(Control& c) {
  c.reading.g_codes = {
      "0 1 2 3 4 5 5.1 10 17 18 19 20 21 28 28.1 30 30.1 38.2 38.3 38.4 38.5 40 43.1 49 50 51 53 "
      "54 55 56 57 58 59 59.1 59.2 59.3 61 65 66 66.1 67 73 80 81 82 83 85 86 89 90 91 91.1 92 "
      "92.1 "
      "92.2 92.3 93 94 98 99",
      kBlock, SourceDocument};
  c.reading.missing_end = {MissingEnd::Ends, "gHs, stream_read", SourceDocument};
  lacks(c.common.reset_clears, {Cleared::Locals, Cleared::Commons}, "gHp, ngc_param_set",
        SourceDocument);
}

void calls(Control& c) {
  c.calls.program_word = {ProgramWord::Number, kMacro, SourceDocument};
  c.calls.max_program_digits = {5, kBlock, SourceDocument};
  c.macros.max_macro_digits = {5, kBlock, SourceDocument};
  c.calls.call_values = {CallValues::Cut, kBlock, SourceDocument};
  c.calls.zero_repeats = {ZeroRepeats::Once, kBlock, SourceDocument};
  c.calls.max_nesting = {10, kLevels, SourceDocument};
  c.calls.max_macro_nesting = {5, kMacro, SourceDocument};
  c.calls.nesting_counts_macros = {true, kLevels, SourceDocument};
  c.calls.main_return = {MainReturn::Restarts, "gHs, onProgramCompleted", SourceDocument};
  c.calls.end_in_subprogram = {EndInSubprogram::EndsRun, kBlock, SourceDocument};
  no_role(c.calls.roles, {"M198", "G66"}, kBlock, SourceDocument);
  give_role(c.calls.roles, "M70", Role::SaveModes, kBlock, SourceDocument);
  give_role(c.calls.roles, "M71", Role::ForgetModes, kBlock, SourceDocument);
  give_role(c.calls.roles, "M72", Role::RestoreModes, kBlock, SourceDocument);
  give_role(c.calls.roles, "M73", Role::KeepModes, kBlock, SourceDocument);
}

void cycles(Control& c) {
  c.motion.cycle_repeats = {"L", kBlock, SourceDocument};
  c.motion.zero_cycle_repeats = {ZeroCycleRepeats::Alarm, kBlock, SourceDocument};
  c.motion.cycle_approach = {CycleApproach::RFirst, kCycle, SourceDocument};
}

void motion(Control& c) {
  leave_out(c, RuleGroup::TurningRules, kBlock, Inferred);
  c.motion.dwell_words = {"P", kBlock, SourceDocument};
  c.motion.dwell_unit = {DwellUnit::PSeconds, kBlock, SourceDocument};
  c.motion.g_meanings = {
      "5=not-computed 5.1=not-computed 28=reference-all 28.1=store-reference "
      "30=second-reference-all 30.1=store-reference-2 38.2=probe 38.3=probe 38.4=probe 38.5=probe "
      "43.1=length-given 51=not-computed 59.1=extra-system-1 59.2=extra-system-2 "
      "59.3=extra-system-3 66=not-computed 66.1=not-computed 73=not-computed 83=not-computed "
      "85=not-computed 86=not-computed 89=not-computed "
      "91.1=centre-from-start 92.1=clear-shift 92.2=suspend-shift 92.3=restore-shift",
      kBlock, SourceDocument};
  c.motion.max_extra_systems = {3, kBlock, SourceDocument};
  has(c.motion.data_forms, {DataForm::Active, DataForm::Here}, kBlock, SourceDocument);
  has(c.common.refuses,
      {NoMotionCode, MachineMoveCode, NoFeed, NoArcTravel, RadiusAndCentre, CycleInverseTime,
       PeckNegative, G10Axis},
      kBlock, SourceDocument);
  c.motion.length_type = {LengthType::Shift, kBlock, SourceDocument};
  c.motion.feed_mode_change = {FeedModeChange::DeletesFeed, kBlock, SourceDocument};
  c.motion.computed_lengths = {ComputedLengths::Exact, kBlock, SourceDocument};
  c.motion.codes_that_move = {"4 28.1 30.1 92.1 92.2 92.3", kBlock, SourceDocument};
  c.motion.machine_move = {MachineMove::Modal, kBlock, SourceDocument};
  c.motion.helix = {Helix::AllAxes, kBlock, SourceDocument};
  c.motion.drops_centre_across = {true, kBlock, SourceDocument};
  c.motion.arc_tolerance = {5, kBlock, SourceDocument};
  c.motion.arc_tolerance_share = {1, kBlock, SourceDocument};
}

using Kind = VariableKind;

void add(Control& c, std::int32_t first, std::int32_t last, Kind kind, Access access,
         char address = 0, std::int32_t from = 0) {
  c.variables.push_back(
      {first, last, kind, access, address, "gHp, ngc_ro_params", SourceDocument, from});
}

void variables(Control& c) {
  constexpr Access kRead = Access::ReadOnly;
  add(c, 1, 30, Kind::Local, Access::ReadWrite);
  add(c, 31, 5060, Kind::Kept, Access::ReadWrite);
  add(c, 5061, 5069, Kind::SkipPosition, kRead);
  add(c, 5070, 5070, Kind::SkipTouched, kRead);
  add(c, 5161, 5169, Kind::ReferencePoint, kRead);
  add(c, 5181, 5189, Kind::ReferencePoint, kRead, 0, 20);
  add(c, 5210, 5219, Kind::Shift, kRead);
  add(c, 5220, 5220, Kind::WorkSystem, kRead);
  for (std::int32_t system = 0; system < 9; ++system) {
    const bool extra = system > 5;
    add(c, 5221 + 20 * system, 5229 + 20 * system, extra ? Kind::ExtraWorkOffset : Kind::WorkOffset,
        kRead, 0, 20 * (extra ? system - 6 : system + 1));
  }
  add(c, 5401, 5409, Kind::ToolLength, kRead);
  add(c, 5420, 5428, Kind::WorkPosition, kRead);
  add(c, 5599, 5599, Kind::MessageSwitch, kRead);
  for (VariableRange& range : c.variables)  // millimetres, whatever the unit of the program
    range.metric = range.first >= 5061 && range.first <= 5428;
  // No program can name these: the named variables of the control read them.
  add(c, 14001, 14024, Kind::ActiveCode, kRead);
  add(c, 14100 + 'F' - 'A', 14100 + 'F' - 'A', Kind::ActiveWord, kRead, 'F');
  add(c, 14100 + 'S' - 'A', 14100 + 'S' - 'A', Kind::ActiveWord, kRead, 'S');
  add(c, 15020, 15025, Kind::MachinePosition, kRead);
  add(c, 15040, 15048, Kind::WorkPosition, kRead);
}

void alarms(Control& c) {
  static const AlarmList list = {"gHe",
                                 SourceDocument,
                                 true,
                                 "general knowledge of grblHAL",
                                 {
#include "controls/grblhal/errors.def"
                                 }};
  take_list(c, list);
}

}  // namespace

Control grblhal() {
  Control c;
  c.title = "grblHAL mill";
  c.dialect = "grblhal";
  language(c);
  calls(c);
  cycles(c);
  motion(c);
  variables(c);
  alarms(c);
  return c;
}

}  // namespace cncsub
