// What the settings of controls do: a parameter's value becomes rules.
#pragma once

#include <initializer_list>

#include "cncsub/control.hpp"

namespace cncsub {

/// Adds a parameter and lets it have its effect on the rules: what its value sets comes from it.
void add_parameter(Control& c, const Parameter& parameter);
void add_parameters(Control& c, std::initializer_list<Parameter> parameters);

void set_tolerance(Control& c, double v);
void set_power_on_line(Control& c, double v);
void set_power_on_incremental(Control& c, double v);
void set_power_on_per_minute(Control& c, double v);
void set_power_on_feed(Control& c, double v);
void set_clear_on_reset(Control& c, double v);
void set_no_radius(Control& c, double v);
void set_small_radius(Control& c, double v);
void set_start_up(Control& c, double v);
void set_plain_corners(Control& c, double v);
void set_longer_by_h(Control& c, double v);
void set_straight_rapid(Control& c, double v);
void set_stroke_off(Control& c, double v);
void set_stroke_outside(Control& c, double v);
void set_type_by_shape(Control& c, double v);
void set_pocket_pass(Control& c, double v);
void set_dwell_point(Control& c, double v);
void set_overrun(Control& c, double v);
void set_peck_retract(Control& c, double v);
void set_peck_clearance(Control& c, double v);
void set_rough_depth(Control& c, double v);
void set_rough_escape(Control& c, double v);
void set_thread_chamfer(Control& c, double v);
void set_thread_passes(Control& c, double v);
void set_thread_angle(Control& c, double v);
void set_thread_least_cut(Control& c, double v);
void set_thread_allowance(Control& c, double v);
void set_groove_retract(Control& c, double v);
void set_one_block_cycles(Control& c, double v);
void set_monotone(Control& c, double v);
void set_full_retract(Control& c, double v);
void set_bore_return(Control& c, double v);
void set_max_feed(Control& c, double v);
void set_acute_corner(Control& c, double v);
void set_reset_local(Control& c, double v);
void set_machine_system(Control& c, double v);
void set_coordinate_refused(Control& c, double v);
void set_offset_digits(Control& c, double v);
void set_length_named(Control& c, double v);
void set_length_normal(Control& c, double v);
void set_tool_motion(Control& c, double v);
void set_cycle_increments(Control& c, double v);
void set_cycle_millimetres(Control& c, double v);
void set_chamfer_length(Control& c, double v);
void set_tool_with_setting(Control& c, double v);
void set_measuring_subtracts(Control& c, double v);

/// G36 and G37 of FANUC and of the GSK 988.
void measuring_parameters(Control& c, const char* source, Evidence evidence);

}  // namespace cncsub
