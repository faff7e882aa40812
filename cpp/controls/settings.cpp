#include "controls/settings.hpp"

#include <algorithm>

#include "cncsub/number.hpp"

namespace cncsub {
namespace {

int whole(double v) { return to_whole<int>(v, -2'000'000'000, 2'000'000'000); }
int micrometres(double millimetres) { return whole(millimetres * 1000 + 0.5); }

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

}  // namespace

void add_parameter(Control& c, const Parameter& parameter) {
  c.parameters.push_back(parameter);
  if (parameter.effect == nullptr) return;
  const Answers before(c);
  parameter.effect(c, parameter.value);
  follow(c, before, "parameter " + parameter.name + " as delivered: " + parameter.source,
         parameter.evidence);
}

void add_parameters(Control& c, std::initializer_list<Parameter> parameters) {
  for (const Parameter& parameter : parameters) add_parameter(c, parameter);
}

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
void set_tool_with_setting(Control& c, double v) { set_refused(c, "tool-with-setting", v != 0); }
void set_measuring_subtracts(Control& c, double v) { c.measuring_subtracts.value = v != 0; }

void measuring_parameters(Control& c, const char* source, Evidence evidence) {
  const auto add = [&](const char* name, const char* meaning) {
    c.parameters.push_back({name, 0, meaning, source, evidence, nullptr});
  };
  add("6241", "the measuring feed of G36 and G37, mm/min");
  add("6251", "G36, and G37 of a mill: how far before the point the measuring feed begins, mm");
  add("6252", "G37 of a lathe: how far before the point the measuring feed begins, mm");
  add("6254", "G36, and G37 of a mill: within what distance of the point the tool arrives, mm");
  add("6255", "G37 of a lathe: within what distance of the point the tool arrives, mm");
  add_parameter(c, {"6210#6", 0, "what G36 and G37 measure is 0 added to the offset, 1 subtracted",
                    source, evidence, set_measuring_subtracts});
}

}  // namespace cncsub
