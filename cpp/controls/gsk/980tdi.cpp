// GSK 980TDi lathe.
#include "controls/gsk/family.hpp"

namespace cncsub {

using namespace gsk;

namespace {

constexpr const char* kTDiCodes =
    "0 1 2 3 4 5 5.1 6.2 6.3 7.1 7.2 7.3 10 11 12.1 13.1 17 18 19 20 21 22 23 "
    "28 30 31 32 32.1 32.2 32.3 33 34 36 37 40 41 42 50 50.2 51.2 52 53 "
    "54 55 56 57 58 59 65 66 67 70 71 72 73 74 74.1 75 75.1 76 78 80 83 83.1 83.2 "
    "84 84.1 84.2 86 87 87.1 88 88.1 90 92 92.1 92.3 94 96 97 98 99";

/// The parameters that set rules, and those of input and of codes that call.
const Parameter kParameters[] = {
    {"019",
     0,
     "the run-out of G92 and G76, tenths of the lead",
     "TDipar 019",
     Manual,
     {number(rule::thread_chamfer)}},
    {"056",
     0,
     "the retract of G74 and G75, mm",
     "TDi 23.5: parameter 056",
     Manual,
     {micrometres(rule::groove_retract)}},
    {"057",
     1,
     "the finishing passes of G76",
     "TDi 24.12: parameter 057",
     Manual,
     {number(rule::thread_passes)}},
    {"058",
     0,
     "the angle of G76, degrees",
     "TDi 24.12: parameter 058",
     Manual,
     {number(rule::thread_angle)}},
    {"059",
     0,
     "the least cut of G76, mm",
     "TDi 24.12: parameter 059",
     Manual,
     {micrometres(rule::thread_least_cut)}},
    {"060",
     0,
     "the finishing allowance of G76, mm",
     "TDi 24.12: parameter 060",
     Manual,
     {micrometres(rule::thread_allowance)}},
    {"001#7",
     0,
     "G00 goes 0 = each axis at its own rate, 1 = on a straight line",
     "TDipar 001#7",
     Manual,
     {bit(rule::rapid_way, RapidWay::OwnRates, RapidWay::Straight)}},
    {"182#7",
     0,
     "P and Q of cycles and of angles count 0 least increments, 1 mm, degrees",
     "TDipar 182#7",
     Manual,
     {bit(rule::cycle_unit, CycleUnit::Increments, CycleUnit::Millimetres)}},
    {"172#2",
     0,
     "forbidden is 0 = the inside, 1 = the outside of the area of G22",
     "TDi 31",
     Manual,
     {bit(rule::stroke_area, StrokeCheck::InsideForbidden, StrokeCheck::OutsideForbidden)}},
    {"154",
     0,
     "how far the radii of an arc may differ, mm, 0 = not checked",
     "TDipar 154",
     Manual,
     {micrometres(rule::arc_tolerance)}},
    {"030", 0, "the feed at power-on", "TDipar 030", Manual, {number(rule::power_on_feed)}},
    {"051",
     0,
     "the depth of cut of G71 and G72, mm",
     "TDipar 051",
     Manual,
     {micrometres_unless_zero(rule::rough_depth)}},
    {"052",
     0,
     "the escape of G71 and G72, mm",
     "TDipar 052",
     Manual,
     {micrometres_unless_zero(rule::rough_escape)}},
    {"003#4",
     0,
     "a tool offset is 0 a shift of the coordinates, 1 a motion",
     "TDipar 003#4",
     Manual,
     {bit(rule::tool_offset, ToolOffset::Shift, ToolOffset::NextMove)}},
    {"002#5",
     0,
     "around an acute corner 0 lines, 1 an arc",
     "TDipar 002#5",
     Manual,
     {bit(rule::acute_corner, AcuteCorner::Lines, AcuteCorner::Arc)}},
    {"181#0",
     0,
     "L is 0 the length of the chamfer, 1 its distance from the corner",
     "TDipar 181#0",
     Manual,
     {bit(rule::chamfer_length, ChamferLength::Line, ChamferLength::Corner)}},
    {"001#0", 0, "input unit: 0 millimetres, 1 inches", kTDipar + "1", Manual},
    {"89", 0, "the first M code that calls a subprogram", kTDi + "17", Manual},
    {"90", 0, "the program that the first M code calls", kTDi + "17", Manual},
    {"91", 0, "how many M codes call subprograms, 0 = none", kTDi + "17", Manual},
    {"180#7",
     0,
     "ATAN and ASIN: 0 gives 0 to 360 and -90 to 90, 1 -180 to 180 and 90 to 270",
     kTDi + "29, notes 2 and 4",
     Manual,
     {bit(rule::atan_range, AngleRange::FullTurn, AngleRange::Signed),
      bit(rule::asin_range, AngleRange::Signed, AngleRange::FullTurn)}},
    {"878",
     1,
     "program names of any kind: 0 no, 1 yes",
     kTDi + "15 1.1.2; set here, so that P[name] works",
     Manual,
     {bit(rule::bracket_names)}},
};

void motion(Control& c) {
  c.motion.g_meanings = {"5=three-points 5.1=three-points-absolute 33=tap-cycle", "TDi 5, TDi 24.5",
                         Manual};
  c.motion.negative_radius = {NegativeRadius::LongWay, "TDi 4 note 7", Manual};
  c.motion.no_radius = {NoRadius::Alarm, "TDi 4 note 1", Manual};
  c.motion.small_radius = {SmallRadius::Alarm, "TDi 4 note 3", Manual};
  lacks(c.common.power_on, {PowerOn::G95}, "TDi 26", Manual);
  c.motion.chamfer_words = {"L", "TDi 11", Manual};
  c.motion.round_words = {"D", "TDi 11", Manual};
  c.motion.angle_words = {"Q", "TDi 13", Manual};
  c.motion.skip_variables = {995, "TDi p.94, 3.16.2: #995 to #999 are X, Z, Y, 4th, 5th", Manual};
  c.motion.max_skip_signals = {6, "TDi p.93, 3.16: P is 1 to 6", Manual};
  c.motion.skip_signals = {SkipSignals::Numbered, "TDi p.93, 3.16; TDi 14, G04 Q", Manual};
  c.motion.max_skip_feed = {200, "TDi p.94, 3.16.2; p.96, 3.17.2", Manual};
  c.motion.measuring = {Measuring::Of141, "TDi 17", Manual};
  for (const auto& [name, meaning] :
       {std::pair{"141", "the measuring feed of G36 and G37, mm/min"},
        {"142", "G36: how far before the point the measuring feed begins, mm"},
        {"143", "G37: how far before the point the measuring feed begins, mm"},
        {"144", "G36: within what distance of the point the tool arrives, mm"},
        {"145", "G37: within what distance of the point the tool arrives, mm"}})
    c.parameters.push_back(
        read_by(rule::measuring, {name, 0, meaning, "TDipar 141 to 145", Manual}));
  c.motion.helix = {Helix::Refused, kKnown, Inferred};
  lacks(c.common.power_on, {PowerOn::G01}, kTDi + "2: G00", Manual);
}

void turning(Control& c) {
  c.turning.set_coordinate_without_tool = {true, "TDi 18 table", Manual};
  c.turning.single_pattern = {PatternPasses::Two, "TDi 23.3", Manual};
  c.turning.groove_p_diameter = {true, "TDi 23.5", Manual};
  c.turning.drill_retract = {true, "TDi 23.9", Manual};
  has(c.common.refuses, {Cause::CyclePlane, Cause::TurningPlane, Cause::StrokeWithCodes},
      "TDi 8 note 3; TDi 31 note 6", Manual);
  c.turning.profile_monotone = {MonotoneCheck::WithK, "TDi 23.1: K", Manual};
  c.turning.max_profile_blocks = {200, "TDi 23.1 note 9", Manual};
  c.turning.max_pockets = {20, "TDi 23.1, type II", Manual};
  c.turning.pocket_pass = {PocketPass::WithJ, "TDi 23.1: J", Manual};
  c.turning.run_out_words = {RunOutWords::Equal, "TDi 24.1, 24.9", Manual};
  c.turning.thread_digits_apart = {true, "TDi 24.12 note 4", Manual};
  c.turning.thread_starts = {true, "TDi 24.9: L", Manual};
}

}  // namespace

Control gsk_980tdi() {
  Control c = family_980();
  c.title = "GSK 980TDi lathe";
  c.reading.g_codes = {kTDiCodes, kTDi + "2 to TDi37, titles", Manual};
  CodeCall subprogram = code_call(CodeCall::Form::Range, 'M', CodeCallKind::Subprogram, 89, 90, 91);
  subprogram.first_code = 3;
  subprogram.last_code = 8999;
  subprogram.source = kTDi + "17";
  subprogram.evidence = Manual;
  c.code_calls.push_back(subprogram);

  add_lathe_motion(c);
  motion(c);
  turning(c);
  // The list's alarms of mills and of travel are not known of the lathe.
  for (const Cause cause :
       {Cause::OverTravel, Cause::MeasuringMissed, Cause::MeasuringEarly, Cause::MeasuringOffset})
    c.alarms.erase(cause);
  add_parameters(c, kParameters);
  return c;
}

}  // namespace cncsub
