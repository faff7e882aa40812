// The state before the first block: what the setup says, and the modes at power on.
#include "cncsub/motion/power_on.hpp"

#include <algorithm>

#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/fast_path.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

constexpr int kLargestOffset = 9999;  // no table of offsets is longer, whatever a rule says

void fill_table(std::vector<double>& table, const std::map<int, double>& values) {
  for (const auto& [number, value] : values) {
    if (number < 0 || number > kLargestOffset) continue;
    if (table.size() <= static_cast<std::size_t>(number))
      table.resize(static_cast<std::size_t>(number) + 1);
    table[static_cast<std::size_t>(number)] = value;
  }
}

ToolOffsets offsets_of(const Setup::Edge& edge) {
  ToolOffsets offsets;
  fill(offsets.value, edge.values);
  offsets.tip = edge.tip;
  offsets.radius = edge.radius;
  return offsets;
}

OffsetTables tables_of(const Setup& setup, const Control& control,
                       const std::map<int, Axes>& reference) {
  OffsetTables tables;
  const auto rows = [](std::int32_t most) {
    return static_cast<std::size_t>(std::min(most, kLargestOffset));
  };
  tables.extra.change().resize(rows(control.motion.max_extra_systems.value));
  for (const auto& [name, values] : setup.work_offsets)
    if (const int system = system_of(name); system >= 0 && system <= tables.last_system())
      fill(tables.change_zero(system), values);
  const auto numbers = rows(control.motion.max_offset_number.value) + 1;
  for (auto* table : {&tables.length, &tables.length_wear, &tables.radius, &tables.radius_wear})
    table->change().resize(numbers);
  fill_table(tables.length.change(), setup.length_offsets);
  fill_table(tables.radius.change(), setup.radius_offsets);
  tables.length_wear.change().resize(tables.length->size());
  tables.radius_wear.change().resize(tables.radius->size());
  for (const auto& [number, tool] : setup.tools) {
    if (number < 0 || number > kLargestOffset) continue;
    tables.change_tool(number) = offsets_of(tool);
    if (!tool.name.empty()) tables.name_tool(number, tool.name);
    for (const auto& [edge, offsets] : tool.edges)
      tables.edges.change().offsets[{number, edge}] = offsets_of(offsets);
  }
  tables.reference.change() = reference;
  return tables;
}

}  // namespace

MotionState state_of(const MotionFacts& facts, const Setup& setup) {
  MotionState state;
  state.tables = tables_of(setup, *facts.control, facts.reference);
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = facts.share(static_cast<int>(i)), rate = facts.rapid[i];
    state.rapid_seconds[i] = rate > 0 ? share * 60 / rate : 0;
  }
  state.x_share = facts.share(0) * facts.share(0);
  power_on(facts, state, false);
  state.offset = zero_offset(state);
  state.work = Axes{} - state.offset;
  fill(state.work, setup.start);
  for (const auto& [name, range] : setup.area)
    if (const int axis = axis_of(name); axis >= 0 && axis < 3) {
      state.area.low[static_cast<std::size_t>(axis)] = range.first;
      state.area.high[static_cast<std::size_t>(axis)] = range.second;
      state.area.known = true;
    }
  state.tool_at = machine_point(state);
  prepare_fast_path(facts, state);
  return state;
}

namespace {

/// Forget what a program sets: a motion code, the data of the multiple cycles.
void forget_program(const MotionFacts& facts, MotionState& state) {
  state.no_motion = facts.refuses(Cause::NoMotionCode);
  const auto& turning = facts.control->turning;
  MultipleData& data = state.multiple;
  data.finish_passes = turning.thread_passes.value;
  data.chamfer = turning.thread_chamfer.value;
  data.angle = turning.thread_angle.value;
  data.least_cut = turning.thread_least_cut.value * 1e-3;
  data.allowance = turning.thread_allowance.value * 1e-3;
  data.retract = turning.groove_retract.value * 1e-3;
}

Meaning plane_at_power_on(const MotionFacts& facts) {
  if (facts.lathe()) return Meaning::PlaneZX;
  const auto& codes = facts.control->common.power_on.value;
  return codes.has(PowerOn::G19)   ? Meaning::PlaneYZ
         : codes.has(PowerOn::G18) ? Meaning::PlaneZX
                                   : Meaning::PlaneXY;
}

/// The meanings in force on every control that is switched on.
constexpr Meaning kAlways[] = {Meaning::SpindleSpeed, Meaning::RadiusOff,  Meaning::LengthOff,
                               Meaning::CycleOff,     Meaning::ScalingOff, Meaning::MacroOff,
                               Meaning::Work1,        Meaning::PathCut,    Meaning::RotationOff,
                               Meaning::PolarOff,     Meaning::MirrorOff,  Meaning::CentreFromStart,
                               Meaning::DiameterOff};

}  // namespace

void power_on(const MotionFacts& facts, MotionState& state, bool reset) {
  const Control& c = *facts.control;
  const auto set = [&](Meaning meaning) {
    const GCode code = facts.codes.of(meaning);
    const bool kept = reset && (code.group == Group::Units || code.group == Group::Work);
    if (code.code >= 0 && !kept) state.modal[at(code.group)] = code;
  };
  const auto where = [&](PowerOn code, Meaning meaning, Meaning other) {
    return c.common.power_on.value.has(code) ? meaning : other;
  };
  const Meaning plane = plane_at_power_on(facts);
  const Meaning turning = where(PowerOn::G95, Meaning::PerRevolution, Meaning::PerMinute);
  for (const Meaning meaning : kAlways) set(meaning);
  for (const Meaning meaning :
       {where(PowerOn::G01, Meaning::Line, Meaning::Rapid), plane,
        where(PowerOn::G91, Meaning::Incremental, Meaning::Absolute),
        facts.lathe() ? turning : Meaning::PerMinute,
        where(PowerOn::G20, Meaning::Inch, Meaning::Metric),
        facts.lathe() ? Meaning::ReturnInitial
                      : where(PowerOn::G99, Meaning::ReturnR, Meaning::ReturnInitial),
        where(PowerOn::G22, Meaning::StrokeOn, Meaning::StrokeOff)})
    set(meaning);
  state.plane = plane_of(plane);
  state.incremental = state.modal[at(Group::Distance)].meaning == Meaning::Incremental;
  if (!reset) {
    state.feed = c.motion.power_on_feed.value;
    take_units(facts, state);
  }
  forget_program(facts, state);
}

}  // namespace cncsub
