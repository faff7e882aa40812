#include "cncsub/dialect/grblhal/built_in.hpp"

#include <algorithm>

namespace cncsub::grblhal {

namespace {

using namespace built_in;

// G98 is _retract_r_plane, and G99 is _retract_old_z: the other way round than their names say.
// [gHp, ngc_named_param_get_by_id]
constexpr BuiltIn kBuiltIns[] = {
    {"_a", {number(0)}},
    {"_abs_a", {number(0)}},
    {"_abs_b", {number(0)}},
    {"_abs_c", {number(0)}},
    {"_abs_u", {number(0)}},
    {"_abs_v", {number(0)}},
    {"_abs_w", {number(0)}},
    {"_abs_x", {machine(0)}},
    {"_abs_y", {machine(1)}},
    {"_abs_z", {machine(2)}},
    {"_absolute", {modal(3), number(90), equal()}},
    {"_adaptive_feed", {number(0)}},
    {"_b", {number(0)}},
    {"_c", {number(0)}},
    {"_call_level", {Step{Ins::Level, 0}}},
    {"_ccomp", {number(400)}},
    {"_coord_system", {modal(14), number(10), times()}},
    {"_feed", {word('F')}},
    {"_ijk_absolute_mode", {number(0)}},
    {"_imperial", {modal(6), number(20), equal()}},
    {"_incremental", {modal(3), number(91), equal()}},
    {"_inverse_time", {modal(5), number(93), equal()}},
    {"_lathe_diameter_mode", {number(0)}},
    {"_lathe_radius_mode", {number(1)}},
    {"_metric", {modal(6), number(21), equal()}},
    {"_plane", {modal(2), number(10), times()}},
    {"_retract_old_z", {modal(10), number(99), equal()}},
    {"_retract_r_plane", {modal(10), number(98), equal()}},
    {"_rpm", {word('S')}},
    {"_spindle_css_mode", {number(0)}},
    {"_spindle_rpm_mode", {number(1)}},
    {"_u", {number(0)}},
    {"_units_per_minute", {modal(5), number(94), equal()}},
    {"_units_per_rev", {modal(5), number(95), equal()}},
    {"_v", {number(0)}},
    {"_vmajor", {number(static_cast<double>(1.1F))}},
    {"_w", {number(0)}},
    {"_x", {work(0)}},
    {"_y", {work(1)}},
    {"_z", {work(2)}},
};

constexpr std::string_view kOfMachine[] = {"_active_probe",
                                           "_current_pocket",
                                           "_current_tool",
                                           "_feed_hold",
                                           "_feed_override",
                                           "_flood",
                                           "_free_memory",
                                           "_homed_axes",
                                           "_homed_state",
                                           "_line",
                                           "_mist",
                                           "_motion_mode",
                                           "_probe2_state",
                                           "_probe_state",
                                           "_selected_pocket",
                                           "_selected_tool",
                                           "_speed_override",
                                           "_spindle_cw",
                                           "_spindle_on",
                                           "_tool_offset",
                                           "_tool_table_size",
                                           "_toolsetter_state",
                                           "_vminor"};

}  // namespace

std::span<const BuiltIn> built_ins() { return kBuiltIns; }
std::span<const std::string_view> names_of_machine() { return kOfMachine; }

bool tells_of_machine(std::string_view name) {
  return std::find(std::begin(kOfMachine), std::end(kOfMachine), name) != std::end(kOfMachine);
}

const BuiltIn* find_built_in(std::string_view name) {
  return cncsub::find_built_in(kBuiltIns, name);
}

}  // namespace cncsub::grblhal
