// LinuxCNC: its interpreter, as the program rs274 runs it without a machine.
// The keys of the sources stand in sources.def. What they do not say is as in the family, and so is
// motion beyond lines and arcs.
#include <algorithm>

#include "controls/facts.hpp"

namespace cncsub {
namespace {

using enum Evidence;
using enum Cause;

constexpr const char* kRun = "rs274 2.9";
constexpr const char* kOverview = "LC overview";
constexpr const char* kGCode = "LC g-code";
constexpr const char* kMCode = "LC m-code";

/// Set the parts of the language that rules decide. The rest is the dialect's own.
void language(Control& c) {
  c.reading.max_digits = {15, kRun, SourceDocument};
  c.reading.g_codes = {
      "0 1 2 3 4 5 5.1 5.2 5.3 7 8 10 17 17.1 18 18.1 19 19.1 20 21 28 28.1 30 30.1 33 33.1 "
      "38.2 38.3 38.4 38.5 40 41 41.1 42 42.1 43 43.1 43.2 49 52 53 54 55 56 57 58 59 59.1 59.2 "
      "59.3 61 61.1 64 70 71 71.1 71.2 72 72.1 72.2 73 74 76 80 81 82 83 84 85 86 87 88 89 90 90.1 "
      "91 91.1 92 92.1 92.2 92.3 93 94 95 96 97 98 99",
      kOverview, Manual};
  c.reading.repeated_address = {RepeatedAddress::Alarm, kRun, SourceDocument};
  c.reading.missing_end = {MissingEnd::Alarm, kRun, SourceDocument};
  c.calls.max_nesting = {9, kRun, SourceDocument};
  give_role(c.calls.roles, "M70", Role::SaveModes, kMCode, Manual);
  give_role(c.calls.roles, "M71", Role::ForgetModes, kMCode, Manual);
  give_role(c.calls.roles, "M72", Role::RestoreModes, kMCode, Manual);
  give_role(c.calls.roles, "M73", Role::KeepModes, kMCode, Manual);
  c.calls.main_return = {MainReturn::Ends, kRun, SourceDocument};
  lacks(c.common.reset_clears, {Cleared::Locals, Cleared::Commons}, kOverview, Manual);
}

void cycles(Control& c) {
  c.motion.cycle_repeats = {"L", kGCode, Manual};
  c.motion.zero_cycle_repeats = {ZeroCycleRepeats::Alarm, kRun, SourceDocument};
  c.motion.cycle_approach = {CycleApproach::RFirst, kRun, SourceDocument};
  c.motion.tap_return = {TapReturn::Shuffled, kRun, SourceDocument};
  c.motion.peck_retract = {254, kRun, SourceDocument};
  c.motion.peck_clearance = {254, kRun, SourceDocument};
}

void tool_offsets(Control& c) {
  c.motion.length_type = {LengthType::Shift, kGCode, Manual};
  c.motion.missing_radius_offset = {MissingOffset::Tool, kGCode, Manual};
  c.motion.codes_not_compensated = {"28 30 53 54 55 56 57 58 59 59.1 59.2 59.3 61 61.1 64 92 98 99",
                                    kRun, SourceDocument};
  c.motion.m_codes_not_compensated = {"6 48 49 50 51 52 53 62 63 64 65 66 67 68", kRun,
                                      SourceDocument};
  c.motion.written_offset = {WrittenOffset::WhenSelected, kRun, SourceDocument};
}

void motion(Control& c) {
  leave_out(c, RuleGroup::TurningRules, kOverview, Inferred);
  c.motion.dwell_words = {"P", kGCode, Manual};
  c.motion.speed_limit = {SpeedLimit::OfSurface, "rs274 2.9; LC g-code, G96", SourceDocument};
  c.motion.dwell_unit = {DwellUnit::PSeconds, kGCode, Manual};
  c.motion.g_meanings = {
      "33=thread-by-k 33.1=rigid-tap 38.2=probe 38.3=probe 38.4=probe 38.5=probe "
      "90.1=centre-absolute 91.1=centre-from-start 7=diameter 8=diameter-off 5=spline "
      "5.1=spline-by-one-point 76=drive-line-thread 86=bore-stop-after-dwell 28=reference-all "
      "28.1=store-reference 30=second-reference-all 30.1=store-reference-2 "
      "41.1=radius-left-given 42.1=radius-right-given 43.1=length-given 43.2=length-added "
      "52=shift 59.1=extra-system-1 59.2=extra-system-2 59.3=extra-system-3 92.1=clear-shift "
      "92.2=suspend-shift 92.3=restore-shift 87=not-computed 88=not-computed",
      kGCode, Manual};
  c.motion.max_extra_systems = {3, kGCode, Manual};
  has(c.motion.data_forms, {DataForm::Active, DataForm::Here, DataForm::Tools}, kGCode, Manual);
  c.motion.start_up = {StartUp::OwnNormal, kRun, SourceDocument};
  has(c.common.refuses,
      {ModesNotSaved, CycleRotary, NoRadius, NoArcTravel, SpindleStands, CompensationCycle,
       NoMotionCode, CompensationCode, CycleInverseTime, MachineMoveCode, NoSpeed,
       SkipPerRevolution, CompensationWrongPlane, ArcAxis, NoFeed, RadiusAndCentre, PeckNegative},
      kRun, SourceDocument);
  c.motion.feed_mode_change = {FeedModeChange::EndsFeed, kRun, SourceDocument};
  c.motion.feed_unit = {FeedUnit::BeforeBlock, kRun, SourceDocument};
  c.motion.spindle_at_change = {SpindleAtChange::Stopped, kMCode, Manual};
  c.motion.computed_lengths = {ComputedLengths::Exact, kRun, SourceDocument};
  c.motion.codes_that_move = {"4 28.1 30.1 92.1 92.2 92.3", kRun, SourceDocument};
  has(c.common.power_on, {PowerOn::G99}, kRun, SourceDocument);
  c.motion.machine_move = {MachineMove::ModalAbsolute, kRun, SourceDocument};
  c.motion.arc_rounding = {10, kRun, SourceDocument};
  c.motion.helix = {Helix::AllAxes, kGCode, Manual};
  c.motion.modal_groups = {"centre=23 diameter=24", kRun, SourceDocument};
  c.motion.arc_tolerance_share = {1, kRun, SourceDocument};
}

using Kind = VariableKind;

void add(Control& c, std::int32_t first, std::int32_t last, Kind kind, Access access,
         char address = 0, std::int32_t from = 0) {
  c.variables.push_back({first, last, kind, access, address, kRun, SourceDocument, from});
}

void variables(Control& c) {
  c.variables.push_back({1, 30, Kind::Local, Access::ReadWrite, 0, "LC o-code", Manual});
  add(c, 31, 5060, Kind::Kept, Access::ReadWrite);
  add(c, 5061, 5069, Kind::SkipPosition, Access::ReadWrite);
  add(c, 5070, 5070, Kind::SkipTouched, Access::ReadWrite);
  add(c, 5071, 5160, Kind::Kept, Access::ReadWrite);
  add(c, 5161, 5169, Kind::ReferencePoint, Access::ReadWrite);
  add(c, 5170, 5180, Kind::Kept, Access::ReadWrite);
  add(c, 5181, 5189, Kind::ReferencePoint, Access::ReadWrite, 0, 20);
  add(c, 5190, 5209, Kind::Kept, Access::ReadWrite);
  add(c, 5210, 5219, Kind::Shift, Access::ReadWrite);
  add(c, 5220, 5220, Kind::WorkSystem, Access::ReadWrite);
  for (std::int32_t system = 0; system < 9; ++system) {  // nine axes and the turn, ten of no use
    const std::int32_t first = 5221 + 20 * system;
    const bool extra = system > 5;
    add(c, first, first + 9, extra ? Kind::ExtraWorkOffset : Kind::WorkOffset, Access::ReadWrite, 0,
        20 * (extra ? system - 6 : system + 1));
    add(c, first + 10, std::min(first + 19, 5399), Kind::Kept, Access::ReadWrite);
  }
  add(c, 5400, 5409, Kind::ToolLength, Access::ReadOnly, 0, -1);  // the first is the tool itself
  add(c, 5410, 5419, Kind::Kept, Access::ReadOnly);
  add(c, 5420, 5428, Kind::WorkPosition, Access::ReadOnly);
  c.variables.back().not_compensated = true;
  add(c, 5429, 5598, Kind::Kept, Access::ReadWrite);
  add(c, 5599, 5599, Kind::MessageSwitch, Access::ReadWrite);
  add(c, 5600, 5601, Kind::Kept, Access::ReadWrite);
  for (VariableRange& range : c.variables)
    range.metric = range.kind == Kind::WorkOffset || range.kind == Kind::ToolLength ||
                   range.kind == Kind::Shift || range.kind == Kind::ReferencePoint ||
                   range.kind == Kind::ExtraWorkOffset;
}

/// Add variables that no program can name: the named variables of the interpreter read them.
void told_by_name(Control& c) {
  add(c, 14001, 14024, Kind::ActiveCode, Access::ReadOnly);
  add(c, 14100 + 'F' - 'A', 14100 + 'F' - 'A', Kind::ActiveWord, Access::ReadOnly, 'F');
  add(c, 14100 + 'S' - 'A', 14100 + 'S' - 'A', Kind::ActiveWord, Access::ReadOnly, 'S');
  add(c, 14100 + 'T' - 'A', 14100 + 'T' - 'A', Kind::ActiveWord, Access::ReadOnly, 'T');
  add(c, 15020, 15025, Kind::MachinePosition, Access::ReadOnly);
  add(c, 15040, 15048, Kind::WorkPosition, Access::ReadOnly);
}

/// The texts of its errors, which have words and no numbers. Where a message names the word that is
/// wrong, the alarm shows the name.
constexpr std::pair<Cause, const char*> kTexts[] = {
    {AddressWithoutValue, "No characters found in reading real value"},
    {ArcSineOutOfRange, "Argument to {name} out of range"},
    {ArgumentOutOfRange, "Calculation resulted in 'not a number'"},
    {BracketNotClosed, "Unclosed expression"},
    {CommentInComment, "Nested comment found"},
    {CompensationShift, "Cannot set reference point with cutter compensation in effect"},
    {CompensationEndArc,
     "The move just after exiting cutter compensation mode must be straight, not an arc"},
    {CompensationInterference,
     "{name} in concave corner cannot be reached by the tool without gouging"},
    {CompensationNoIntersection,
     "{name} makes a corner the compensated tool can't fit in without gouging"},
    {CompensationEntry, "{name} is not greater than the tool radius"},
    {CompensationTwice, "Cannot turn cutter radius comp on when on"},
    {CompensationArcTooSmall,
     "Tool radius not less than arc radius with cutter radius compensation"},
    {CycleRotary, "Cannot put {name} in canned cycle"},
    {CycleRepeats, "Cannot do zero repeats of cycle"},
    {CommentNotClosed, "Unclosed comment found"},
    {BlockTooLong, "Command too long"},
    {CompensationPlane, "Cannot change planes with cutter radius compensation on"},
    {CompensationWrongPlane, "Cutter radius compensation allowed only in XY, XZ planes"},
    {CompensationPosition, "Cannot read current position with cutter radius compensation on"},
    {CompensationCycle, "Cannot use canned cycles with cutter compensation on"},
    {MotionWordMissing, "All axes missing with motion code"},
    {ModesNotSaved, "Cannot restore context from invalid stack frame - missing M70/M73?"},
    {NoArcTravel, "Current point same as end point of arc"},
    {NoMotionCode, "Cannot use axis values without a g code that uses them"},
    {MachineMoveIncremental, "Cannot use g53 incremental"},
    {CycleLevels, "R less than z in cycle in xy plane"},
    {SpindleStands, "Spindle not turning in {name}"},
    {SameProbePoint, "Start point too close to probe point"},
    {CompensationSkip, "Cannot probe with cutter radius compensation on"},
    {G10L, "Line with G10 does not have L0, L1, L10, L11, L2, or L20"},
    {G10P, "P value out of range (0-9) with G10 L2"},
    {G10System, "P value out of range (0-9) with G10 L2"},
    {G10Word, "P value out of range (0-9) with G10 L2"},
    {G10Offset, "Requested tool not found in the tool table"},
    {ThreadLead, "K word missing with g33/g33.1"},
    {RadiusOffsetNumber, "G41.1 with no D word"},
    {DivisionByZero, "Attempt to divide by zero"},
    {EndOfRecord, "File ended with no percent sign or program end"},
    {IllegalVariable, "Parameter number out of range"},
    {LabelGivenTwice, "{line}: duplicate O-word label: '{block}'"},
    {LabelNotFound, "{line}: undefined O-word label: '{block}'"},
    {LabelOfAnotherKind, "{line}: no matching label: '{block}'"},
    {LogarithmOfNonPositive, "Zero or negative argument to ln"},
    {NestingTooDeep, "Too many subroutine levels"},
    {NoFeed, "Cannot do g1 with zero feed rate"},
    {RadiusAndCentre, "Mixed radius ijk format for arc"},
    {NoRadius, "R i j k words all missing for arc"},
    {Overflow, "Calculation resulted in 'infinity'"},
    {PeckNegative, "Negative or zero q value used"},
    {PowerOfNegative, "Attempt to raise negative to non integer power"},
    {ProgramNotFound, "EOF in file:{file} seeking o-word: o<{name}> from line: {line}"},
    {RadiusTolerance, "Radius to end of arc differs from radius to start: {name}"},
    {RadiusTooSmall, "Arc radius too small to reach end point"},
    {ReturnInMainProgram, "{line}: not in a subroutine definition: '{block}'"},
    {SquareRootOfNegative, "Negative argument to sqrt"},
    {SubprogramInSubprogram, "Nested subroutine definition"},
    {SubprogramGivenTwice,
     "File:{file} line:{line} redefining sub: o|{name}| already defined in file:{file}"},
    {TooManyArguments, "Too many subroutine parameters"},
    {VariableNameUnknown, "Named parameter #<{name}> not defined"},
    {VariableWriteProtected, "Parameter is readonly"},
    {WholeNumberExpected, "Non integer value for integer"},
};

void alarms(Control& c) {
  for (const auto& [cause, text] : kTexts) c.alarms[cause] = {"", text, kRun, SourceDocument, true};
}

}  // namespace

Control linuxcnc() {
  Control c;
  c.title = "LinuxCNC mill";
  c.dialect = "linuxcnc";
  language(c);
  cycles(c);
  tool_offsets(c);
  motion(c);
  variables(c);
  told_by_name(c);
  alarms(c);
  return c;
}

}  // namespace cncsub
