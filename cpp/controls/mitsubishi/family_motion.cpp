// Motion as the Mitsubishi controls share it.
#include "controls/mitsubishi/family.hpp"

namespace cncsub::mitsubishi {

void add_family_motion(Control& c) {
  c.longer_words = {"DH", "M7 p.241", Manual};
  c.angle_words = {",A", "general knowledge, linear angle command", Inferred};
  c.angles_on_mills = {true, "general knowledge, linear angle command", Inferred};
  add_parameter(
      c, {"8209", 0, "how far G60 goes past its point first, mm; its sign is the direction", kKnown,
          Inferred, set_overrun});
  c.modal_groups = {"work=12 path=13 macro=14 rotation=16 surface=17 polar=18 mirror=19", kKnown,
                    Inferred};
  c.machine_move = {MachineMove::Modal, "M7 p.520 (4)-(8)", Manual};
  c.no_radius = {NoRadius::Alarm, kKnown, Inferred};
  c.radius_needs_travel = {true, "error 108 of the motion controller Q172", Inferred};
  c.idle_blocks = {3, "M7 p.191, 202, 203", Manual};
  c.missing_radius_offset = {MissingOffset::Alarm, "MZ 839, paired with P170", Secondary};
  c.refuses = {
      "rotation-plane cycle-in-offset reference-with-end reference-with-m local-in-extra-system "
      "tap-without-lead tap-without-speed no-spindle-speed",
      "MZ 824, 901, 920, 921, 949, paired with P111, P155, P435, P436, P438; "
      "MZ 906, 908 with P181, P183",
      Secondary};
  c.radius_needs_travel = {true, "general knowledge; motion controller Q172, error 108", Inferred};
  c.cycle_repeats = {"L", kKnown, Inferred};
  c.other_system_is_first = {true, "excerpts of forum posts on G10", Secondary};
  add_parameter(
      c, {"8112", 0, "a point at P of G04: 0 = what is behind it is cut, 1 = P counts seconds",
          "excerpts of forum posts on #8112; M700V manual, 5.3 (7)", Inferred, set_dwell_point});
  c.dwell_x_increments = {true, "general knowledge; M7 p.203 writes G4 X1000 for a second",
                          Inferred};
  c.g_meanings = {"31.1=skip 31.2=skip 31.3=skip 37=not-computed 37.1=measuring",
                  "M7 p.552, p.555; G37 of a lathe: general knowledge", Manual};
  c.measuring = {Measuring::Words, "M7 p.555", Manual};
  c.skip_own_feed = {true, "M7 p.547 (1)", Manual};
  c.max_skip_signals = {255, "M7 p.555 (2)", Manual};
  c.skip_signals = {SkipSignals::Bits, "M7 p.552 (5), p.555 (3)", Manual};
  c.power_on_line = {true, "M7 p.534 (11): G54 X Y right after power-on alarms P62", Manual};
  c.max_profile_blocks = {100, "MZ 898, paired with P202", Secondary};
  c.small_radius = {SmallRadius::Alarm, "MZ 818, paired with P71", Secondary};
  add_parameter(
      c, {"3402#0", 1, "power-on: 0 in G00, 1 in G01",
          kM7 + "p.534 (11): the first move is a G01; FANUC's number stands for the control's own",
          Manual, set_power_on_line});
  add_parameter(
      c, {"3402#3", 0, "at power-on 0 = G90, 1 = G91; FANUC's number stands for the control's own",
          kKnown, Inferred, set_power_on_incremental});
  add_parameter(c, {"3403#5", 1, "an arc without R, I, J, K: 0 a straight line, 1 an alarm",
                    kGeneral + ": P33; FANUC's number stands for the control's own", Inferred,
                    set_no_radius});
  add_parameter(c, {"3410", 0.1, "how far the radii of an arc's start and end may differ, 0 = any",
                    kM7 + "p.194; stands for #1084 RadErr, its value from general knowledge",
                    Inferred, set_tolerance});
  add_parameter(c, {"1084", 0.1, "RadErr: how far the radii of an arc may differ, mm", "M7 p.194",
                    Manual, set_tolerance});
  add_parameter(
      c, {"5114", 0, "return of G73", kGeneral + "; FANUC's number stands for the control's own",
          Inferred, set_peck_retract});
  add_parameter(
      c, {"5115", 0, "clearance of G83", kGeneral + "; FANUC's number stands for the control's own",
          Inferred, set_peck_clearance});
  add_parameter(
      c, {"5003#0", 0, "the start-up of the radius offset, 1 = type B; stands for #1229 bit 2",
          "M7 p.188", Manual, set_start_up});
}

}  // namespace cncsub::mitsubishi
