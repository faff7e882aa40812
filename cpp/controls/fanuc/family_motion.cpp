// Motion as the FANUC controls share it.
#include "controls/fanuc/family.hpp"

namespace cncsub::fanuc {

void add_family_motion(Control& c) {
  c.machine = {MachineType::Mill, "the setup tells a lathe", Inferred};
  c.negative_radius = {true, "source 003, example 5", SourceDocument};
  c.machine_move = {MachineMove::Rapid, "source 003, G53; 0iMB p.228", SourceDocument};
  c.refuses = {
      "reference-in-cycle corner-at-offset-start groove-escape move-before-rigid-tap "
      "rigid-tap-without-speed",
      "ALM 039, 044, 062; 200 and 204 from general knowledge", Secondary};
  c.idle_blocks = {1, "source 003, note a", SourceDocument};
  c.measuring = {Measuring::Of6241, "general knowledge; TDi 17, TApar 6241 to 6255: the same rule",
                 Inferred};
  measuring_parameters(c, kKnown, Inferred);
  c.skip_signals = {SkipSignals::Parameters, "general knowledge, multi-step skip", Inferred};
  for (int p = 1; p <= 4; ++p) {
    const std::string number = std::to_string(p);
    c.parameters.push_back({std::to_string(6201 + p), static_cast<double>(1 << (p - 1)),
                            std::string("the skip signals of G31 P")
                                .append(number)
                                .append(" and G04 Q")
                                .append(number)
                                .append(": bit 0 is SKIP, bit 7 SKIP8"),
                            "general knowledge; that each has its own signal is policy", Inferred,
                            nullptr});
  }
  c.parameters.push_back({"6206", 0,
                          "the skip signals of G04 without Q: bit 0 is SKIP, bit 7 SKIP8", kKnown,
                          Inferred, nullptr});
  c.helix_on_lathes = {false, "ALM 021; helices of lathes are an option", Inferred};
  c.offsets_without_l = {true, "a repost of the 0i manual: memory A", Secondary};
  c.acute_corner = {AcuteCorner::Lines, kKnown, Inferred};
  c.chamfer_ik = {true, kKnown, Inferred};
  c.angle_words = {",A", "ALM 056 to 058: direct drawing dimension programming", Secondary};
  c.cycle_repeats = {"K", kKnown, Inferred};
  c.power_on_per_minute = {false, "3402#4", Inferred};
  c.max_rotation = {360, kKnown, Inferred};
  add_parameter(
      c, {"3402#0", 0, "G01: at power-on 0 = G00, 1 = G01", kKnown, Inferred, set_power_on_line});
  add_parameter(c, {"3402#3", 0, "G91: at power-on 0 = G90, 1 = G91", kKnown, Inferred,
                    set_power_on_incremental});
  add_parameter(
      c, {"3402#4", 0, "FPM: lathes at power-on 0 = feed per revolution, 1 = feed per minute",
          kKnown, Inferred, set_power_on_per_minute});
  add_parameter(
      c, {"3402#6", 0,
          "CLR: reset, M02 and M30 0 = keep the modal codes, 1 = go back to the power-on state",
          kKnown, Inferred, set_clear_on_reset});
  add_parameter(
      c,
      {"3403#4", 0,
       "RER: an arc whose radius is too small: 0 = a half circle inside the tolerance of 3410, 1 = "
       "alarm",
       kKnown, Inferred, set_small_radius});
  add_parameter(
      c, {"3403#5", 0, "CIR: an arc without R, I, J and K: 0 = a straight line, 1 = alarm", kKnown,
          Inferred, set_no_radius});
  add_parameter(
      c, {"3410", 0,
          "how much the radius of an arc's end may differ from its start's, 0 = not checked", k16Tc,
          Manual, set_tolerance});
  add_parameter(c, {"5003#0", 0, "SUP: the start-up of the radius offset is 0 = type A, 1 = type B",
                    k16Mc, Manual, set_start_up});
  add_parameter(c, {"5114", 0, "the retract d of G73, mm", k30iM, Manual, set_peck_retract});
  add_parameter(c, {"5115", 0, "the clearance d of G83, mm", k30iM, Manual, set_peck_clearance});
  add_parameter(
      c, {"5132", 0, "the depth of cut of G71 and G72, mm", kKnown, Inferred, set_rough_depth});
  add_parameter(c,
                {"5133", 0, "the escape of G71 and G72, mm", kKnown, Inferred, set_rough_escape});
  add_parameter(c,
                {"5130", 0, "the run-out of a thread cycle", kKnown, Inferred, set_thread_chamfer});
  add_parameter(
      c, {"5139", 0, "the retract of G74 and G75, mm", kKnown, Inferred, set_groove_retract});
  add_parameter(c, {"5140", 0, "the least cut of G76, mm", kKnown, Inferred, set_thread_least_cut});
  add_parameter(
      c, {"5141", 0, "the finishing allowance of G76, mm", kKnown, Inferred, set_thread_allowance});
  add_parameter(c, {"5142", 1, "the finishing passes of G76", kKnown, Inferred, set_thread_passes});
  add_parameter(c, {"5143", 0, "the angle of G76, degrees", kKnown, Inferred, set_thread_angle});
  add_parameter(c, {"1411", 0, "the feed in force at power-on, 0 = none", kKnown, Inferred,
                    set_power_on_feed});
  // Cases of lathes write chamfers without a comma, which CCR allows.
  add_parameter(c, {"3405#4", 1, "CCR: 1 = C and R make corners without a comma (lathes)", kKnown,
                    Inferred, set_plain_corners});
  add_parameter(c, {"5006#1", 0, "1 = T in a block with G04, G10 or G50 is an alarm", kKnown,
                    Inferred, set_tool_with_setting});
  add_parameter(c, {"0001#1", 0, "FCV: 1 = cycles in the one-block form of the Series 10/11/15",
                    kKnown, Inferred, set_one_block_cycles});
  add_parameter(c, {"1202#3", 0, "RLC: 1 = reset ends the local coordinate system", kKnown,
                    Inferred, set_reset_local});
  add_parameter(
      c, {"1401#1", 0, "LRP: G00 moves 0 = each axis at its own rate, 1 = on a straight line", k30i,
          Manual, set_straight_rapid});
  add_parameter(
      c, {"3402#7", 0, "G23: at power-on 0 = G22, 1 = G23", kKnown, Inferred, set_stroke_off});
  add_parameter(
      c, {"1300#0", 0, "OUT: forbidden is 0 = the inside, 1 = the outside of the area of G22",
          kKnown, Inferred, set_stroke_outside});
  add_parameter(c,
                {"5105#2", 0, "RF2: G71, G72 of type II cut the profile once more: 0 = yes, 1 = no",
                 kKnown, Inferred, set_pocket_pass});
  add_parameter(c, {"5001#5", 0, "TPH: the offset of G45 to G48 is named by 0 = D, 1 = H", kKnown,
                    Inferred, set_longer_by_h});
  add_parameter(
      c, {"5440", 0, "how far G60 goes past its point first, mm; its sign is the direction", kKnown,
          Inferred, set_overrun});
  add_parameter(
      c, {"5001#0", 0, "TLC: 1 = the length offset works on the axis named in the block (type C)",
          kKnown, Inferred, set_length_named});
  add_parameter(
      c, {"5001#1", 0, "TLB: 1 = the length offset works on the axis normal to the plane (type B)",
          kKnown, Inferred, set_length_normal});
}

}  // namespace cncsub::fanuc
