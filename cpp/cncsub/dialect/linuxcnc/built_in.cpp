#include "cncsub/dialect/linuxcnc/built_in.hpp"

#include <algorithm>

namespace cncsub::linuxcnc {

namespace {

using namespace built_in;

constexpr std::array<BuiltIn, 41> kBuiltIns = {{
    {"_a", {work(3)}},
    {"_abs_a", {machine(3)}},
    {"_abs_b", {machine(4)}},
    {"_abs_c", {machine(5)}},
    {"_abs_x", {machine(0)}},
    {"_abs_y", {machine(1)}},
    {"_abs_z", {machine(2)}},
    {"_absolute", {modal(3), number(90), equal()}},
    {"_b", {work(4)}},
    {"_c", {work(5)}},
    {"_call_level", {Step{Ins::Level, 0}}},
    {"_ccomp", {modal(7), Step{Ins::Floor, 0}, number(10), times()}},  // G41.1 counts as G41
    {"_coord_system", {modal(14), number(10), times()}},
    {"_feed", {word('F')}},
    {"_ijk_absolute_mode", {modal(23), number(90.1), equal()}},
    {"_imperial", {modal(6), number(20), equal()}},
    {"_incremental", {modal(3), number(91), equal()}},
    {"_inverse_time", {modal(5), number(93), equal()}},
    {"_lathe_diameter_mode", {modal(24), number(7), equal()}},
    {"_lathe_radius_mode", {modal(24), number(8), equal()}},
    {"_line", {Step{Ins::LineNumber, 0}}},
    {"_metric", {modal(6), number(21), equal()}},
    {"_motion_mode", {modal(1), number(10), times()}},
    {"_plane", {modal(2), number(10), times()}},
    {"_remap_level", {number(0)}},
    {"_retract_old_z", {modal(10), number(98), equal()}},
    {"_retract_r_plane", {modal(10), number(99), equal()}},
    {"_rpm", {word('S')}},
    {"_selected_tool", {word('T')}},
    {"_spindle_css_mode", {modal(13), number(96), equal()}},
    {"_spindle_rpm_mode", {modal(13), number(97), equal()}},
    {"_task", {number(0)}},
    {"_units_per_minute", {modal(5), number(94), equal()}},
    {"_units_per_rev", {modal(5), number(95), equal()}},
    {"_value", {Step{Ins::Common, 0}}},
    {"_value_returned", {Step{Ins::Common, 1}}},
    {"_vmajor", {number(2.9)}},
    {"_vminor", {number(0)}},
    {"_x", {work(0)}},
    {"_y", {work(1)}},
    {"_z", {work(2)}},
}};

constexpr std::string_view kOfMachine[] = {"_abs_u",
                                           "_abs_v",
                                           "_abs_w",
                                           "_adaptive_feed",
                                           "_current_pocket",
                                           "_current_tool",
                                           "_feed_hold",
                                           "_feed_override",
                                           "_flood",
                                           "_metric_machine",
                                           "_mist",
                                           "_selected_pocket",
                                           "_speed_override",
                                           "_spindle_cw",
                                           "_spindle_on",
                                           "_tool_offset",
                                           "_u",
                                           "_v",
                                           "_w"};

}  // namespace

std::vector<std::string_view> names_of_built_ins() {
  std::vector<std::string_view> names;
  names.reserve(std::size(kBuiltIns));
  for (const BuiltIn& of : kBuiltIns) names.push_back(of.name);
  return names;
}

std::span<const std::string_view> names_of_machine() { return kOfMachine; }

bool tells_of_machine(std::string_view name) {
  return std::find(std::begin(kOfMachine), std::end(kOfMachine), name) != std::end(kOfMachine);
}

bool is_read_only(std::string_view name) {
  return find_built_in(name) != nullptr || tells_of_machine(name);
}

const BuiltIn* find_built_in(std::string_view name) {
  return cncsub::find_built_in(kBuiltIns, name);
}

}  // namespace cncsub::linuxcnc
