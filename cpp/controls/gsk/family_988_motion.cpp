// Motion as the GSK 988TA and 988T share it.
#include "controls/gsk/family.hpp"

namespace cncsub::gsk {

void add_988_motion(Control& c) {
  add_lathe_motion(c);
  c.home_needed = {true, "Talm 047", Manual};
  c.measuring = {Measuring::Of6241, "TApar 6241 to 6255; TDi 17: the moves", Secondary};
  measuring_parameters(c, "TApar 6210, 6241 to 6255", Manual);
  c.skip_signals = {SkipSignals::Numbered, "inferred from TApar 6200: SKIP, SKIP2 to SKIP4",
                    Inferred};
  c.g_meanings = {"92.1=not-computed", "TA 19: a thread cycle, in both G code systems", Manual};
  c.unit_change = {UnitChange::Alone, "Talm 042", Manual};
  c.refuses = {
      "codes-with-rotation code-in-rotation corner-at-offset-start thread-passes cycle-plane "
      "cycle-axis turning-plane turning-axis pq-same profile-start pattern-x pattern-z "
      "groove-step stroke-area measuring-zone skip-per-revolution",
      "TA 5 notes 2 and 3; Talm 054, 058, 068, 121 to 161, 271", Manual};
  c.thread_starts = {true, "TA 18: L", Manual};
  c.thread_words_not_computed = {"LDE", "TA 21: L, D, E of G76", Manual};
  c.angle_words = {",A", "TApar 3405#4", Manual};
  c.max_profile_blocks = {100, "Talm 137", Manual};
  c.max_pockets = {30, "TA 8", Manual};
  add_parameter(c, {"5102#1", 0, "MRC, G71 to G73: 1 checks that the profile is monotone",
                    kTApar + "5102#1", Manual, set_monotone});
  add_parameter(c, {"5102#2", 0, "AUT: type I or II of G71 and G72 0 by the shape, 1 by block ns",
                    "TA 8", Manual, set_type_by_shape});
  add_parameter(c, {"5105#2", 0, "G71, G72 of type II cut the profile once more: 0 = yes, 1 = no",
                    "TA 8", Manual, set_pocket_pass});
  add_parameter(c, {"5101#2", 0, "RTR, G83 and G87: 0 short retract, 1 full retract",
                    kTApar + "5101#2", Manual, set_full_retract});
  add_parameter(c, {"5149", 0, "the way out of a boring cycle, percent of the feed, 0 = 200",
                    "TA 26", Manual, set_bore_return});
  c.cycle_point = {true, "TA 12, 13, 21: P3.000", Manual};
  c.run_out_words = {RunOutWords::Across, "TA 14, TA 18", Manual};
  c.thread_needs_spindle = {true, "Talm 102", Manual};
  c.helix = {false, "Talm 033", Manual};
  c.contour_behind = {false, "TA 8", Manual};
  c.cycle_repeats = {"K", "TA 24: K 1 to 99", Manual};
  c.zero_cycle_repeats = {ZeroCycleRepeats::Alarm, "Talm 181", Manual};
  c.max_cycle_repeats = {99, "TA 24: K 1 to 99; Talm 181", Manual};
  c.power_on_per_minute = {false, "TApar 3402#4", Manual};
  add_parameter(c, {"3402#0", 0, "G01, power-on: 0 in G00, 1 in G01", kTApar + "3402#0", Manual,
                    set_power_on_line});
  add_parameter(c, {"3402#3", 0, "G91, power-on: 0 in G90, 1 in G91", kTApar + "3402#3", Manual,
                    set_power_on_incremental});
  add_parameter(c, {"3402#4", 0, "FPM, power-on: 0 feed per revolution, 1 per minute",
                    kTApar + "3402#4", Manual, set_power_on_per_minute});
  add_parameter(
      c, {"3402#6", 0, "CLR, M30 and reset: 0 keep the modal codes, 1 go to the power-on state",
          kTApar + "3402#6", Manual, set_clear_on_reset});
  add_parameter(
      c, {"3403#4", 0, "RER, radius too small for the end point: 0 a half circle, 1 an alarm",
          kTApar + "3403#4", Manual, set_small_radius});
  add_parameter(c, {"3403#5", 0, "CIR, an arc without R, I, J, K: 0 a straight line, 1 an alarm",
                    kTApar + "3403#5", Manual, set_no_radius});
  add_parameter(c, {"3410", 0, "how far the radii of an arc's start and end may differ, 0 = any",
                    kTApar + "3410", Manual, set_tolerance});
  add_parameter(c, {"5003#0", 0, "the start-up of the radius offset: 0 = type A, 1 = type B",
                    "TApar", Manual, set_start_up});
  add_parameter(
      c, {"5114", 0, "return of the fast peck cycle", kTApar + "5114", Manual, set_peck_retract});
  add_parameter(
      c, {"5115", 0, "clearance of the peck cycle", kTApar + "5115", Manual, set_peck_clearance});
  add_parameter(
      c, {"5132", 0, "depth of cut of G71 and G72", kTApar + "5132", Manual, set_rough_depth});
  add_parameter(c,
                {"5133", 0, "retract of G71 and G72", kTApar + "5133", Manual, set_rough_escape});
  add_parameter(c, {"5130", 0, "thread run-out, tenths of the lead", kTApar + "5130", Manual,
                    set_thread_chamfer});
  add_parameter(c,
                {"5139", 0, "the retract of G74 and G75, mm", "TApar", Manual, set_groove_retract});
  add_parameter(c, {"5140", 0, "the least cut of G76, mm", "TApar", Manual, set_thread_least_cut});
  add_parameter(
      c, {"5141", 0, "the finishing allowance of G76, mm", "TApar", Manual, set_thread_allowance});
  add_parameter(c, {"5142", 1, "the finishing passes of G76", "TApar", Manual, set_thread_passes});
  add_parameter(c, {"5143", 0, "the angle of G76, degrees", "TApar", Manual, set_thread_angle});
  add_parameter(c,
                {"1401#1", 0, "LRP: G00 goes 0 = each axis at its own rate, 1 = on a straight line",
                 "TApar 1401#1", Manual, set_straight_rapid});
  add_parameter(c,
                {"3401#1", 0, "CPQ, unit of P and Q of cycles: 0 millimetres, 1 least increments",
                 kTApar + "3401#1", Manual, set_cycle_increments});
  add_parameter(c, {"3401#6", 0, "GSB, G code system: 0 A, 1 B", kTApar + "3401#6", Manual,
                    set_machine_system});
  add_parameter(c, {"3405#4", 1, "CDR: 1 = C and R make corners without a comma", "TApar 3405#4",
                    Manual, set_plain_corners});
  add_parameter(
      c, {"1202#2", 0, "1 = G50 is an alarm", "TApar 1202#2", Manual, set_coordinate_refused});
  add_parameter(c, {"1202#3", 0, "RLC: reset ends the local coordinate system", "TApar 1202#3",
                    Manual, set_reset_local});
  add_parameter(c, {"5006#1", 0, "1 = T in a block with G04, G10 or G50 is an alarm", "Talm 028",
                    Manual, set_tool_with_setting});
  add_parameter(c, {"5002#0", 1, "digits of T that name the offset: 0 one, 1 two", "TApar 5002#0",
                    Manual, set_offset_digits});
  add_parameter(
      c, {"5002#4", 0, "LGT: the offset is 0 a shift of the coordinates, 1 a motion of the tool",
          "TApar 5002#4", Manual, set_tool_motion});
}

}  // namespace cncsub::gsk
