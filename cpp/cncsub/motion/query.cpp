// The values of the motion that system variables and reports read.
#include "cncsub/motion/query.hpp"

#include <cstdio>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", value);
  return text;
}

}  // namespace

int axis_number(MotionView m, int axis) {
  const std::string& order = m.facts.axis_order;
  if (axis < 0 || axis >= static_cast<int>(order.size())) return -1;
  return axis_of(order[static_cast<std::size_t>(axis)]);
}

static double shown(MotionView m, int axis, const Axes& values) {
  const int i = axis_number(m, axis);
  if (i < 0) return 0;
  return is_rotary(i) || !g20(m.state) ? values[static_cast<std::size_t>(i)]
                                       : values[static_cast<std::size_t>(i)] / kInch;
}

double modal_code(MotionView m, int group) {
  if (group == m.facts.group_numbers[at(Group::Motion)] && m.facts.refuses(Cause::NoMotionCode)) {
    const GCode& cycle = m.state.modal[at(Group::Cycle)];
    if (in_cycle(m.state) || m.state.no_motion) return cycle.code / 10.0;
  }
  for (std::size_t g = 0; g < kGroups; ++g)
    if (m.facts.group_numbers[g] == group && group > 0 && m.state.modal[g].code >= 0)
      return m.state.modal[g].code / 10.0;
  return kVacant;
}

double modal_word(MotionView m, char address) {
  switch (address) {
    case 'B':
      return m.state.b;
    case 'D':
      return m.state.d;
    case 'F':
      return m.state.modal[at(Group::Feed)].meaning == Meaning::InverseTime
                 ? m.state.feed
                 : m.state.feed / m.state.feed_unit;
    case 'H':
      return m.state.h;
    case 'P':
      return m.state.work_system == 0 ? m.state.extra_system : 0;
    case 'S':
      return m.state.surface ? m.state.surface_speed : m.state.speed;
    case 'T':
      return m.state.t;
    default:
      return kVacant;
  }
}

double block_end(MotionView m, int axis) {
  return shown(m, axis, as_programmed(m.state, m.state.work));
}

/// Return the end of the last move that waits for the corner after it.
static Axes waiting_end(const LookaheadQueue& lookahead) {
  const Piece& last = lookahead.radius.back();
  Axes end = last.end + last.length;
  const PlaneAxes plane = plane_axes(last.plane);
  end[static_cast<std::size_t>(plane.a)] += lookahead.vector[0];
  end[static_cast<std::size_t>(plane.b)] += lookahead.vector[1];
  return end;
}

/// Return where the tool counts as standing. Where a move waits by its own normal, that is its end.
/// After the G40 of a control whose moves end on their own normals, it is the programmed point
/// again. [rs274 2.9]
static Axes standing_point(MotionView m) {
  const MotionState& state = m.state;
  const bool by_normal = is_by_own_normal(m.facts);
  if (by_normal && !state.lookahead.radius.empty()) return waiting_end(state.lookahead);
  return state.plain || state.lookahead.ended || (by_normal && !state.lookahead.engaged)
             ? machine_point(state)
             : state.tool_at;
}

double machine_position(MotionView m, int axis) {
  return shown(m, axis, in_machine(m.state, standing_point(m)));
}

/// Return the tool length where it shifts the work coordinates: these are those of the tool's
/// point.
static Axes shifting_length(MotionView m) {
  return m.facts.control->motion.length_type.value == LengthType::Shift ? m.state.length : Axes{};
}

double work_position(MotionView m, int axis) {
  return shown(m, axis,
               as_programmed(m.state, standing_point(m) - m.state.offset - shifting_length(m)));
}

double skip_position(MotionView m, int axis) { return shown(m, axis, m.state.skip); }

double measured_position(MotionView m, int axis) { return shown(m, axis, m.state.measured); }

double measured_machine(MotionView m, int axis) { return shown(m, axis, m.state.measured_machine); }

double active_length(MotionView m, int axis) {
  return shown(m, axis, in_machine(m.state, m.state.length + m.state.tool_shift));
}

double edge_datum(MotionView m, std::int32_t number) { return datum_of_edge(m, number); }

double tool_length(MotionView m, int axis) {
  return shown(m, axis, length_of_tool(m.state, m.state.tool));
}

double work_offset(MotionView m, int system, int axis) {
  if (system < 0 || system > m.state.tables.last_system()) return 0;
  if (axis == kTurn) return turn_of_system(m.state, system);
  return shown(m, axis, m.state.tables.zero(system));
}

double kept_shift(MotionView m, int axis) {
  return axis < 0 ? m.state.shifted : shown(m, axis, m.state.kept_shift);
}

double reference_point(MotionView m, int number, int axis) {
  return shown(m, axis, m.state.tables.point(number));
}

double offset(MotionView m, VariableKind kind, int number) {
  const auto* table = m.state.tables.of(kind);
  if (table == nullptr || number < 0 || number >= static_cast<int>((*table)->size())) return 0;
  return (**table)[static_cast<std::size_t>(number)] / (g20(m.state) ? kInch : 1);
}

double scaled(MotionView m, char address, double value) {
  if (m.facts.control->reading.whole_numbers.value != WholeNumbers::Increments) return value;
  if (address == 'F') return value * feed_increment(m.state) * 1;
  if (address >= 'A' && address <= 'C') return value / (1 / m.facts.increment);
  constexpr std::string_view kLengths = "IJKQRUVWXYZ";
  if (kLengths.find(address) == std::string_view::npos) return value;
  return value / (1 / (m.facts.increment * (g20(m.state) ? 0.1 : 1)));
}

double increment(MotionView m, char address, const BlockCodes* of_block) {
  const bool changes = of_block != nullptr && of_block->has(Group::Units);
  const bool inches = changes ? of_block->meaning(Group::Units) == Meaning::Inch : g20(m.state);
  if (address == 'H') return m.facts.machine == MachineType::LatheA ? m.facts.increment : 0;
  constexpr std::string_view kLengths = "ABCIJKQRUVWXYZ";
  if (kLengths.find(address) == std::string_view::npos) return 0;
  return m.facts.increment * (inches && address > 'C' ? 0.1 : 1);
}

/// Return the values of the axes that there are.
static std::vector<std::pair<std::string, double>> by_axis(MotionView m, const Axes& values) {
  std::vector<std::pair<std::string, double>> list;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const bool always = i < 3 && (i != 1 || !m.facts.lathe());
    if (always || m.state.work[i] != 0 || (m.state.named >> i & 1) != 0)
      list.emplace_back(std::string(1, kAxisNames[i]), values[i]);
  }
  return list;
}

std::vector<std::pair<std::string, double>> position(MotionView m) {
  return by_axis(m, m.state.work);
}

std::vector<std::pair<std::string, double>> position_in_machine(MotionView m) {
  return by_axis(m, in_machine(m.state, standing_point(m)));
}

static constexpr std::pair<std::string_view, Group> kNames[] = {
    {"motion", Group::Motion},   {"plane", Group::Plane},       {"distance", Group::Distance},
    {"feed_mode", Group::Feed},  {"units", Group::Units},       {"radius", Group::Radius},
    {"length", Group::Length},   {"cycle", Group::Cycle},       {"return", Group::Return},
    {"scaling", Group::Scaling}, {"surface", Group::Surface},   {"work", Group::Work},
    {"path", Group::Path},       {"rotation", Group::Rotation}, {"polar", Group::Polar},
    {"mirror", Group::Mirror},   {"stroke", Group::Stroke}};

std::optional<Group> group_named(std::string_view name) {
  for (const auto& [known, group] : kNames)
    if (known == name) return group;
  return std::nullopt;
}

static constexpr std::string_view kWordModes = "FSTHD";

std::vector<std::string> mode_names() {
  std::vector<std::string> names;
  for (const auto& [name, group] : kNames) names.emplace_back(name);
  for (const char word : kWordModes) names.emplace_back(1, word);
  return names;
}

std::vector<std::pair<std::string, std::string>> modal(MotionView m) {
  std::vector<std::pair<std::string, std::string>> list;
  for (const auto& [name, group] : kNames) {
    const int code = m.state.modal[at(group)].code;
    if (code < 0) continue;
    std::string text = code_name(code);
    if (group == Group::Work && m.state.work_system == 0 && m.state.modal[at(group)].variant == 0)
      text += " P" + std::to_string(m.state.extra_system);
    list.emplace_back(name, text);
  }
  for (const char word : kWordModes)
    list.emplace_back(std::string(1, word), number_text(modal_word(m, word)));
  return list;
}

Workpiece placed(MotionView m, Workpiece workpiece) {
  Axes zero{};
  if (const int system = system_of(workpiece.system); system > 0)
    zero = m.state.tables.zero(0) + m.state.tables.zero(system);
  for (Solid& solid : workpiece.solids)
    for (std::size_t i = 0; i < 3; ++i) {
      const double share = m.facts.share(static_cast<int>(i));
      for (Point3* point : {&solid.at, &solid.low, &solid.high})
        (*point)[i] = ((*point)[i] + zero[i]) * share;
    }
  open_holes(workpiece.solids);
  return workpiece;
}

}  // namespace cncsub
