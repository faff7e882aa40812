// The end point that a block names.
#include "cncsub/motion/emit.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/words.hpp"

namespace cncsub {
namespace {

/// A corner written with C or U alone, or an angle with A, is no move of that axis.
bool corner_address(MotionView m, char name) {
  if (name != 'U' && ((name != 'C' && name != 'A') || !m.facts.lathe())) return false;
  return ((m.facts.chamfers.mask | m.facts.rounds.mask | m.facts.angles.mask) & bit(name)) != 0;
}

/// What a lathe with G code system A writes for increments.
constexpr std::pair<char, char> kIncrements[] = {{'U', 'X'}, {'W', 'Z'}, {'V', 'Y'}, {'H', 'C'}};

}  // namespace

PointForm point_form(const MotionState& state) { return {state.incremental, polar(state)}; }

Axes target(MotionContext& m, BlockWords& block, std::uint32_t& named) {
  return target(m, block, point_form(m.state), named);
}

Axes target(MotionContext& m, BlockWords& block, const PointForm& form, std::uint32_t& named) {
  Axes end = turned(m.state) ? turned_back(m.state, m.state.work) : m.state.work;
  const bool lathe_a = m.facts.machine == MachineType::LatheA;
  // Only a cut has corners: elsewhere C is an axis.
  const Meaning motion = m.state.modal[at(Group::Motion)].meaning;
  const bool cuts = motion == Meaning::Line || motion == Meaning::Cw || motion == Meaning::Ccw;
  const bool corners = cuts && !in_cycle(m.state) && goes_with_motion(m.state, block);
  for (int i = 0; i < (lathe_a ? 6 : kAxes); ++i) {
    const char name = kAxisNames[static_cast<std::size_t>(i)];
    if (!block.words.has(name) || (corners && corner_address(m, name))) continue;
    named |= axis_bit(i);
    end[i] = number(m, block, name) + (form.incremental ? end[i] : 0);
  }
  for (const auto& [letter, name] : kIncrements) {
    const int axis = axis_of(name);
    if (!lathe_a || !block.words.has(letter)) continue;
    if ((named & axis_bit(axis)) != 0) {
      m.outcome.drop(bit(letter));
      continue;
    }
    named |= axis_bit(axis);
    end[axis] += number(m, block, letter);
  }
  if (form.polar) polar_target(m, block, form.incremental, end, named);
  if (turned(m.state)) turn_point(m.state, end, named);
  return end;
}

Axes end_point(MotionContext& m, BlockWords& block, std::uint32_t& named) {
  const Axes end = target(m, block, named);
  return lengthened(m, block, end, named);
}

Axes linear_target(MotionContext& m, BlockWords& block, std::uint32_t& named) {
  return target(m, block, {m.state.incremental, false}, named);
}

}  // namespace cncsub
