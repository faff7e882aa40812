// The motion that the Mitsubishi controls share.
#include "controls/mitsubishi/family.hpp"

namespace cncsub::mitsubishi {

namespace {

/// The parameters that set rules.
const Parameter kParameters[] = {
    {"8209",
     0,
     "how far G60 goes past its point first, mm; its sign is the direction",
     kKnown,
     Inferred,
     {micrometres(rule::one_way_overrun)}},
    {"8112",
     0,
     "a point at P of G04: 0 = what follows it is cut, 1 = P counts seconds",
     "CSDN: excerpts on #8112; the M700V manual, 5.3 (7)",
     Inferred,
     {bit(rule::dwell_point, DwellPoint::Cut, DwellPoint::Seconds)}},
    {"1084",
     0.1,
     "RadErr: how far the radii of an arc may differ, mm",
     "M7 p.194; its value general knowledge",
     Inferred,
     {micrometres(rule::arc_tolerance)}},
    {"1229#2",
     0,
     "the start-up of the radius offset: 0 = type A, 1 = type B",
     "M7 p.188",
     Manual,
     {bit(rule::start_up, StartUp::TypeA, StartUp::TypeB)}},
};

}  // namespace

void add_family_motion(Control& c) {
  c.motion.machine = {MachineType::Mill, "M7 p.31: the G codes of a machining centre", Manual};
  c.motion.longer_words = {"DH", "M7 p.241", Manual};
  c.motion.max_rotation = {0, "M7 p.460 (4): beyond 360 degrees the remainder counts", Manual};
  c.motion.rotation_words = {"R", "M7 p.460", Manual};
  c.motion.angle_words = {",A", "general knowledge, linear angle command", Inferred};
  c.motion.angles_on_mills = {true, "general knowledge, linear angle command", Inferred};
  c.motion.modal_groups = {"work=12 path=13 macro=14 rotation=16 surface=17 polar=18 mirror=19",
                           kKnown, Inferred};
  c.motion.machine_move = {MachineMove::Modal, "M7 p.520 (4)-(8)", Manual};
  c.motion.no_radius = {NoRadius::Alarm, kGeneral + ": P33", Inferred};
  c.motion.idle_blocks = {3, "M7 p.191, 202, 203", Manual};
  c.motion.missing_radius_offset = {MissingOffset::Alarm, "MZ 839, paired with P170", Secondary};
  has(c.common.refuses,
      {Cause::RotationPlane, Cause::CompensationCycle, Cause::ReferenceWithEnd,
       Cause::ReferenceWithM, Cause::LocalInExtraSystem, Cause::TapLead, Cause::TapSpeed,
       Cause::NoSpeed, Cause::ArcFeedZero, Cause::CornerNextShort},
      "MZ 824, 901, 920, 921, 949, paired with P111, P155, P435, P436, P438; "
      "MZ 906, 908 with P181, P183; P121; MZ 914 with P384",
      Secondary);
  has(c.common.refuses, {Cause::NoArcTravel},
      "general knowledge; motion controller Q172, error 108", Inferred);
  c.motion.cycle_repeats = {"L", kKnown, Inferred};
  c.motion.other_system = {OtherSystem::First, "CSDN: excerpts on G10", Secondary};
  c.motion.dwell_unit = {DwellUnit::Milliseconds,
                         "general knowledge; M7 p.203 writes G4 X1000 for a second", Inferred};
  c.motion.g_meanings = {"31.1=skip 31.2=skip 31.3=skip 37=not-computed 37.1=measuring",
                         "M7 p.552, p.555; G37 of a lathe: general knowledge", Manual};
  c.motion.measuring = {Measuring::Words, "M7 p.555", Manual};
  c.motion.skip_own_feed = {true, "M7 p.547 (1)", Manual};
  c.motion.max_skip_signals = {255, "M7 p.555 (2)", Manual};
  c.motion.skip_signals = {SkipSignals::Bits, "M7 p.552 (5), p.555 (3)", Manual};
  has(c.common.power_on, {PowerOn::G01}, "M7 p.534 (11): G54 X Y right after power-on alarms P62",
      Manual);
  c.turning.max_profile_blocks = {100, "MZ 898, paired with P202", Secondary};
  c.motion.small_radius = {SmallRadius::Alarm, "MZ 818, paired with P71", Secondary};
  lacks(c.common.power_on, {PowerOn::G91}, kGeneral, Inferred);
  add_parameters(c, kParameters);
}

}  // namespace cncsub::mitsubishi
