// Motion rules, parameters and alarms of every maker. The keys of the sources stand in sources.def.
#include <algorithm>
#include <initializer_list>

#include "cncsub/number.hpp"
#include "controls/facts.hpp"

namespace cncsub {
namespace {

using enum Evidence;

constexpr const char* kKnown = "general knowledge";

struct AlarmRow {
  Cause cause;
  const char* number;
  const char* text;
  const char* source;
  Evidence evidence;
};

void add_alarms(Control& c, std::initializer_list<AlarmRow> rows) {
  for (const AlarmRow& row : rows)
    c.alarms.insert({row.cause, {row.number, row.text, row.source, row.evidence}});
}

/// Gives a parameter its effect; one the control's own list already has keeps its value and its
/// source. What it sets comes from it.
void add_effect(Control& c, const char* name, double value, const char* meaning, const char* source,
                Evidence evidence, void (*effect)(Control&, double)) {
  auto p = std::find_if(c.parameters.begin(), c.parameters.end(),
                        [name](const Parameter& known) { return known.name == name; });
  if (p == c.parameters.end())
    p = c.parameters.insert(p, {name, value, meaning, source, evidence, nullptr});
  p->effect = effect;
  const Answers before(c);
  effect(c, p->value);
  follow(c, before, "parameter " + p->name + " as delivered: " + p->source, p->evidence);
}

int whole(double v) { return to_whole<int>(v, -2'000'000'000, 2'000'000'000); }
int micrometres(double millimetres) { return whole(millimetres * 1000 + 0.5); }

void set_tolerance(Control& c, double v) { c.arc_tolerance.value = micrometres(v); }
void set_power_on_line(Control& c, double v) { c.power_on_line.value = v != 0; }
void set_power_on_incremental(Control& c, double v) { c.power_on_incremental.value = v != 0; }
void set_power_on_per_minute(Control& c, double v) { c.power_on_per_minute.value = v != 0; }
void set_power_on_feed(Control& c, double v) { c.power_on_feed.value = whole(v); }
void set_clear_on_reset(Control& c, double v) { c.clear_on_reset.value = v != 0; }
void set_no_radius(Control& c, double v) {
  c.no_radius.value = v != 0 ? NoRadius::Alarm : NoRadius::Line;
}
void set_small_radius(Control& c, double v) {
  c.small_radius.value = v != 0 ? SmallRadius::Alarm : SmallRadius::HalfCircle;
}
void set_start_up(Control& c, double v) {
  c.start_up.value = v != 0 ? StartUp::TypeB : StartUp::TypeA;
}
void set_plain_corners(Control& c, double v) {
  c.chamfer_words.value = v != 0 ? ",C C" : ",C";
  c.round_words.value = v != 0 ? ",R R" : ",R";
  c.angle_words.value = v != 0 ? ",A A" : ",A";
}
// 0 leaves the engine's own half a millimetre: a retract of nothing would break no chip.
void set_longer_by_h(Control& c, double v) { c.longer_words.value = v != 0 ? "H" : "D"; }
void set_straight_rapid(Control& c, double v) { c.straight_rapid.value = v != 0; }
void set_stroke_off(Control& c, double v) { c.power_on_stroke_check.value = v == 0; }
void set_stroke_outside(Control& c, double v) { c.stroke_outside.value = v != 0; }
void set_type_by_shape(Control& c, double v) { c.type_by_shape.value = v == 0; }
void set_pocket_pass(Control& c, double v) {
  c.pocket_pass.value = v != 0 ? PocketPass::Never : PocketPass::Always;
}
void set_dwell_point(Control& c, double v) {
  c.dwell_point.value = v != 0 ? DwellPoint::Seconds : DwellPoint::Cut;
}
void set_overrun(Control& c, double v) {
  c.one_way_overrun.value = v < 0 ? -micrometres(-v) : micrometres(v);
}
void set_peck_retract(Control& c, double v) {
  if (v > 0) c.peck_retract.value = micrometres(v);
}
void set_peck_clearance(Control& c, double v) {
  if (v > 0) c.peck_clearance.value = micrometres(v);
}
void set_rough_depth(Control& c, double v) {
  if (v > 0) c.rough_depth.value = micrometres(v);
}
void set_rough_escape(Control& c, double v) {
  if (v > 0) c.rough_escape.value = micrometres(v);
}
void set_thread_chamfer(Control& c, double v) { c.thread_chamfer.value = whole(v); }
void set_thread_passes(Control& c, double v) { c.thread_passes.value = whole(v); }
void set_thread_angle(Control& c, double v) { c.thread_angle.value = whole(v); }
void set_thread_least_cut(Control& c, double v) { c.thread_least_cut.value = micrometres(v); }
void set_thread_allowance(Control& c, double v) { c.thread_allowance.value = micrometres(v); }
void set_groove_retract(Control& c, double v) { c.groove_retract.value = micrometres(v); }
void set_one_block_cycles(Control& c, double v) { c.one_block_cycles.value = v != 0; }
void set_monotone(Control& c, double v) {
  c.profile_monotone.value = v != 0 ? MonotoneCheck::Always : MonotoneCheck::Never;
}
void set_full_retract(Control& c, double v) { c.drill_full_retract.value = v != 0; }
void set_bore_return(Control& c, double v) { c.bore_return.value = v > 0 ? whole(v) : 200; }
void set_max_feed(Control& c, double v) { c.max_feed.value = whole(v); }
void set_acute_corner(Control& c, double v) {
  c.acute_corner.value = v != 0 ? AcuteCorner::Arc : AcuteCorner::Lines;
}
void set_reset_local(Control& c, double v) { c.clear_local_on_reset.value = v != 0; }
void set_machine_system(Control& c, double v) {
  c.machine.value = v != 0 ? MachineType::LatheB : MachineType::LatheA;
}
void set_coordinate_refused(Control& c, double v) { c.set_coordinate_alarms.value = v != 0; }
void set_offset_digits(Control& c, double v) { c.tool_offset_digits.value = v != 0 ? 2 : 1; }
void set_length_named(Control& c, double v) {
  c.length_type.value = v != 0 ? LengthType::Named : LengthType::Z;
}
void set_length_normal(Control& c, double v) {
  if (v != 0) c.length_type.value = LengthType::Normal;
}
void set_tool_motion(Control& c, double v) {
  c.tool_offset.value = v != 0 ? ToolOffset::NextMove : ToolOffset::Shift;
}
void set_cycle_increments(Control& c, double v) { c.cycle_increments.value = v != 0; }
void set_cycle_millimetres(Control& c, double v) { c.cycle_increments.value = v == 0; }
void set_chamfer_length(Control& c, double v) {
  c.chamfer_length.value = v != 0 ? ChamferLength::Corner : ChamferLength::Line;
}

/// Adds a conflict to those that the control refuses, or takes it away.
void set_refused(Control& c, const std::string& cause, bool refused) {
  std::string list = " " + c.refuses.value + " ";
  const auto found = list.find(" " + cause + " ");
  if ((found != std::string::npos) == refused) return;
  if (refused)
    list += cause;
  else
    list.erase(found, cause.size() + 1);
  const auto first = list.find_first_not_of(' '), last = list.find_last_not_of(' ');
  c.refuses.value = first == std::string::npos ? "" : list.substr(first, last - first + 1);
}
void set_tool_with_setting(Control& c, double v) { set_refused(c, "tool-with-setting", v != 0); }

void set_measuring_subtracts(Control& c, double v) { c.measuring_subtracts.value = v != 0; }

/// G36 and G37 of FANUC and of the GSK 988.
void measuring_parameters(Control& c, const char* source, Evidence evidence) {
  const auto add = [&](const char* name, const char* meaning) {
    c.parameters.push_back({name, 0, meaning, source, evidence, nullptr});
  };
  add("6241", "the measuring feed of G36 and G37, mm/min");
  add("6251", "G36, and G37 of a mill: how far before the point the measuring feed begins, mm");
  add("6252", "G37 of a lathe: how far before the point the measuring feed begins, mm");
  add("6254", "G36, and G37 of a mill: within what distance of the point the tool arrives, mm");
  add("6255", "G37 of a lathe: within what distance of the point the tool arrives, mm");
  add_effect(c, "6210#6", 0, "what G36 and G37 measure is 0 added to the offset, 1 subtracted",
             source, evidence, set_measuring_subtracts);
}

/// The parameters that FANUC and the GSK 988 number alike.
void fanuc_numbers(Control& c, const char* source, Evidence evidence, double power_on_feed) {
  add_effect(c, "3402#0", 0, "at power-on 0 = G00, 1 = G01", source, evidence, set_power_on_line);
  add_effect(c, "3402#3", 0, "at power-on 0 = G90, 1 = G91", source, evidence,
             set_power_on_incremental);
  add_effect(c, "3402#4", 0, "lathes at power-on 0 = feed per revolution, 1 = per minute", source,
             evidence, set_power_on_per_minute);
  add_effect(c, "3402#6", 0, "at reset and M30 0 = modal codes stay, 1 = those of power-on", source,
             evidence, set_clear_on_reset);
  add_effect(c, "3403#4", 0, "R too small: 0 = a half circle inside the tolerance, 1 = alarm",
             source, evidence, set_small_radius);
  add_effect(c, "3403#5", 0, "an arc without R, I, J, K: 0 = a line, 1 = alarm", source, evidence,
             set_no_radius);
  add_effect(c, "3410", 0, "how far the radii of an arc may differ, mm, 0 = not checked", source,
             evidence, set_tolerance);
  add_effect(c, "1411", power_on_feed, "the feed at power-on", source, evidence, set_power_on_feed);
  add_effect(c, "5003#0", 0, "the start-up of the radius offset: 0 = type A, 1 = type B", source,
             evidence, set_start_up);
  add_effect(c, "5114", 0, "the retract of the fast pecking cycle, mm", source, evidence,
             set_peck_retract);
  add_effect(c, "5115", 0, "the clearance of the pecking cycle, mm", source, evidence,
             set_peck_clearance);
  add_effect(c, "5132", 0, "the depth of cut of G71 and G72, mm", source, evidence,
             set_rough_depth);
  add_effect(c, "5133", 0, "the escape of G71 and G72, mm", source, evidence, set_rough_escape);
  add_effect(c, "5130", 0, "the run-out of G92 and G76, tenths of the lead", source, evidence,
             set_thread_chamfer);
  add_effect(c, "5139", 0, "the retract of G74 and G75, mm", source, evidence, set_groove_retract);
  add_effect(c, "5140", 0, "the least cut of G76, mm", source, evidence, set_thread_least_cut);
  add_effect(c, "5141", 0, "the finishing allowance of G76, mm", source, evidence,
             set_thread_allowance);
  add_effect(c, "5142", 1, "the finishing passes of G76", source, evidence, set_thread_passes);
  add_effect(c, "5143", 0, "the angle of G76, degrees", source, evidence, set_thread_angle);
}

// ---- FANUC ----

void fanuc_rules(Control& c) {
  c.machine = {MachineType::Mill, "the setup tells a lathe", Inferred};
  c.negative_radius = {true, "source 003, example 5", SourceDocument};
  c.machine_move = {MachineMove::Rapid, "source 003, G53; 0iMB p.228", SourceDocument};
  c.refuses = {"reference-in-cycle corner-at-offset-start groove-escape move-before-rigid-tap",
               "ALM 039, 044, 062; 204 from general knowledge", Secondary};
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
  fanuc_numbers(c, kKnown, Inferred, 0);
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

// ---- Mitsubishi ----

void mitsubishi_rules(Control& c) {
  c.longer_words = {"DH", "M7 p.241", Manual};
  c.angle_words = {",A", "general knowledge, linear angle command", Inferred};
  c.angles_on_mills = {true, "general knowledge, linear angle command", Inferred};
  add_effect(c, "8209", 0, "how far G60 goes past its point first, mm; its sign is the direction",
             kKnown, Inferred, set_overrun);
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
  add_effect(c, "8112", 0,
             "a point at P of G04: 0 = what is behind it is cut, 1 = P counts seconds",
             "excerpts of forum posts on #8112; M700V manual, 5.3 (7)", Inferred, set_dwell_point);
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
  add_effect(c, "3402#0", 1,
             "at power-on 0 = G00, 1 = G01; FANUC's number stands for the control's own",
             "M7 p.534 (11)", Manual, set_power_on_line);
  add_effect(c, "3402#3", 0,
             "at power-on 0 = G90, 1 = G91; FANUC's number stands for the control's own", kKnown,
             Inferred, set_power_on_incremental);
  add_effect(c, "3403#5", 1, "an arc without R, I, J, K: 0 = a line, 1 = alarm", kKnown, Inferred,
             set_no_radius);
  add_effect(c, "3410", 0.1, "how far the radii of an arc may differ, mm; stands for #1084 RadErr",
             "M7 p.194", Manual, set_tolerance);
  add_effect(c, "1084", 0.1, "RadErr: how far the radii of an arc may differ, mm", "M7 p.194",
             Manual, set_tolerance);
  add_effect(c, "5114", 0, "the return of G73, mm; FANUC's number stands for #8012", kKnown,
             Inferred, set_peck_retract);
  add_effect(c, "5115", 0, "the clearance of G83, mm; FANUC's number stands for #8013", kKnown,
             Inferred, set_peck_clearance);
  add_effect(c, "5003#0", 0,
             "the start-up of the radius offset, 1 = type B; stands for #1229 bit 2", "M7 p.188",
             Manual, set_start_up);
}

void mitsubishi_alarms(Control& c) {
  add_alarms(
      c,
      {{Cause::NoRadius, "P33", "Format error", kKnown, Inferred},
       {Cause::ReferenceNumber, "P35", "Setting value range over", kKnown, Inferred},
       {Cause::NoFeed, "P62", "No F command", "M7 p.52", Manual},
       {Cause::RadiusTolerance, "P70", "Arc end point deviation large", "MZ 817, paired",
        Secondary},
       {Cause::RadiusTooSmall, "P71", "Arc center error", "MZ 818, paired", Secondary},
       {Cause::ThreadLead, "P93", "Illegal pitch value", kKnown, Inferred},
       {Cause::RotationPlane, "P111", "Plane selected while coordinate rotation", "MZ 824, paired",
        Secondary},
       {Cause::CompensationPlane, "P112", "Plane selected while R compensation", "MZ 825, paired",
        Secondary},
       {Cause::ArcAxis, "P113", "Illegal plane select", kKnown, Inferred},
       {Cause::CompensationArc, "P151", "Radius compensation in arc mode", "M7 p.194", Manual},
       {Cause::CompensationEndArc, "P151", "Radius compensation in arc mode", "M7 p.194", Manual},
       {Cause::CompensationNoIntersection, "P152", "No intersection", "M7 p.194", Manual},
       {Cause::CompensationInterference, "P153", "Compensation interference", "MZ 837, paired",
        Secondary},
       {Cause::CompensationArcTooSmall, "P153", "Compensation interference", kKnown, Inferred},
       {Cause::CompensationArcStart, "P153", "Compensation interference", kKnown, Inferred},
       {Cause::CompensationArcEnd, "P153", "Compensation interference", kKnown, Inferred},
       {Cause::CompensationCycle, "P155", "Fixed cycle exec during compensation", "MZ 901, paired",
        Secondary},
       {Cause::OffsetNumber, "P170", "No offset number", "MZ 839, paired", Secondary},
       {Cause::RadiusOffsetNumber, "P170", "No offset number", "MZ 839, paired", Secondary},
       {Cause::Taper, "P191", "Taper length error", "general knowledge of the Mitsubishi list",
        Inferred},
       {Cause::FaceTaper, "P191", "Taper length error", "general knowledge of the Mitsubishi list",
        Inferred},
       {Cause::PqNotFound, "P201", "Program error (MRC)", "MZ 897, paired", Secondary},
       {Cause::NoSpeed, "P132", "", "general knowledge", Inferred},
       {Cause::ProfileTooLong, "P202", "Block over (MRC)", "MZ 898, paired", Secondary},
       {Cause::ProfileNotMonotone, "P203", "Program error (MRC)", "MZ 897, paired", Secondary},
       {Cause::CornerNoMove, "P382", "No corner movement", "MZ 912, paired", Secondary},
       {Cause::CornerTooShort, "P383", "Corner movement short", "MZ 913, paired", Secondary},
       {Cause::CornerInRapid, "P385", "G0 G33 in corner", "MZ 951, paired", Secondary},
       {Cause::CornerPlane, "P396", "Plane command in corner", "MZ 919, paired", Secondary},
       {Cause::TapSpeed, "P181", "No spindle command (Tap)", "MZ 906, paired", Secondary},
       {Cause::TapLead, "P183", "No pitch/thread number", "MZ 908, paired", Secondary},
       {Cause::ReferenceWithM, "P436", "G29 and M commands in one block", "MZ 921, paired",
        Secondary},
       {Cause::LocalInExtraSystem, "P438", "G52 invalid during G54.1", "MZ 949, paired", Secondary},
       {Cause::NotHomed, "P430", "R-pnt return incomplete", "MZ 880, paired", Secondary},
       {Cause::ReferenceNotHomed, "P430", "R-pnt return incomplete", "MZ 880, paired", Secondary},
       {Cause::NotAtReference, "P434", "Compare error", "MZ 884, paired", Secondary},
       {Cause::ReferenceWithEnd, "P435", "G27 and M commands in one block", "MZ 920, paired",
        Secondary},
       {Cause::OverTravel, "M01 0007", "", "SK M01-0007", Secondary},
       {Cause::MeasuringMissed, "P607", "TLM signal outside its range", kKnown, Inferred},
       {Cause::MeasuringEarly, "P607", "TLM signal outside its range", kKnown, Inferred},
       {Cause::MeasuringAxis, "P604", "TLM axis", kKnown, Inferred},
       {Cause::MeasuringWithOffset, "P605", "H and TLM in one block", kKnown, Inferred},
       {Cause::MeasuringOffset, "P606", "no H before TLM", kKnown, Inferred},
       {Cause::CompensationSkip, "P608", "Skip during radius compensation", "M7 p.547 (6)", Manual},
       {Cause::NoSkipFeed, "P603", "Skip speed 0", "M7 p.547 (7)", Manual}});
}

// ---- HNC ----

void hnc_rules(Control& c) {
  c.g_meanings = {
      "22=pulses 24=mirror 25=mirror-off 7=not-computed 11=not-computed 12=not-computed "
      "34=not-computed 65=not-computed 10=none 15=none 16=none 31=none 96=none 45=none 46=none "
      "47=none 48=none",
      "source 003, G22; the others from general knowledge", SourceDocument};
  c.power_on_line = {false, "inferred from source 003, typical example: Z5 before any F", Inferred};
  c.dwell_p_seconds = {true, "source 003, G04", SourceDocument};
  c.no_radius = {NoRadius::Alarm, kKnown, Inferred};
  c.cycle_repeats = {"L", kKnown, Inferred};
  c.peck_words = {PeckWords::K, kKnown, Inferred};
  c.scale_thousandths = {false, kKnown, Inferred};
  c.machine_move = {MachineMove::Rapid, "source 003, G53", SourceDocument};
  c.unit_change = {UnitChange::AtHead, "source 003, G20 G21 G22, and its typical example",
                   SourceDocument};
  c.rotation_words = {"P", kKnown, Inferred};
  add_effect(c, "3402#0", 0, "stands for: at power-on 0 = G00, 1 = G01", kKnown, Inferred,
             set_power_on_line);
  add_effect(c, "3403#5", 1, "stands for: an arc without R, I, J and K is 0 = a line, 1 = an alarm",
             kKnown, Inferred, set_no_radius);
  add_effect(c, "3410", 0,
             "stands for: how far the radii of an arc may differ, mm, 0 = not checked", kKnown,
             Inferred, set_tolerance);
}

// ---- GSK ----

void lathe_rules(Control& c) {
  c.machine = {MachineType::LatheA, "TDi 2: X Z absolute, U W increments", Manual};
  c.escape = {ReturnedEscape::Feed, "TDi 23.1 step 4; TA 8", Manual};
  c.lead_apart = {true, "TDi 24.1: F of a thread stays until the next one", Manual};
  c.lead_growth = {"R", "TDi 24.4; TA 17", Manual};
}

void gsk_988(Control& c, double power_on_feed) {
  lathe_rules(c);
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
  add_effect(c, "5102#1", 1, "G71 to G73: 1 = a profile that turns back is an alarm", "TA 8",
             Manual, set_monotone);
  add_effect(c, "5102#2", 0, "AUT: type I or II of G71 and G72 0 by the shape, 1 by block ns",
             "TA 8", Manual, set_type_by_shape);
  add_effect(c, "5105#2", 0, "G71, G72 of type II cut the profile once more: 0 = yes, 1 = no",
             "TA 8", Manual, set_pocket_pass);
  add_effect(c, "5101#2", 0, "RTR: a pecking cycle draws back 0 a little, 1 to R", "TA 24", Manual,
             set_full_retract);
  add_effect(c, "5149", 0, "the way out of a boring cycle, percent of the feed, 0 = 200", "TA 26",
             Manual, set_bore_return);
  c.cycle_point = {true, "TA 12, 13, 21: P3.000", Manual};
  c.run_out_words = {RunOutWords::Across, "TA 14, TA 18", Manual};
  c.thread_needs_spindle = {true, "Talm 102", Manual};
  c.helix = {false, "Talm 033", Manual};
  c.contour_behind = {false, "TA 8", Manual};
  c.cycle_repeats = {"K", "TA 24: K 1 to 99", Manual};
  c.zero_cycle_repeats = {ZeroCycleRepeats::Alarm, "Talm 181", Manual};
  c.max_cycle_repeats = {99, "TA 24: K 1 to 99; Talm 181", Manual};
  c.power_on_per_minute = {false, "TApar 3402#4", Manual};
  // The examples of the 988TA feed without F; the 988T has an alarm for that. [source 000, Talm
  // 021]
  fanuc_numbers(c, "TApar", Manual, power_on_feed);
  add_effect(c, "1401#1", 0, "LRP: G00 goes 0 = each axis at its own rate, 1 = on a straight line",
             "TApar 1401#1", Manual, set_straight_rapid);
  add_effect(c, "3401#1", 0, "CPQ: P and Q of cycles are 0 millimetres, 1 least increments",
             "TApar 3401#1", Manual, set_cycle_increments);
  add_effect(c, "3401#6", 0, "G code system: 0 A, 1 B", "TApar 3401#6", Manual, set_machine_system);
  add_effect(c, "3405#4", 1, "CDR: 1 = C and R make corners without a comma", "TApar 3405#4",
             Manual, set_plain_corners);
  add_effect(c, "1202#2", 0, "1 = G50 is an alarm", "TApar 1202#2", Manual, set_coordinate_refused);
  add_effect(c, "1202#3", 0, "RLC: reset ends the local coordinate system", "TApar 1202#3", Manual,
             set_reset_local);
  add_effect(c, "5006#1", 0, "1 = T in a block with G04, G10 or G50 is an alarm", "Talm 028",
             Manual, set_tool_with_setting);
  add_effect(c, "5002#0", 1, "digits of T that name the offset: 0 one, 1 two", "TApar 5002#0",
             Manual, set_offset_digits);
  add_effect(c, "5002#4", 0,
             "LGT: the offset is 0 a shift of the coordinates, 1 a motion of the tool",
             "TApar 5002#4", Manual, set_tool_motion);
  add_alarms(
      c,
      {{Cause::NoFeed, "021", "no feed, or one that does not fit G98 and G99", "Talm 021", Manual},
       {Cause::OffsetNumber, "026", "offset number", "Talm 026", Manual},
       {Cause::RadiusOffsetNumber, "026", "offset number", "Talm 026", Manual},
       {Cause::LengthAxis, "027", "no axis for the length offset", "Talm 027", Manual},
       {Cause::ArcAxis, "033", "axis outside the plane of the arc", "Talm 033", Manual},
       {Cause::NoRadius, "034", "neither R nor I, J, K", "Talm 034", Manual},
       {Cause::RadiusTooSmall, "035", "R too small", "Talm 035", Manual},
       {Cause::RadiusTolerance, "036", "the radii of start and end differ", "Talm 036", Manual},
       {Cause::ThreadLead, "038", "thread lead", "Talm 038", Manual},
       {Cause::UnitChangeLate, "042", "G20, G21 not alone at the head", "Talm 042", Manual},
       {Cause::NotAtReference, "045", "G27 not at the reference point", "Talm 045", Manual},
       {Cause::NotHomed, "043", "the machine zero is not known", "Talm 043", Manual},
       {Cause::ReferenceNotHomed, "047", "G30 before the machine zero is known", "Talm 047",
        Manual},
       {Cause::ReferenceNumber, "048", "P of G30", "Talm 048", Manual},
       {Cause::MeasuringMissed, "051", "no arrival signal in G36, G37", "Talm 051", Manual},
       {Cause::MeasuringEarly, "051", "no arrival signal in G36, G37", "Talm 051: in the zone",
        Inferred},
       {Cause::MeasuringOffset, "052", "no offset number in G36, G37", "Talm 052", Manual},
       {Cause::MeasuringWithOffset, "053", "T in G36, G37", "Talm 053", Manual},
       {Cause::MeasuringAxis, "054", "illegal axis in G36, G37", "Talm 054", Manual},
       {Cause::MeasuringIncremental, "054", "illegal axis in G36, G37", "Talm 054", Manual},
       {Cause::MeasuringZone, "054", "illegal axis in G36, G37", "Talm 054", Manual},
       {Cause::MeasuringInCompensation, "056", "G36, G37 in G41, G42", "Talm 056", Manual},
       {Cause::SkipPerRevolution, "058", "G31 in feed per revolution", "Talm 058", Manual},
       {Cause::CompensationSkip, "059", "G31 in G41, G42", "Talm 059", Manual},
       {Cause::G10L, "061", "L of G10", "Talm 061", Manual},
       {Cause::G10P, "062", "P of G10", "Talm 062", Manual},
       {Cause::G10System, "062", "P of G10", "Talm 062", Manual},
       {Cause::G10Offset, "062", "P of G10", "Talm 062", Manual},
       {Cause::G10Word, "062", "P of G10", "Talm 062", Manual},
       {Cause::StrokeArea, "068", "the range of the stroke check", "Talm 068", Manual},
       {Cause::CornerOffset, "271", "chamfer in a block that takes none", "Talm 271", Manual},
       {Cause::ToolWithSetting, "028", "T in a block that takes none", "Talm 028", Manual},
       {Cause::SpindleStands, "102", "thread at spindle speed 0", "Talm 102", Manual},
       {Cause::Taper, "123", "taper of G90, G92", "Talm 123", Manual},
       {Cause::FaceTaper, "124", "taper of G94", "Talm 124", Manual},
       {Cause::ProfileCall, "131", "a call in the profile", "Talm 131", Manual},
       {Cause::PqMissing, "133", "P or Q missing", "Talm 133", Manual},
       {Cause::PqNotFound, "134", "P or Q not found", "Talm 134", Manual},
       {Cause::ProfileNotMonotone, "138", "the profile is not monotone", "Talm 138", Manual},
       {Cause::ProfileFirstBlock, "144", "ns is not G00 or G01", "Talm 144", Manual},
       {Cause::CycleDepth, "148", "depth of cut", "Talm 148", Manual},
       {Cause::CyclePlane, "126", "plane of a multiple cycle", "Talm 126", Manual},
       {Cause::CycleAxis, "127", "axis outside ZX in G70 to G76", "Talm 127", Manual},
       {Cause::TurningPlane, "121", "a turning cycle outside ZX", "Talm 121", Manual},
       {Cause::TurningAxis, "122", "axis outside ZX in a turning cycle", "Talm 122", Manual},
       {Cause::ProfileCode, "128", "a G code in G70 to G73", "Talm 128", Manual},
       {Cause::ProfileInMdi, "129", "G70 to G73 in MDI", "Talm 129", Manual},
       {Cause::ProfileMacro, "130", "a macro statement in G70 to G73", "Talm 130", Manual},
       {Cause::PqSame, "135", "P and Q of G70 to G73", "Talm 135", Manual},
       {Cause::ProfileTooLong, "137", "more than 100 blocks", "Talm 137", Manual},
       {Cause::ProfileStart, "139", "the start of G71 to G73 lies in the range of the cut",
        "Talm 139", Manual},
       {Cause::ProfilePockets, "140", "too many pockets in G71", "Talm 140", Manual},
       {Cause::PatternX, "141", "X escape against the allowance of G73", "Talm 141", Manual},
       {Cause::PatternZ, "142", "Z escape against the allowance of G73", "Talm 142", Manual},
       {Cause::PatternFirstBlock, "145", "the first block of G73", "Talm 145", Manual},
       {Cause::ProfileFirstX, "146", "no X in the first block of G71", "Talm 146", Manual},
       {Cause::ProfileFirstZ, "147", "no Z in the first block of G72", "Talm 147", Manual},
       {Cause::CycleEscape, "149", "escape of G71, G72 below 0", "Talm 149", Manual},
       {Cause::PatternPasses, "151", "passes of G73", "Talm 151", Manual},
       {Cause::GrooveQ, "153", "Q of G74", "Talm 153", Manual},
       {Cause::GrooveP, "155", "P of G75", "Talm 155", Manual},
       {Cause::GrooveRetract, "156", "R(e) of G74, G75 below 0", "Talm 156", Manual},
       {Cause::GrooveEscape, "157", "R(d) of G74, G75 below 0", "Talm 157", Manual},
       {Cause::GrooveStep, "158", "a step of G74, G75", "Talm 158", Manual},
       {Cause::GrooveAxis, "154", "G75 without X", "Talm 154", Manual},
       {Cause::ThreadRunOut, "039", "run-out of a thread along the long axis", "Talm 039", Manual},
       {Cause::ThreadTravel, "160", "no travel in X or Z of G76", "Talm 160", Manual},
       {Cause::ThreadPasses, "161", "passes of G76 outside 1 to 99", "Talm 161", Manual},
       {Cause::ThreadLeastCut, "164", "Q(dmin) of G76", "Talm 164", Manual},
       {Cause::ThreadAllowance, "165", "R(d) of G76", "Talm 165", Manual},
       {Cause::ThreadTaper, "166", "R and U of a taper thread of G76", "Talm 166", Manual},
       {Cause::ThreadHeightValue, "168", "height of the thread of G76", "Talm 168", Manual},
       {Cause::ThreadCut, "169", "Q of G76", "Talm 169", Manual},
       {Cause::ThreadSteep, "170", "taper of G76 over 45 degrees", "Talm 170", Manual},
       {Cause::ThreadHeight, "167", "no height of the thread", "Talm 167", Manual},
       {Cause::CycleRepeats, "181", "K outside 1 to 99", "Talm 181", Manual},
       {Cause::CompensationNoIntersection, "251", "no intersection", "Talm 251", Manual},
       {Cause::CompensationArc, "252", "start or end of the compensation in an arc", "Talm 252",
        Manual},
       {Cause::CompensationEndArc, "252", "start or end of the compensation in an arc", "Talm 252",
        Manual},
       {Cause::CompensationPlane, "253", "plane change in the compensation", "Talm 253", Manual},
       {Cause::CompensationArcStart, "254", "arc starts or ends on its centre", "Talm 254", Manual},
       {Cause::CompensationArcEnd, "254", "arc starts or ends on its centre", "Talm 254", Manual},
       {Cause::CompensationInterference, "256", "interference", "Talm 256", Manual},
       {Cause::CompensationArcTooSmall, "261", "inner arc smaller than the radius", "Talm 261",
        Manual},
       {Cause::CornerInRapid, "271", "chamfer in a block that takes none", "Talm 271", Manual},
       {Cause::CornerNextMove, "272", "the block behind the chamfer", "Talm 272", Manual},
       {Cause::CornerNoMove, "273", "no move behind the chamfer", "Talm 273", Manual},
       {Cause::CornerPlane, "274", "plane change behind the chamfer", "Talm 274", Manual},
       {Cause::CornerTooShort, "275", "the move is shorter than the chamfer", "Talm 275", Manual},
       {Cause::CornerFormat, "276", "C, R and A together", "Talm 276", Manual}});
}

void gsk_980tdi(Control& c) {
  lathe_rules(c);
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
  add_effect(c, "019", 0, "the run-out of G92 and G76, tenths of the lead", "TDipar 019", Manual,
             set_thread_chamfer);
  add_effect(c, "056", 0, "the retract of G74 and G75, mm", "TDi 23.5: parameter 056", Manual,
             set_groove_retract);
  add_effect(c, "057", 1, "the finishing passes of G76", "TDi 24.12: parameter 057", Manual,
             set_thread_passes);
  add_effect(c, "058", 0, "the angle of G76, degrees", "TDi 24.12: parameter 058", Manual,
             set_thread_angle);
  add_effect(c, "059", 0, "the least cut of G76, mm", "TDi 24.12: parameter 059", Manual,
             set_thread_least_cut);
  add_effect(c, "060", 0, "the finishing allowance of G76, mm", "TDi 24.12: parameter 060", Manual,
             set_thread_allowance);
  c.helix = {false, kKnown, Inferred};
  add_effect(c, "3402#0", 0,
             "at power-on 0 = G00, 1 = G01; FANUC's number stands for the control's own", kKnown,
             Inferred, set_power_on_line);
  add_effect(c, "3403#4", 1, "R too small: 0 = a half circle, 1 = alarm; FANUC's number",
             "TDi 4 note 3", Manual, set_small_radius);
  add_effect(c, "3403#5", 1, "an arc without R, I, K: 0 = a line, 1 = alarm; FANUC's number",
             "TDi 4 note 1", Manual, set_no_radius);
  add_effect(c, "3410", 0,
             "how far the radii of an arc may differ, mm; FANUC's number stands for 154", kKnown,
             Inferred, set_tolerance);
  add_effect(c, "001#7", 0, "G00 goes 0 = each axis at its own rate, 1 = on a straight line",
             "TDipar 001#7", Manual, set_straight_rapid);
  add_effect(c, "182#7", 0,
             "P and Q of cycles and of angles count 0 least increments, 1 mm, degrees",
             "TDipar 182#7", Manual, set_cycle_millimetres);
  add_effect(c, "172#2", 0, "forbidden is 0 = the inside, 1 = the outside of the area of G22",
             "TDi 31", Manual, set_stroke_outside);
  add_effect(c, "154", 0, "how far the radii of an arc may differ, mm, 0 = not checked",
             "TDipar 154", Manual, set_tolerance);
  add_effect(c, "030", 0, "the feed at power-on", "TDipar 030", Manual, set_power_on_feed);
  add_effect(c, "051", 0, "the depth of cut of G71 and G72, mm", "TDipar 051", Manual,
             set_rough_depth);
  add_effect(c, "052", 0, "the escape of G71 and G72, mm", "TDipar 052", Manual, set_rough_escape);
  add_effect(c, "003#4", 0, "a tool offset is 0 a shift of the coordinates, 1 a motion",
             "TDipar 003#4", Manual, set_tool_motion);
  add_effect(c, "002#5", 0, "around an acute corner 0 lines, 1 an arc", "TDipar 002#5", Manual,
             set_acute_corner);
  add_effect(c, "181#0", 0, "L is 0 the length of the chamfer, 1 its distance from the corner",
             "TDipar 181#0", Manual, set_chamfer_length);
}

void gsk_928(Control& c) {
  lathe_rules(c);
  c.machine = {MachineType::LatheA, "source 001, Fig. 3-1: U is a diameter increment",
               SourceDocument};
  c.power_on_per_minute = {true, "source 001: F80, F500", SourceDocument};
  c.g_meanings = {
      "22=not-computed 26=not-computed 27=not-computed 29=not-computed 33=not-computed "
      "80=not-computed",
      "general knowledge: G22 to G80 is a loop, G26, G27 and G29 return to points", Inferred};
  c.dwell_words = {"PXUD", "928Ti: G4 D1 is a second", Secondary};
  add_effect(c, "3402#0", 0,
             "at power-on 0 = G00, 1 = G01; FANUC's number stands for the control's own", kKnown,
             Inferred, set_power_on_line);
  add_effect(c, "3410", 0, "how far the radii of an arc may differ, mm, 0 = not checked", kKnown,
             Inferred, set_tolerance);
}

void gsk_980mdi(Control& c) {
  c.machine = {MachineType::Mill, "MDib", Manual};
  c.g_meanings = {"", kKnown, Inferred};
  c.unit_change = {UnitChange::Alone, "MDib 0038", Manual};
  c.home_needed = {true, "MDib 0166, 0069", Manual};
  c.refuses = {
      "one-shot-with-motion length-with-motion local-with-length machine-move-in-cycle "
      "plane-change-in-polar work-system-change-in-polar polar-centre tool-in-polar "
      "corner-in-polar cycle-plane-in-polar units-in-rotation mirror-in-offset "
      "codes-with-rotation mirror-in-rotation reference-return-in-mirror rotation-plane "
      "plane-change-in-mirror coordinate-setting-in-rotation work-system-in-rotation "
      "length-in-rotation data-in-rotation cycle-in-rotation rotation-plane-in-cycle "
      "pattern-without-cycle corner-at-offset-start corner-in-helix corner-with-call "
      "cycle-repeats-twice "
      "tap-without-lead tap-without-speed g10-axis-missing scale-negative no-spindle-speed "
      "helix-without-travel helix-axis measuring-zone move-before-rigid-tap g11-before-g10",
      "MDib 0013, 0014, 0022, 0029, 0032, 0039, 0042, 0046, 0140, 0149 to 0165, 0176 to 0188, "
      "0204, "
      "0216, "
      "0218, 0230, "
      "0243, 0247, "
      "0278",
      Manual};
  c.set_coordinate_without_tool = {false, kKnown, Inferred};
  c.max_offset_number = {32, "MDib 0016", Manual};
  c.jumps_in_compensation = {false, "MDib 0099, 0100", Manual};
  c.max_rotation = {360, "MDib 0156", Manual};
  c.idle_blocks_alarm = {true, "MDib 0263", Manual};
  c.idle_blocks = {10, kKnown, Inferred};
  c.cycle_repeats = {"LK", "MDib 0203, 0204", Manual};
  c.zero_cycle_repeats = {ZeroCycleRepeats::Alarm, "MDib 0203", Manual};
  c.arc_centre_needed = {true, "MDib 0021", Manual};
  c.no_radius = {NoRadius::Alarm, "MDib 0021", Manual};
  c.chamfer_words = {",C L", "MDib 0039", Manual};
  c.round_words = {",R U", "MDib 0039", Manual};
  c.chamfer_length = {ChamferLength::Corner, kKnown, Inferred};
  c.helix = {true, "MDib 0032", Manual};
  c.measuring = {Measuring::Of5040, "MDipar 5040, 5043, 5044; TDi 17: the moves", Secondary};
  for (const auto& [name, meaning] :
       {std::pair{"5040", "the measuring feed of G37, mm/min"},
        {"5043", "G37: how far before the point the measuring feed begins, mm"},
        {"5044", "G37: within what distance of the point the tool arrives, mm"}})
    c.parameters.push_back({name, 0, meaning, "MDipar 5040, 5043, 5044", Manual, nullptr});
  c.skip_signals = {SkipSignals::Numbered, "MDipar 5431 to 5434: P1 to P4 have one each", Manual};
  c.max_skip_signals = {4, "MDipar 5431 to 5434", Manual};
  c.groove_p_diameter = {false, kKnown, Inferred};
  add_effect(c, "027", 0, "the largest cutting feed, mm/min, 0 = any", "MDib 0023", Manual,
             set_max_feed);
  add_effect(c, "3402#0", 0,
             "at power-on 0 = G00, 1 = G01; FANUC's number stands for the control's own", kKnown,
             Inferred, set_power_on_line);
  add_effect(c, "3410", 0, "how far the radii of an arc may differ, mm, 0 = not checked",
             "MDib 0018", Manual, set_tolerance);
  add_effect(c, "5114", 0, "the retract of G73, mm; FANUC's number stands for the control's own",
             kKnown, Inferred, set_peck_retract);
  add_effect(c, "5115", 0, "the clearance of G83, mm; FANUC's number stands for the control's own",
             kKnown, Inferred, set_peck_clearance);
  AlarmEntry& travel = c.alarms[Cause::OverTravel];
  travel = {"", "", "MDia 3011 to 3020", Manual};
  int number = 3011;
  for (const char* direction : {"+", "-"})
    for (const char* axis : {"X", "Y", "Z", "A", "B"})  // the fourth is A, the fifth B [inferred]
      travel.directed.push_back(
          {std::string(axis) + direction, std::to_string(number++), "software travel limit"});
  add_alarms(
      c,
      {{Cause::ArcAxis, "0008", "axis outside the plane of the arc", "MDib 0008", Manual},
       {Cause::OneShotWithMotion, "0014", "codes of groups 00 and 01 in one block", "MDib 0014",
        Manual},
       {Cause::OffsetNumber, "0016", "H outside 0 to 32", "MDib 0016", Manual},
       {Cause::RadiusTolerance, "0018", "the radii of an arc differ", "MDib 0018", Manual},
       {Cause::RadiusTooSmall, "0018", "the radii of an arc differ", "MDib 0018", Manual},
       {Cause::RadiusOffsetNumber, "0020", "D outside its range", "MDib 0020", Manual},
       {Cause::NoRadius, "0021", "I, J, K of G02, G03", "MDib 0021", Manual},
       {Cause::NoFeed, "0023", "F wrong or over 027", "MDib 0023", Manual},
       {Cause::FeedOutOfRange, "0023", "F wrong or over 027", "MDib 0023", Manual},
       {Cause::CompensationPlane, "0030", "plane change in the compensation", "MDib 0030", Manual},
       {Cause::CornerPlane, "0031", "plane change behind a chamfer", "MDib 0031", Manual},
       {Cause::CompensationSkip, "0035", "G31 in the compensation", "MDib 0035", Manual},
       {Cause::MeasuringMissed, "3050", "G37: no signal in the measuring zone", "MDia 3050",
        Manual},
       {Cause::MeasuringEarly, "3051", "signal before the measuring zone", "MDia 3051", Manual},
       {Cause::MeasuringOffset, "3052", "G37 with the offset number 0", "MDia 3052", Manual},
       {Cause::MeasuringZone, "0282", "G37: 5043 is not above 5044", "MDib 0282", Manual},
       {Cause::MeasuringWithOffset, "0297", "G37 with H in one block", "MDib 0297", Manual},
       {Cause::MeasuringIncremental, "0298", "G37 in increments", "MDib 0298", Manual},
       {Cause::MeasuringAxis, "0299", "G37 with another axis than Z, or in another plane",
        "MDib 0299", Manual},
       {Cause::CornerNoMove, "0036", "the block behind a chamfer", "MDib 0036", Manual},
       {Cause::CornerNextMove, "0036", "the block behind a chamfer", "MDib 0036", Manual},
       {Cause::UnitChangeLate, "0038", "G20, G21 not alone at the head", "MDib 0038", Manual},
       {Cause::LengthWithMotion, "0042", "length offset with G02 G03 G04 G31 G92", "MDib 0042",
        Manual},
       {Cause::NoIntermediate, "0068", "G29 without G28", "MDib 0068", Manual},
       {Cause::ReferenceNotHomed, "0069", "G30 before the machine zero is known", "MDib 0069",
        Manual},
       {Cause::CornerFormat, "0093", "chamfer words combined", "MDib 0093", Manual},
       {Cause::CornerWithCall, "0093", "M98 with a chamfer", "MDib 0093", Manual},
       {Cause::ReturnInCompensation, "0099", "a jump in the compensation", "MDib 0099", Manual},
       {Cause::JumpInCompensation, "0100", "a jump in the compensation", "MDib 0100", Manual},
       {Cause::ReferenceInRotation, "0152", "G28 to G30 in rotation or mirror", "MDib 0152",
        Manual},
       {Cause::RotationPlane, "0154", "plane change in rotation", "MDib 0154", Manual},
       {Cause::TurnedInCompensation, "0155", "rotation or mirror in the compensation", "MDib 0155",
        Manual},
       {Cause::RotationAngle, "0156", "angle over 360", "MDib 0156", Manual},
       {Cause::ScaleZero, "0158", "scale 0", "MDib 0158", Manual},
       {Cause::MachineMoveInCycle, "0165", "G53 in a fixed cycle", "MDib 0165", Manual},
       {Cause::NotHomed, "0166", "G53 before the machine zero is known", "MDib 0166", Manual},
       {Cause::PolarCentre, "0176", "I, J, K in polar coordinates", "MDib 0176", Manual},
       {Cause::PolarPlane, "0186", "plane change in polar coordinates", "MDib 0186", Manual},
       {Cause::PolarWorkSystem, "0187", "G54 to G59 in polar coordinates", "MDib 0187", Manual},
       {Cause::CycleRepeats, "0203", "repeat count 0", "MDib 0203", Manual},
       {Cause::G10P, "0238", "P of G10", "MDib 0238", Manual},
       {Cause::G10System, "0239", "P of G10 L20 outside 1 to 48", "MDib 0239", Manual},
       {Cause::WorkSystem, "0240", "P of G54.1 outside 1 to 48", "MDib 0240", Manual},
       {Cause::G10Offset, "0242", "P of an offset outside 1 to 32", "MDib 0242", Manual},
       {Cause::TurnedData, "0243", "G10 of a work system in rotation", "MDib 0243", Manual},
       {Cause::G10Word, "0246", "P or L of G10 missing", "MDib 0246", Manual},
       {Cause::G10Axis, "0247", "axis of G10 missing", "MDib 0247", Manual},
       {Cause::G10Value, "0248", "R of G10 missing", "MDib 0248", Manual},
       {Cause::HelixAxis, "0022", "axes beyond X, Y, Z in a helix", "MDib 0022", Manual},
       {Cause::HelixTravel, "0032", "a helix without travel in its plane", "MDib 0032", Manual},
       {Cause::CornerOffset, "0039", "a chamfer at the start of compensation", "MDib 0039", Manual},
       {Cause::LocalWithLength, "0046", "G52 with a length offset", "MDib 0046", Manual},
       {Cause::ScaleNegative, "0140", "P of scaling negative", "MDib 0140", Manual},
       {Cause::TurnedLength, "0149", "H in mirror, scaling, rotation", "MDib 0149", Manual},
       {Cause::TurnedWithCodes, "0150", "other codes in the block of mirror, scaling, rotation",
        "MDib 0150", Manual},
       {Cause::TurnedCoordinate, "0151", "G92 in mirror, scaling, rotation", "MDib 0151", Manual},
       {Cause::TurnedWorkSystem, "0153", "G52 to G59 in mirror, scaling, rotation", "MDib 0153",
        Manual},
       {Cause::TurnedPlane, "0154", "plane change in mirror, scaling", "MDib 0154", Manual},
       {Cause::TurnedMirror, "0159", "mirror in scaling or rotation", "MDib 0159", Manual},
       {Cause::RotatedCycle, "0160", "rotation in a cycle outside G17", "MDib 0160", Manual},
       {Cause::TurnedUnits, "0161", "G20, G21 in polar, mirror, rotation, scaling", "MDib 0161",
        Manual},
       {Cause::TurnedCycle, "0162", "G110 to G144 in mirror, scaling, rotation", "MDib 0162",
        Manual},
       {Cause::PolarCycle, "0163", "G16 with a cycle outside G17", "MDib 0163", Manual},
       {Cause::PolarCorner, "0185", "a chamfer in polar coordinates", "MDib 0185", Manual},
       {Cause::PolarTool, "0188", "a tool change in polar coordinates", "MDib 0188", Manual},
       {Cause::CycleRepeatsTwice, "0204", "L and K in a cycle", "MDib 0204", Manual},
       {Cause::PatternWithoutCycle, "0216", "G140 to G144 without a drilling code", "MDib 0216",
        Manual},
       {Cause::TapLead, "0218", "no pitch in G74, G84", "MDib 0218", Manual},
       {Cause::NoSpeed, "0013", "no S with G95", "MDib 0013", Manual},
       {Cause::RigidMove, "0232", "a move between M29 and G74, G84", "MDib 0232", Manual},
       {Cause::DataEndFirst, "0029", "G11 before G10", "MDib 0029", Manual},
       {Cause::TapSpeed, "0230", "S is 0", "MDib 0230", Manual},
       {Cause::CornerHelix, "0278", "a chamfer in a helix", "MDib 0278", Manual},
       {Cause::G10L, "0244", "L of G10", "MDib 0244", Manual},
       {Cause::CompensationArcStart, "0254", "an arc starts on its centre", "MDib 0254", Manual},
       {Cause::CompensationArcEnd, "0255", "an arc ends on its centre", "MDib 0255", Manual},
       {Cause::CompensationArcTooSmall, "0256", "inner arc smaller than the radius", "MDib 0256",
        Manual},
       {Cause::CompensationNoIntersection, "0257", "no intersection", "MDib 0257", Manual},
       {Cause::CompensationArc, "0258", "start of the compensation in an arc", "MDib 0258", Manual},
       {Cause::CompensationEndArc, "0259", "end of the compensation in an arc", "MDib 0259",
        Manual},
       {Cause::CompensationInterference, "0260", "interference", "MDib 0260", Manual},
       {Cause::CompensationIdle, "0263", "too many blocks without a move", "MDib 0263", Manual},
       {Cause::CornerTooShort, "0271", "the move is shorter than the chamfer", "MDib 0271",
        Manual}});
}

void gsk_988ta(Control& c) { gsk_988(c, 100); }
void gsk_988t(Control& c) {
  gsk_988(c, 0);
  c.max_pockets = {10, "Talm 140", Manual};
  // The papers of the 988TA say that such a block is not done, or takes the sign. [TA 12, 13]
  c.refuses = {c.refuses.value + " groove-axis groove-escape", c.refuses.source + ", 154, 157",
               Manual};
}

void fanuc_16i(Control& c) {
  fanuc_rules(c);
  c.negative_radius_on_lathes = {false, "16TC p.67", Manual};
}

void fanuc_0i(Control& c) {
  fanuc_rules(c);
  c.parameters_by_l52 = {true, kKnown, Inferred};
}

void fanuc_30i(Control& c) {
  fanuc_0i(c);
  c.idle_blocks = {3, "30iM p.166, 15iM p.419", Manual};
  add_effect(c, "19607#2", 0, "around an acute corner 0 lines, 1 an arc", kKnown, Inferred,
             set_acute_corner);
}

void mitsubishi(Control& c) {
  mitsubishi_rules(c);
  mitsubishi_alarms(c);
}

/// Gives each control of a maker its facts, both in listing order.
void give(std::vector<Control>& controls, const std::vector<void (*)(Control&)>& facts) {
  for (std::size_t i = 0; i < controls.size(); ++i) facts.at(i)(controls[i]);
}

}  // namespace

void add_gsk_motion(std::vector<Control>& controls) {
  give(controls, {gsk_988ta, gsk_988t, gsk_980tdi, gsk_980mdi, gsk_928});
}

void add_mitsubishi_motion(std::vector<Control>& controls) {
  give(controls, {mitsubishi, mitsubishi, mitsubishi});
}

void add_fanuc_motion(std::vector<Control>& controls) {
  give(controls, {fanuc_16i, fanuc_0i, fanuc_0i, fanuc_30i});
}

void add_hnc_motion(std::vector<Control>& controls) { give(controls, {hnc_rules}); }

}  // namespace cncsub
