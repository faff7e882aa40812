// G36 and G37, measuring of tools: rapid to near the measuring position, then the measuring feed
// until the tool arrives. The offset changes by how far off that is. [TDi 17; M7 p.555]
#include <algorithm>

#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

/// The feed and the distances of a measurement.
struct MeasuringMove {
  double feed = 0;  // mm/min
  double near = 0;  // from the measuring position to where the feed begins
  double zone = 0;  // on both sides of the measuring position: where the tool may arrive
};

/// Return these as the parameters say; `z`: for Z of a lathe.
MeasuringMove measuring_move(const Control& control, bool z) {
  const auto move = [&](int feed, int near, int zone) {
    const auto parameter = [&](int number) {
      return std::max(0.0, control.parameter(std::to_string(number)));
    };
    return MeasuringMove{parameter(feed), parameter(near), parameter(zone)};
  };
  switch (control.motion.measuring.value) {
    case Measuring::None:
      break;
    case Measuring::Of6241:
      return z ? move(6241, 6252, 6255) : move(6241, 6251, 6254);
    case Measuring::Of141:
      return z ? move(141, 143, 145) : move(141, 142, 144);
    case Measuring::Of5040:
      return move(5040, 5043, 5044);
    case Measuring::Words:
      return move(8004, 8005, 8006);
  }
  return {};
}

/// Find the axis that a block of G36 or G37 names, or return what is wrong with it.
Result measuring_axis(MotionView m, const BlockWords& block, int& axis) {
  const bool lathe = m.facts.lathe();
  int count = 0;
  for (int i = 0; i < kAxes; ++i)
    if (block.words.has(kAxisNames[static_cast<std::size_t>(i)])) axis = i, ++count;
  const bool increments = m.facts.machine == MachineType::LatheA && axis > 5;
  if (increments || m.state.incremental)
    return fault_at({.addresses = kAxisWords}, Cause::MeasuringIncremental, block);
  const bool other = lathe ? axis != (block.code(Group::OneShot).variant == 1 ? 0 : 2) : axis > 2;
  const bool z_alone = m.facts.control->motion.measuring.value == Measuring::Of5040;
  if (count != 1 || other || (z_alone && (axis != 2 || m.state.plane != Plane::XY)))
    return fault(Cause::MeasuringAxis, block);
  return std::nullopt;
}

/// Take R, D and F over where the words of the block count before the parameters.
Result measuring_words(MotionView m, const BlockWords& block, MeasuringMove& how) {
  if (m.facts.control->motion.measuring.value != Measuring::Words) return std::nullopt;
  if (block.words.has('R')) how.near = std::max(0.0, number(m, block, 'R'));
  if (block.words.has('D')) how.zone = std::max(0.0, number(m, block, 'D'));
  return block.words.has('F') ? feed_of(m, block, how.feed) : std::nullopt;
}

/// Find the axis, the feed and the zone, or return what is wrong with them.
Result check_measuring(MotionView m, const BlockWords& block, int& axis, MeasuringMove& how) {
  const bool lathe = m.facts.lathe();
  if (compensating(m.state)) return fault(Cause::MeasuringInCompensation, block);
  if (block.words.has(lathe ? 'T' : 'H'))
    return fault_at(lathe ? 'T' : 'H', Cause::MeasuringWithOffset, block);
  if (auto wrong = measuring_axis(m, block, axis)) return wrong;
  if ((lathe ? m.state.tool_offset : m.state.h) == 0) return fault(Cause::MeasuringOffset, block);
  how = measuring_move(*m.facts.control, lathe && axis == 2);
  if (auto wrong = measuring_words(m, block, how)) return wrong;
  const bool z_alone = m.facts.control->motion.measuring.value == Measuring::Of5040;
  const bool inside =
      z_alone ? how.near <= how.zone : how.near < how.zone;  // [MDib 0282; Talm 054]
  if (inside && m.facts.refuses(Cause::MeasuringZone)) return fault(Cause::MeasuringZone, block);
  if (how.feed <= 0) return fault_at('F', Cause::NoMeasuringFeed, block);
  return std::nullopt;
}

/// Add what was measured to the offset of the tool. It counts from the next H or T on; on a control
/// that measures by words, from the next move of the axis.
void take_measure(MotionContext& m, int axis, double off) {
  const Control& c = *m.facts.control;
  if (c.motion.measured.value == Measured::Subtracted) off = -off;
  OffsetTables& tables = m.state.tables;
  if (m.facts.lathe()) {
    tables.change_tool(m.state.tool_offset).value[static_cast<std::size_t>(axis)] += off;
    return;
  }
  const bool at_once = c.motion.measuring.value == Measuring::Words;
  auto& table = at_once ? tables.length_wear : tables.length;
  table.change()[static_cast<std::size_t>(m.state.h)] += off;
  if (!at_once || m.state.modal[at(Group::Length)].meaning == Meaning::LengthOff) return;
  m.state.length[static_cast<std::size_t>(axis)] += off;
  m.state.work[static_cast<std::size_t>(axis)] -= off;
}

}  // namespace

Result measure_tool(MotionContext& m, BlockWords& block) {
  MeasuringMove how;
  int number = -1;
  if (auto wrong = check_measuring(m, block, number, how)) return wrong;
  const auto axis = static_cast<std::size_t>(number);
  const double point = linear_target(m, block).point[axis];
  const double ahead = point < m.state.work[axis] ? -1 : 1;
  if (std::fabs(point - m.state.work[axis]) > how.near)
    if (auto wrong = move_axis(m, block, MoveKind::Rapid, number, point - ahead * how.near))
      return wrong;
  Axes end = m.state.work;
  end[axis] = point + ahead * how.zone;
  const bool words = m.facts.control->motion.measuring.value == Measuring::Words;
  const SignalMask arrival = signal_bit(words ? 1 : kArrivalSignal + number);
  if (!signal_on_way(m, arrival, end)) return fault(Cause::MeasuringMissed, block);
  constexpr double kAtEdge = 1e-9;
  if (std::fabs(end[axis] - point) > how.zone + kAtEdge) return fault(Cause::MeasuringEarly, block);
  Piece piece = make_piece(m, block, MoveKind::Feed, end, axis_bit(number));
  piece.skip = SkipMove::Touched;
  // The measuring feed counts minutes whatever F counts.
  piece.state.feed = held_skip_feed(m, how.feed, FeedMode::PerMinute);
  piece.state.feed_mode = FeedMode::PerMinute;
  piece.state.degree = degree_of_feed(m.state);
  if (auto wrong = move(m, block, piece)) return wrong;
  take_measure(m, number, m.state.work[axis] - point);
  return std::nullopt;
}

}  // namespace cncsub
