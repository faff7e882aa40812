// The end point that a block names.
#include <bit>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

/// Return whether C or U alone may write a corner, or A an angle, and so no move of that axis.
bool corner_address(MotionView m, char name) {
  if (name != 'U' && ((name != 'C' && name != 'A') || !m.facts.lathe())) return false;
  return ((m.facts.chamfers.mask | m.facts.rounds.mask | m.facts.angles.mask) & bit(name)) != 0;
}

/// Return whether a block may have corners. Only a cut has them: elsewhere C is an axis.
bool has_corners(const MotionState& state, const BlockWords& block) {
  const Meaning motion = state.modal[at(Group::Motion)].meaning;
  const bool cuts = motion == Meaning::Line || motion == Meaning::Cw || motion == Meaning::Ccw;
  return cuts && !in_cycle(state) && goes_with_motion(state, block);
}

/// The letters for increments on a lathe with G code system A.
constexpr std::pair<char, char> kIncrements[] = {{'U', 'X'}, {'W', 'Z'}, {'V', 'Y'}, {'H', 'C'}};
constexpr std::uint32_t kIncrementWords = bit('U') | bit('W') | bit('V') | bit('H');

void add_increments(MotionContext& m, const BlockWords& block, Axes& end, std::uint32_t& named) {
  for (const auto& [letter, name] : kIncrements) {
    if (!block.words.has(letter)) continue;
    const int axis = axis_of(name);
    if ((named & axis_bit(axis)) != 0) {
      m.outcome.drop(bit(letter));
      continue;
    }
    named |= axis_bit(axis);
    end[axis] += number(m, block, letter);
  }
}

/// Return where a rotary axis ends that goes to an angle by the shorter way, or in one direction.
double on_way(const WordForms& forms, std::size_t axis, double from, double angle) {
  if (forms.rotary == 0 || !is_rotary(static_cast<int>(axis))) return angle;
  const auto asks = [&](unsigned first) { return (forms.rotary >> (axis - 3 + first) & 1) != 0; };
  const double way = angle - from, nearest = std::remainder(way, 360);
  const double up = nearest < 0 ? nearest + 360 : nearest;
  if (asks(0)) return from + nearest;
  if (asks(8)) return from + up;
  return asks(16) ? from + (up > 0 ? up - 360 : 0) : angle;
}

// The letters of axes, and those that may be a corner or an angle instead.
constexpr std::uint32_t kCornerAxes = bit('A') | bit('C') | bit('U');
constexpr std::uint32_t kAxesOfA = kEndWords | bit('A') | bit('B') | bit('C');
constexpr std::uint32_t kAllAxes = kAxesOfA | bit('U') | bit('V') | bit('W');

}  // namespace

NamedPoint target(MotionContext& m, const BlockWords& block) {
  return target(m, block, {m.state.incremental, polar(m.state)});
}

NamedPoint target(MotionContext& m, const BlockWords& block, const PointForm& form) {
  std::uint32_t named = 0;
  const bool turned = is_turned(m.state);
  Axes end = as_programmed(m.state, m.state.work);
  const bool lathe_a = m.facts.machine == MachineType::LatheA;
  const bool corners = (block.words.mask & kCornerAxes) != 0 && has_corners(m.state, block);
  std::uint32_t letters = block.words.mask & (lathe_a ? kAxesOfA : kAllAxes);
  for (; letters != 0; letters &= letters - 1) {
    const char name = static_cast<char>('A' + std::countr_zero(letters));
    if (corners && corner_address(m, name)) continue;
    const auto i = static_cast<std::size_t>(axis_of(name));
    named |= axis_bit(static_cast<int>(i));
    const double value = number(m, block, name);
    if (block.words.forms.is_incremental(bit(name), form.incremental))
      end[i] += value + m.state.unmoved[i];
    else
      end[i] = on_way(block.words.forms, i, end[i], value);
    m.state.unmoved[i] = 0;
  }
  if (lathe_a && (block.words.mask & kIncrementWords) != 0) add_increments(m, block, end, named);
  if ((block.words.mask & kPolarWords) != 0) polar_words(m, block, form.incremental, end, named);
  if (form.polar) polar_target(m, block, form.incremental, end, named);
  if (turned) turn_point(m.state, end, named);
  return {end, named};
}

NamedPoint end_point(MotionContext& m, const BlockWords& block) {
  NamedPoint end = target(m, block);
  if (block.axis_extension != 0) end.point = lengthened(m, block, end.point, end.named);
  return end;
}

NamedPoint linear_target(MotionContext& m, const BlockWords& block) {
  return target(m, block, {m.state.incremental, false});
}

}  // namespace cncsub
