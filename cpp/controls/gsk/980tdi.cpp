// GSK 980TDi lathe.
#include "controls/gsk/family.hpp"

namespace cncsub {

using namespace gsk;

namespace {

const std::string kTDiCodes =
    "0 1 2 3 4 5 5.1 6.2 6.3 7.1 7.2 7.3 10 11 12.1 13.1 17 18 19 20 21 22 23 "
    "28 30 31 32 32.1 32.2 32.3 33 34 36 37 40 41 42 50 50.2 51.2 52 53 "
    "54 55 56 57 58 59 65 66 67 70 71 72 73 74 74.1 75 75.1 76 78 80 83 83.1 83.2 "
    "84 84.1 84.2 86 87 87.1 88 88.1 90 92 92.1 92.3 94 96 97 98 99";

}  // namespace

Control gsk_980tdi() {
  Control c = family_980();
  c.title = "GSK 980TDi lathe";
  c.g_codes = {kTDiCodes, kTDi + "2 to TDi37, titles", Manual};
  add_parameters(
      c, {{"001#0", 0, "input unit: 0 millimetres, 1 inches", kTDipar + "1", Manual, nullptr},
          {"89", 0, "the first M code that calls a subprogram", kTDi + "17", Manual, nullptr},
          {"90", 0, "the program that the first M code calls", kTDi + "17", Manual, nullptr},
          {"91", 0, "how many M codes call subprograms, 0 = none", kTDi + "17", Manual, nullptr},
          {"180#7", 0, "ATAN and ASIN: 0 gives 0 to 360 and -90 to 90, 1 -180 to 180 and 90 to 270",
           kTDi + "29, notes 2 and 4", Manual,
           [](Control& k, double value) {
             k.atan_range.value = value != 0 ? AngleRange::Signed : AngleRange::FullTurn;
             k.asin_range.value = value != 0 ? AngleRange::FullTurn : AngleRange::Signed;
           }},
          {"878", 1, "program names of any kind: 0 no, 1 yes",
           kTDi + "15 1.1.2; set here, so that P[name] works", Manual,
           [](Control& k, double value) { k.bracket_names.value = value != 0; }},
          {"5114", 0, "return of the fast peck cycle", kStands, Inferred, nullptr},
          {"5115", 0, "clearance of the peck cycle", kStands, Inferred, nullptr}});
  CodeCall subprogram = code_call(CodeCall::Form::Range, 'M', CodeCallKind::Subprogram, 89, 90, 91);
  subprogram.first_code = 3;
  subprogram.last_code = 8999;
  subprogram.source = kTDi + "17";
  subprogram.evidence = Manual;
  c.code_calls.push_back(subprogram);

  add_lathe_motion(c);
  c.g_meanings = {"5=three-points 5.1=three-points-absolute 33=tap-cycle", "TDi 5, TDi 24.5",
                  Manual};
  c.negative_radius_on_lathes = {true, "TDi 4 note 7", Manual};
  c.no_radius = {NoRadius::Alarm, "TDi 4 note 1", Manual};
  c.small_radius = {SmallRadius::Alarm, "TDi 4 note 3", Manual};
  c.power_on_per_minute = {true, "TDi 26", Manual};
  c.set_coordinate_without_tool = {true, "TDi 18 table", Manual};
  c.chamfer_words = {"L", "TDi 11", Manual};
  c.round_words = {"D", "TDi 11", Manual};
  c.angle_words = {"Q", "TDi 13", Manual};
  c.single_pass_pattern = {false, "TDi 23.3", Manual};
  c.groove_p_diameter = {true, "TDi 23.5", Manual};
  c.skip_variables = {995, "TDi p.94, 3.16.2: #995 to #999 are X, Z, Y, 4th, 5th", Manual};
  c.max_skip_signals = {6, "TDi p.93, 3.16: P is 1 to 6", Manual};
  c.skip_signals = {SkipSignals::Numbered, "TDi p.93, 3.16; TDi 14, G04 Q", Manual};
  c.max_skip_feed = {200, "TDi p.94, 3.16.2; p.96, 3.17.2", Manual};
  c.measuring = {Measuring::Of141, "TDi 17", Manual};
  for (const auto& [name, meaning] :
       {std::pair{"141", "the measuring feed of G36 and G37, mm/min"},
        {"142", "G36: how far before the point the measuring feed begins, mm"},
        {"143", "G37: how far before the point the measuring feed begins, mm"},
        {"144", "G36: within what distance of the point the tool arrives, mm"},
        {"145", "G37: within what distance of the point the tool arrives, mm"}})
    c.parameters.push_back({name, 0, meaning, "TDipar 141 to 145", Manual, nullptr});
  c.drill_retract = {true, "TDi 23.9", Manual};
  c.refuses = {"cycle-plane turning-plane stroke-check-with-codes", "TDi 8 note 3; TDi 31 note 6",
               Manual};
  c.profile_monotone = {MonotoneCheck::WithK, "TDi 23.1: K", Manual};
  c.max_profile_blocks = {200, "TDi 23.1 note 9", Manual};
  c.max_pockets = {20, "TDi 23.1, type II", Manual};
  c.pocket_pass = {PocketPass::WithJ, "TDi 23.1: J", Manual};
  c.run_out_words = {RunOutWords::Equal, "TDi 24.1, 24.9", Manual};
  c.thread_digits_apart = {true, "TDi 24.12 note 4", Manual};
  c.thread_starts = {true, "TDi 24.9: L", Manual};
  add_parameter(c, {"019", 0, "the run-out of G92 and G76, tenths of the lead", "TDipar 019",
                    Manual, set_thread_chamfer});
  add_parameter(c, {"056", 0, "the retract of G74 and G75, mm", "TDi 23.5: parameter 056", Manual,
                    set_groove_retract});
  add_parameter(c, {"057", 1, "the finishing passes of G76", "TDi 24.12: parameter 057", Manual,
                    set_thread_passes});
  add_parameter(c, {"058", 0, "the angle of G76, degrees", "TDi 24.12: parameter 058", Manual,
                    set_thread_angle});
  add_parameter(c, {"059", 0, "the least cut of G76, mm", "TDi 24.12: parameter 059", Manual,
                    set_thread_least_cut});
  add_parameter(c, {"060", 0, "the finishing allowance of G76, mm", "TDi 24.12: parameter 060",
                    Manual, set_thread_allowance});
  c.helix = {false, kKnown, Inferred};
  add_parameter(c, {"3402#0", 0, "power-on: 0 in G00, 1 in G01", kTDi + "2: G00; " + kStands,
                    Inferred, set_power_on_line});
  add_parameter(c, {"3403#4", 1, "radius too small for the end point: 0 a half circle, 1 an alarm",
                    kTDi + "4, note 3; " + kStands, Inferred, set_small_radius});
  add_parameter(c, {"3403#5", 1, "an arc without R, I, K: 0 a straight line, 1 an alarm",
                    kTDi + "4, note 1; " + kStands, Inferred, set_no_radius});
  add_parameter(c, {"3410", 0, "how far the radii of an arc's start and end may differ, 0 = any",
                    kTDipar + "154 in its place; " + kStands, Inferred, set_tolerance});
  add_parameter(c, {"001#7", 0, "G00 goes 0 = each axis at its own rate, 1 = on a straight line",
                    "TDipar 001#7", Manual, set_straight_rapid});
  add_parameter(
      c, {"182#7", 0, "P and Q of cycles and of angles count 0 least increments, 1 mm, degrees",
          "TDipar 182#7", Manual, set_cycle_millimetres});
  add_parameter(c, {"172#2", 0, "forbidden is 0 = the inside, 1 = the outside of the area of G22",
                    "TDi 31", Manual, set_stroke_outside});
  add_parameter(c, {"154", 0, "how far the radii of an arc may differ, mm, 0 = not checked",
                    "TDipar 154", Manual, set_tolerance});
  add_parameter(c, {"030", 0, "the feed at power-on", "TDipar 030", Manual, set_power_on_feed});
  add_parameter(
      c, {"051", 0, "the depth of cut of G71 and G72, mm", "TDipar 051", Manual, set_rough_depth});
  add_parameter(
      c, {"052", 0, "the escape of G71 and G72, mm", "TDipar 052", Manual, set_rough_escape});
  add_parameter(c, {"003#4", 0, "a tool offset is 0 a shift of the coordinates, 1 a motion",
                    "TDipar 003#4", Manual, set_tool_motion});
  add_parameter(c, {"002#5", 0, "around an acute corner 0 lines, 1 an arc", "TDipar 002#5", Manual,
                    set_acute_corner});
  add_parameter(c, {"181#0", 0, "L is 0 the length of the chamfer, 1 its distance from the corner",
                    "TDipar 181#0", Manual, set_chamfer_length});
  // What the list has of mills and of travel is not known of the lathe.
  for (const Cause cause :
       {Cause::OverTravel, Cause::MeasuringMissed, Cause::MeasuringEarly, Cause::MeasuringOffset})
    c.alarms.erase(cause);
  return c;
}

}  // namespace cncsub
