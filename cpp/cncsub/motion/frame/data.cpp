// G10: offsets and zero points that the program sets.
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

/// Add or store a value.
void put(double& place, double value, bool add) { place = add ? place + value : value; }

/// Execute G10 L10 to L13: H and D, geometry and wear.
Result set_offset_data(MotionContext& m, BlockWords& block, int l, double p) {
  if (p < 0 || p >= static_cast<double>(m.state.tables.length->size()))
    return fault_at('P', Cause::G10Offset, block);
  if (!block.words.has('R')) return fault(Cause::G10Value, block);
  OffsetTables& tables = m.state.tables;
  auto& table = l == 10   ? tables.length
                : l == 12 ? tables.radius
                : l == 13 ? tables.radius_wear
                          : tables.length_wear;
  put(table.change()[to_whole<std::size_t>(p)], number(m, block, 'R'), m.state.incremental);
  return std::nullopt;
}

/// Add U V W of a lathe to the values.
void add_increments(MotionView m, const BlockWords& block, Axes& values) {
  for (const auto& [letter, axis] : {std::pair{'U', 0}, {'V', 1}, {'W', 2}})
    if (block.words.has(letter)) values[static_cast<std::size_t>(axis)] += number(m, block, letter);
}

/// Execute G10 P X Z R Q of a lathe. P over 10000 names the geometry, P0 the work shift.
Result set_tool_data(MotionContext& m, BlockWords& block) {
  const NcWords& w = block.words;
  if (!w.has('P')) return fault(Cause::G10Word, block);
  const int p = whole(block.words['P']);
  const int tool = p % 10000;
  if (p < 0 || p >= 20000 || tool > m.facts.control->motion.max_offset_number.value)
    return fault_at('P', Cause::G10Offset, block);
  OffsetTables& tables = m.state.tables;
  ToolOffsets* const entry = p == 0 ? nullptr : &tables.change_tool(tool);
  Axes& values = p == 0 ? tables.change_zero(0) : entry->value;
  for (const auto& [name, axis] : {std::pair{'X', 0}, {'Y', 1}, {'Z', 2}})
    if (w.has(name))
      put(values[static_cast<std::size_t>(axis)], number(m, block, name), m.state.incremental);
  add_increments(m, block, values);
  if (entry != nullptr && w.has('R')) entry->radius = number(m, block, 'R');
  if (entry != nullptr && w.has('Q')) entry->tip = whole(block.words['Q']);
  refresh_offset(m.state);
  return std::nullopt;
}

/// Execute G10 without L: a tool of a lathe, or length and radius of a mill by P.
Result set_without_l(MotionContext& m, BlockWords& block) {
  if (m.facts.lathe()) return set_tool_data(m, block);
  if (!m.facts.control->motion.data_forms.value.has(DataForm::WithoutL) || !block.words.has('P'))
    return fault(Cause::G10Word, block);
  if (auto wrong = set_offset_data(m, block, 12, block.words['P'])) return wrong;
  return set_offset_data(m, block, 10, block.words['P']);
}

/// Find which system P names: of `extra` ones, or of G54 to G59 (0: the one before them all).
Result system_of(MotionView m, const BlockWords& block, bool& extra, double& p) {
  if (m.facts.control->motion.data_forms.value.has(DataForm::Active)) {
    if (p == 0) p = system_in_force(m.state);
    if (!extra && p > 6) extra = true, p -= 6;
  }
  const double last = extra ? static_cast<double>(m.state.tables.extra->size()) : 6;
  if (p >= (extra ? 1 : 0) && p <= last && p == std::floor(p)) return std::nullopt;
  if (extra) return fault_at('P', Cause::G10System, block);
  if (m.facts.control->motion.other_system.value != OtherSystem::First)
    return fault_at('P', Cause::G10P, block);
  p = 1;
  return std::nullopt;
}

/// Execute G10 L2 and L20: the zero point of a work system, or of an extra one.
Result set_zero_point(MotionContext& m, const BlockWords& block, bool extra, double p) {
  const bool in_force = m.facts.control->motion.data_forms.value.has(DataForm::Active);
  if (auto wrong = system_of(m, block, extra, p)) return wrong;
  const int system = whole(p) + (extra ? 6 : 0);
  const bool active = system == system_in_force(m.state);
  if (in_force && active && compensating(m.state)) return fault(Cause::CompensationShift, block);
  if (block.words.has('R') && in_force) m.state.tables.angles.change()[system] = block.words['R'];
  const bool named = std::any_of(kAxisNames.begin(), kAxisNames.end(),
                                 [&](char axis) { return block.words.has(axis); });
  if (!named && m.facts.refuses(Cause::G10Axis)) return fault(Cause::G10Axis, block);
  Axes& values = m.state.tables.change_zero(system);
  const bool lathe_a = m.facts.machine == MachineType::LatheA;
  for (std::size_t i = 0; i < (lathe_a ? 6 : values.size()); ++i)
    if (const char name = kAxisNames[i]; block.words.has(name))
      put(values[i], number(m, block, name), m.state.incremental && !in_force);
  if (lathe_a) add_increments(m, block, values);
  if (active) m.state.zero_is_held = false;
  refresh_offset(m.state);
  return std::nullopt;
}

}  // namespace

Result set_data(MotionContext& m, BlockWords& block) {
  m.state.data_set = true;
  const NcWords& w = block.words;
  if (!w.has('L')) return set_without_l(m, block);
  const int l = whole(counted(m, w, 'L'));
  const bool systems = l == 2 || l == 20, offsets = l == 1 || (l >= 10 && l <= 13);
  // No motion depends on tool life and parameters.
  const bool others =
      l == 3 || l == 50 || (l == 52 && m.facts.control->motion.data_forms.value.has(DataForm::L52));
  if (others) return std::nullopt;
  if (!systems && !offsets) return fault_at('L', Cause::G10L, block);
  if (!w.has('P') && l != 2) return fault(Cause::G10Word, block);
  // A computed P that misses a whole number by rounding alone is that number.
  const double written = w.has('P') ? w['P'] : m.state.work_system;
  const double p = (w.computed & bit('P')) != 0 ? nearly_whole(written).value_or(written) : written;
  if (m.facts.control->motion.data_forms.value.has(DataForm::Tools) && l != 2 && l != 20)
    return set_tool_entry(m, block, l, p);
  if (l == 20 && m.facts.control->motion.data_forms.value.has(DataForm::Here))
    return set_system_here(m, block, p);
  return offsets ? set_offset_data(m, block, l, p) : set_zero_point(m, block, l == 20, p);
}

}  // namespace cncsub
