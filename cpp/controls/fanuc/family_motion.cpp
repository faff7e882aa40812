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
  fanuc_numbers(c, kKnown, Inferred);
  add_effect(c, "1411", 0, "the feed at power-on", kKnown, Inferred, set_power_on_feed);
  // Cases of lathes write chamfers without a comma, which CCR allows.
  for (Parameter& p : c.parameters)
    if (p.name == "3405#4") p.value = 1;
  add_effect(c, "3405#4", 1, "lathes: 1 = C and R make corners without a comma", kKnown, Inferred,
             set_plain_corners);
  add_effect(c, "5006#1", 0, "1 = T in a block with G04, G10 or G50 is an alarm", kKnown, Inferred,
             set_tool_with_setting);
  add_effect(c, "0001#1", 0, "FCV: 1 = programs of the series 10 and 11, cycles in one block",
             kKnown, Inferred, set_one_block_cycles);
  add_effect(c, "1202#3", 0, "reset ends the local coordinate system", kKnown, Inferred,
             set_reset_local);
  add_effect(c, "1401#1", 0, "LRP: G00 goes 0 = each axis at its own rate, 1 = on a straight line",
             "30i p.82", Manual, set_straight_rapid);
  add_effect(c, "3402#7", 0, "G23: at power-on 0 = G22, 1 = G23", kKnown, Inferred, set_stroke_off);
  add_effect(c, "1300#0", 0, "OUT: forbidden is 0 = the inside, 1 = the outside of the area of G22",
             kKnown, Inferred, set_stroke_outside);
  add_effect(c, "5105#2", 0, "RF2: G71, G72 of type II cut the profile once more: 0 = yes, 1 = no",
             kKnown, Inferred, set_pocket_pass);
  add_effect(c, "5001#5", 0, "TPH: the offset of G45 to G48 is named by 0 = D, 1 = H", kKnown,
             Inferred, set_longer_by_h);
  add_effect(c, "5440", 0, "how far G60 goes past its point first, mm; its sign is the direction",
             kKnown, Inferred, set_overrun);
  add_effect(c, "5001#0", 0, "1 = length offset on the axis that the block names (type C)", kKnown,
             Inferred, set_length_named);
  add_effect(c, "5001#1", 0, "1 = length offset on the axis across the plane (type B)", kKnown,
             Inferred, set_length_normal);
}

}  // namespace cncsub::fanuc
