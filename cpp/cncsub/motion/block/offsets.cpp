// Tool offsets that move the tool, or let its path wait: lengths and radii.
#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {

Result move_by_length(MotionContext& m, BlockWords& block, const Axes& before) {
  if (m.facts.control->motion.length_type.value == LengthType::Shift) return std::nullopt;
  if (m.state.length == before || block.submitted || m.state.tool_pending ||
      block.has(Group::OneShot))
    return std::nullopt;
  std::uint32_t named = 0;
  for (int i = 0; i < kAxes; ++i)
    if (m.state.length[i] != before[i]) named |= axis_bit(i);
  const bool rapid = in_cycle(m.state) ||
                     m.state.modal[at(Group::Motion)].meaning == Meaning::Rapid ||
                     m.state.feed <= 0;
  if (auto wrong = move(m, block, rapid ? MoveKind::Rapid : MoveKind::Feed, m.state.work, named))
    return wrong;
  m.outcome.moved = true;
  return std::nullopt;
}

namespace {

/// Begin or end a side where moves end by their own normals: G40 records the last one, and a side
/// is begun only once.
Result change_by_own_normal(MotionContext& m, const BlockWords& block) {
  if (block.meaning(Group::Radius) != Meaning::RadiusOff)
    return compensating(m.state)
               ? Result(fault_at({.groups = bit(Group::Radius)}, Cause::CompensationTwice, block))
               : std::nullopt;
  m.state.lookahead.ended = m.state.lookahead.engaged;
  return flush_radius(m);
}

/// Check L beside G41.1 and G42.1: how a turning tool lies in its plane.
Result check_orientation(MotionView m, const BlockWords& block) {
  if (!block.words.has('L')) return std::nullopt;
  if (m.state.plane != Plane::ZX) return fault_at('L', Cause::AddressNotUsable, block, "L");
  return block.words['L'] == 0
             ? Result{}
             : fault_at('L', Cause::CodeNotComputed, block, "cncsub does not compute L of a tool");
}

}  // namespace

void set_contour_offset(MotionContext& m, const BlockWords& block) {
  for (const char name : m.facts.control->motion.contour_offset_words.value)
    if (block.words.has(name)) m.state.contour_offset = number(m, block, name);
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one case after the other
Result set_radius(MotionContext& m, BlockWords& block) {
  const Control& c = *m.facts.control;
  const bool measures = block.meaning(Group::OneShot) == Meaning::MeasureTool;  // D is its zone
  const bool given = block.has(Group::Radius) && block.code(Group::Radius).variant == 1;
  if (given) {
    if (!block.words.has('D'))
      return fault_at({.groups = bit(Group::Radius)}, Cause::RadiusOffsetNumber, block);
    if (auto wrong = check_orientation(m, block)) return wrong;
    m.state.given_radius = number(m, block, 'D') / 2;
  } else if (block.words.has('D') && !m.facts.lathe() && !measures) {
    const double number = counted(m, block.words, 'D');
    if (number < 0 || number >= static_cast<double>(m.state.tables.radius->size()))
      return fault_at('D', Cause::RadiusOffsetNumber, block);
    m.state.d = to_whole<int>(number);
  }
  if (!block.has(Group::Radius)) return std::nullopt;
  if (is_by_own_normal(m.facts))
    if (auto wrong = change_by_own_normal(m, block)) return wrong;
  m.state.modal[at(Group::Radius)] = block.code(Group::Radius);
  if (given || c.motion.tool_edges.value) return std::nullopt;
  if (compensating(m.state) && is_of_tool(m, block, 'D'))
    m.state.d = offset_of_tool(m.state, *m.state.tables.radius);
  if (!m.facts.lathe() && compensating(m.state) && m.state.d == 0 && !block.words.has('D') &&
      c.motion.missing_radius_offset.value == MissingOffset::Alarm)
    return fault_at({.groups = bit(Group::Radius)}, Cause::RadiusOffsetNumber, block);
  return std::nullopt;
}

}  // namespace cncsub
