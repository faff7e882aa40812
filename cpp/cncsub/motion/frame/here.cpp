// G10 by where the tool stands: work systems that may be rotated, and the lengths of tools.
#include <algorithm>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

double radians_of(const MotionState& state, int system) {
  return turn_of_system(state, system) * kPi / 180;
}

/// Return a machine point in the coordinates of a work system, without the shift.
Axes in_system(const MotionState& state, int system, const Axes& machine) {
  return turned_by(-radians_of(state, system), machine - state.tables.zero(system));
}

bool names_any(const BlockWords& block, std::string_view letters) {
  return std::any_of(letters.begin(), letters.end(),
                     [&](char letter) { return block.words.has(letter); });
}

/// Take over the words of axes, times the length of their unit.
Axes named(MotionView m, const BlockWords& block, Axes values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (const char name = kAxisNames[i]; block.words.has(name)) values[i] = number(m, block, name);
  return values;
}

/// Return the length with which the tool stands at the words, in the work system in force or in the
/// last one. An axis without a word keeps its part.
Axes length_by_words(MotionView m, const BlockWords& block, bool fixture, const Axes& before) {
  const MotionState& s = m.state;
  const int system = fixture ? s.tables.last_system() : system_in_force(s);
  Axes there = in_system(s, system, in_machine(s, machine_point(s)));
  if (!fixture) there = there - s.shift;
  const double turn = radians_of(s, system);
  Axes length = turned_by(-turn, before);
  const Axes words = named(m, block, {});
  for (std::size_t i = 0; i < length.size(); ++i)
    if (block.words.has(kAxisNames[i])) length[i] = there[i] - words[i];
  return turned_by(turn, length);
}

}  // namespace

Axes length_of_tool(const MotionState& state, int tool) {
  Axes length{};
  if (tool <= 0) return length;
  const OffsetTables& tables = state.tables;
  if (const auto found = tables.tool_axes->find(tool); found != tables.tool_axes->end())
    length = found->second;
  if (static_cast<std::size_t>(tool) < tables.length->size()) length[2] = tables.length_of(tool);
  return length;
}

Result set_system_here(MotionContext& m, const BlockWords& block, double p) {
  MotionState& s = m.state;
  const int active = system_in_force(s);
  if (p == 0) p = active;
  if (p < 1 || p != std::floor(p) || p > s.tables.last_system())
    return fault_at('P', Cause::G10P, block);
  const int system = whole(p);
  if (system == active && compensating(s)) return fault(Cause::CompensationShift, block);
  const double turn = radians_of(s, system);
  const Axes there = in_system(s, system, in_machine(s, s.work + s.offset)) - reported_shift(s);
  const Axes wanted = named(m, block, there);
  Axes& zero = s.tables.change_zero(system);
  zero = zero + turned_by(turn, there - wanted);
  if (system == active) s.zero_is_held = false;
  refresh_offset(s);
  return std::nullopt;
}

Result set_tool_entry(MotionContext& m, const BlockWords& block, int l, double p) {
  OffsetTables& tables = m.state.tables;
  if (p < 1 || p != std::floor(p) || p >= static_cast<double>(tables.length->size()))
    return fault_at('P', Cause::G10Offset, block);
  const bool fixture = l == 11;
  const int tool = whole(p);
  const auto place = static_cast<std::size_t>(tool);
  if (block.words.has('R')) tables.radius.change()[place] = number(m, block, 'R');
  if (!names_any(block, kAxisNames)) return std::nullopt;
  const Axes before = length_of_tool(m.state, tool);
  const Axes length = l == 1 ? named(m, block, before) : length_by_words(m, block, fixture, before);
  if (block.words.has('Z')) tables.length.change()[place] = length[2];
  Axes others = length;
  others[2] = 0;
  if (others != Axes{} || tables.tool_axes->contains(tool))
    tables.tool_axes.change()[tool] = others;
  return std::nullopt;
}

}  // namespace cncsub
