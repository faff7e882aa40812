// The motion that the FANUC controls share.
#include "controls/fanuc/family.hpp"

namespace cncsub::fanuc {

namespace {

/// TLC has precedence over TLB, whichever of them is set last.
const Setting kLengthType =
    first_of(rule::length_type, {{"5001#0", LengthType::Named}, {"5001#1", LengthType::Normal}},
             LengthType::Z);

/// The parameters of the modes, the cycles and the offsets.
const Parameter kParameters[] = {
    {"3402#0",
     0,
     "G01: at power-on 0 = G00, 1 = G01",
     kKnown,
     Inferred,
     {entry(rule::power_on, PowerOn::G01)}},
    {"3402#3",
     0,
     "G91: at power-on 0 = G90, 1 = G91",
     kKnown,
     Inferred,
     {entry(rule::power_on, PowerOn::G91)}},
    {"3402#4",
     0,
     "FPM: lathes at power-on 0 = feed per revolution, 1 = feed per minute",
     kKnown,
     Inferred,
     {entry_while_zero(rule::power_on, PowerOn::G95)}},
    {"3402#6",
     0,
     "CLR: reset, M02 and M30 0 = keep the modal codes, 1 = go back to the power-on state",
     kKnown,
     Inferred,
     {entry(rule::reset_clears, Cleared::Codes)}},
    {"3403#4",
     0,
     "RER: an arc whose radius is too small: 0 = a half circle inside the tolerance of 3410, 1 = "
     "alarm",
     kKnown,
     Inferred,
     {bit(rule::small_radius, SmallRadius::HalfCircle, SmallRadius::Alarm)}},
    {"3403#5",
     0,
     "CIR: an arc without R, I, J and K: 0 = a straight line, 1 = alarm",
     kKnown,
     Inferred,
     {bit(rule::no_radius, NoRadius::Line, NoRadius::Alarm)}},
    {"3410",
     0,
     "how much the radius of an arc's end may differ from its start's, 0 = not checked",
     k16Tc,
     Manual,
     {micrometres(rule::arc_tolerance)}},
    {"5003#0",
     0,
     "SUP: the start-up of the radius offset is 0 = type A, 1 = type B",
     k16Mc,
     Manual,
     {bit(rule::start_up, StartUp::TypeA, StartUp::TypeB)}},
    {"5114",
     0,
     "the retract d of G73, mm",
     k30iM,
     Manual,
     {micrometres_unless_zero(rule::peck_retract)}},
    {"5115",
     0,
     "the clearance d of G83, mm",
     k30iM,
     Manual,
     {micrometres_unless_zero(rule::peck_clearance)}},
    {"5132",
     0,
     "the depth of cut of G71 and G72, mm",
     kKnown,
     Inferred,
     {micrometres_unless_zero(rule::rough_depth)}},
    {"5133",
     0,
     "the escape of G71 and G72, mm",
     kKnown,
     Inferred,
     {micrometres_unless_zero(rule::rough_escape)}},
    {"5130", 0, "the run-out of a thread cycle", kKnown, Inferred, {number(rule::thread_chamfer)}},
    {"5139",
     0,
     "the retract of G74 and G75, mm",
     kKnown,
     Inferred,
     {micrometres(rule::groove_retract)}},
    {"5140",
     0,
     "the least cut of G76, mm",
     kKnown,
     Inferred,
     {micrometres(rule::thread_least_cut)}},
    {"5141",
     0,
     "the finishing allowance of G76, mm",
     kKnown,
     Inferred,
     {micrometres(rule::thread_allowance)}},
    {"5142", 1, "the finishing passes of G76", kKnown, Inferred, {number(rule::thread_passes)}},
    {"5143", 0, "the angle of G76, degrees", kKnown, Inferred, {number(rule::thread_angle)}},
    {"1411",
     0,
     "the feed in force at power-on, 0 = none",
     kKnown,
     Inferred,
     {number(rule::power_on_feed)}},
    // Cases of lathes write chamfers without a comma, which CCR allows.
    {"3405#4",
     1,
     "CCR: 1 = C and R make corners without a comma (lathes)",
     kKnown,
     Inferred,
     {bit(rule::chamfer_words, ",C", ",C C"), bit(rule::round_words, ",R", ",R R"),
      bit(rule::angle_words, ",A", ",A A")}},
    {"5006#1",
     0,
     "1 = T in a block with G04, G10 or G50 is an alarm",
     kKnown,
     Inferred,
     {entry(rule::refuses, Cause::ToolWithSetting)}},
    {"0001#1",
     0,
     "FCV: 1 = cycles in the one-block form of the Series 10/11/15",
     kKnown,
     Inferred,
     {bit(rule::one_block_cycles)}},
    {"1202#3",
     0,
     "RLC: 1 = reset ends the local coordinate system",
     kKnown,
     Inferred,
     {entry(rule::reset_clears, Cleared::LocalSystem)}},
    {"1401#1",
     0,
     "LRP: G00 moves 0 = each axis at its own rate, 1 = on a straight line",
     k30i,
     Manual,
     {bit(rule::rapid_way, RapidWay::OwnRates, RapidWay::Straight)}},
    {"3402#7",
     0,
     "G23: at power-on 0 = G22, 1 = G23",
     kKnown,
     Inferred,
     {entry_while_zero(rule::power_on, PowerOn::G22)}},
    {"1300#0",
     0,
     "OUT: forbidden is 0 = the inside, 1 = the outside of the area of G22",
     kKnown,
     Inferred,
     {bit(rule::stroke_area, StrokeCheck::InsideForbidden, StrokeCheck::OutsideForbidden)}},
    {"5105#2",
     0,
     "RF2: G71, G72 of type II cut the profile once more: 0 = yes, 1 = no",
     kKnown,
     Inferred,
     {bit(rule::pocket_pass, PocketPass::Always, PocketPass::Never)}},
    {"5001#5",
     0,
     "TPH: the offset of G45 to G48 is named by 0 = D, 1 = H",
     kKnown,
     Inferred,
     {bit(rule::longer_words, "D", "H")}},
    {"5440",
     0,
     "how far G60 goes past its point first, mm; its sign is the direction",
     kKnown,
     Inferred,
     {micrometres(rule::one_way_overrun)}},
    {"5001#0",
     0,
     "TLC: 1 = the length offset works on the axis named in the block (type C)",
     kKnown,
     Inferred,
     {kLengthType}},
    {"5001#1",
     0,
     "TLB: 1 = the length offset works on the axis normal to the plane (type B)",
     kKnown,
     Inferred,
     {kLengthType}},
};

/// Add the parameters that say which signals G31 and G04 watch.
void skip_parameters(Control& c) {
  for (int p = 1; p <= 4; ++p) {
    const std::string number = std::to_string(p);
    c.parameters.push_back(
        read_by(rule::skip_signals,
                {std::to_string(6201 + p), static_cast<double>(1 << (p - 1)),
                 std::string("the skip signals of G31 P")
                     .append(number)
                     .append(" and G04 Q")
                     .append(number)
                     .append(": bit 0 is SKIP, bit 7 SKIP8"),
                 "general knowledge; that each has its own signal is policy", Inferred}));
  }
  c.parameters.push_back(
      read_by(rule::skip_signals,
              {"6206", 0, "the skip signals of G04 without Q: bit 0 is SKIP, bit 7 SKIP8", kKnown,
               Inferred}));
}

}  // namespace

void add_family_motion(Control& c) {
  c.motion.machine = {MachineType::Mill, "source 003 is of a mill; the setup tells a lathe",
                      SourceDocument};
  c.motion.negative_radius = {NegativeRadius::LongWay, "source 003, example 5", SourceDocument};
  c.motion.machine_move = {MachineMove::Rapid, "source 003, G53; 0iMB p.228", SourceDocument};
  has(c.common.refuses,
      {Cause::ReferenceInCycle, Cause::CornerOffset, Cause::GrooveEscape, Cause::RigidMove,
       Cause::RigidSpeed, Cause::ArcFeedZero},
      "ALM 025, 039, 044, 062; 200 and 204 from general knowledge", Secondary);
  c.motion.computed_lengths = {ComputedLengths::Rounded, cite({kJix, kXia}), Secondary};
  c.motion.idle_blocks = {1, "source 003, note a", SourceDocument};
  c.motion.measuring = {Measuring::Of6241,
                        "general knowledge; TDi 17, TApar 6241 to 6255: the same rule", Inferred};
  measuring_parameters(c, kKnown, Inferred);
  c.motion.skip_signals = {SkipSignals::Parameters, "general knowledge, multi-step skip", Inferred};
  skip_parameters(c);
  c.motion.helix = {Helix::MillsOnly, "ALM 021; helices of lathes are an option", Inferred};
  has(c.motion.data_forms, {DataForm::WithoutL},
      "general knowledge; a repost of the 0i manual: memory A", Inferred);
  c.motion.acute_corner = {AcuteCorner::Lines, kKnown, Inferred};
  c.turning.chamfer_ik = {true, kKnown, Inferred};
  c.motion.angle_words = {",A", "ALM 056 to 058: direct drawing dimension programming", Secondary};
  c.motion.cycle_repeats = {"K", "WEIC: K is the number of repeats", Secondary};
  c.motion.zero_cycle_repeats = {ZeroCycleRepeats::Store, "CCI: L0 sets a cycle up, no hole",
                                 Secondary};
  c.motion.peck_words = {c.motion.peck_words.value, "30iM p.73: d is a parameter, Q the peck",
                         Manual};
  c.motion.dwell_words = {"PXU", "GCP: P in milliseconds, X and U in seconds", Secondary};
  c.motion.unit_change = {UnitChange::Anywhere, "30i p.226: a warning, no alarm", Manual};
  has(c.common.power_on, {PowerOn::G95}, "general knowledge: 3402#4", Inferred);
  c.motion.max_rotation = {360, "0iA p.618: 5410 from -360 to 360 degrees", Manual};
  c.motion.rotation_words = {"R", "0iA p.618; 16MC p.375; 15iM p.492", Manual};
  add_parameters(c, kParameters);
}

}  // namespace cncsub::fanuc
