// Canned cycles of mills: the levels of a hole, and the path to it.
#include <algorithm>

#include "cncsub/motion/cycle/cycles.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"

namespace cncsub {
namespace {

/// Move over the hole, then to R.
Result approach(MotionContext& m, BlockWords& block, int axis, double r) {
  const auto along = static_cast<std::size_t>(axis);
  auto [place, named] = target(m, block);
  place[along] = m.state.work[along];
  named &= ~axis_bit(axis);
  if (named != 0)
    if (auto wrong = move(m, block, MoveKind::Rapid, place, named)) return wrong;
  if (m.state.cycle.cycle == Meaning::BackBore) return std::nullopt;
  return move_axis(m, block, MoveKind::Rapid, axis, r);
}

/// Move up to R where the series began below it, then over the hole, and down to R. A tool above R
/// stays at its height; from R or below it goes over the hole at the height that the cycle returns
/// to. [rs274 2.9]
Result approach_above(MotionContext& m, BlockWords& block, int axis, double r, bool first) {
  const auto along = static_cast<std::size_t>(axis);
  const double initial = m.state.cycle.initial;
  auto [place, named] = target(m, block);
  if (first && initial < r)
    if (auto wrong = move_axis(m, block, MoveKind::Rapid, axis, r)) return wrong;
  named &= ~axis_bit(axis);
  const double clear = returns_to_r(m.state) ? r : std::max(initial, r);
  place[along] = m.state.work[along] > r + kStanding ? m.state.work[along] : clear;
  const bool stands = place == m.state.work && m.state.tool_at == machine_point(m.state);
  if (!stands || named != 0)
    if (auto wrong = move(m, block, MoveKind::Rapid, place, named | axis_bit(axis))) return wrong;
  return place[along] > r ? move_axis(m, block, MoveKind::Rapid, axis, r) : std::nullopt;
}

}  // namespace

bool goes_to_r_first(const MotionFacts& facts) {
  return facts.control->motion.cycle_approach.value == CycleApproach::RFirst;
}

bool returns_to_r(const MotionState& state) {
  return state.modal[at(Group::Return)].meaning == Meaning::ReturnR;
}

std::pair<double, double> hole_levels(MotionView m) {
  const CycleData& cycle = m.state.cycle;
  const bool by_block = goes_to_r_first(m.facts);
  const bool from_start = by_block ? m.state.incremental : cycle.r_incremental;
  const bool from_r = by_block ? m.state.incremental : cycle.z_incremental;
  const double r = !cycle.has_r ? cycle.initial : from_start ? cycle.initial + cycle.r : cycle.r;
  return {r, !cycle.has_z ? r : from_r ? r + cycle.z : cycle.z};
}

Result approach_hole(MotionContext& m, BlockWords& block, int axis, double r, bool first) {
  return goes_to_r_first(m.facts) ? approach_above(m, block, axis, r, first)
                                  : approach(m, block, axis, r);
}

}  // namespace cncsub
