// G36 and G37, measuring of tools: to near the measuring position at rapid, from there at the
// measuring feed until the tool arrives, and the offset by how far off that is. [TDi 17; M7 p.555]
#include "cncsub/motion_facts.hpp"

namespace cncsub {

/// How a tool is measured.
struct Motion::MeasuringMove {
  int axis = 0;
  double feed = 0;  // mm/min
  double near = 0;  // from the measuring position to where the feed begins
  double zone = 0;  // on both sides of the measuring position: where the tool may arrive
};

Motion::Result Motion::measure_tool(BlockWords& block) {
  MeasuringMove how;
  if (auto wrong = check_measuring(block, how)) return wrong;
  const auto axis = static_cast<std::size_t>(how.axis);
  std::uint32_t named = 0;
  const double point = linear_target(block, named)[axis];
  const double ahead = point < s_.work[axis] ? -1 : 1;
  if (std::fabs(point - s_.work[axis]) > how.near)
    if (auto wrong = move_axis(block, MoveKind::Rapid, how.axis, point - ahead * how.near))
      return wrong;
  Axes end = s_.work;
  end[axis] = point + ahead * how.zone;
  const bool words = facts_->control->measuring.value == Measuring::Words;
  const SignalMask arrival = signal_bit(words ? 1 : kArrivalSignal + how.axis);
  if (!signal_on_way(block, arrival, end)) return fault(Cause::MeasuringMissed, block);
  constexpr double kAtEdge = 1e-9;
  if (std::fabs(end[axis] - point) > how.zone + kAtEdge) return fault(Cause::MeasuringEarly, block);
  // The measuring feed counts minutes whatever F counts.
  const GCode mode = s_.modal[at(Group::Feed)];
  const double feed = s_.feed;
  s_.modal[at(Group::Feed)].meaning = Meaning::PerMinute;
  s_.feed = how.feed;
  hold_skip_feed();
  Piece piece = make_piece(block, MoveKind::Feed, end, axis_bit(how.axis));
  piece.skip = SkipMove::Touched;
  s_.modal[at(Group::Feed)] = mode;
  s_.feed = feed;
  if (auto wrong = move(block, piece)) return wrong;
  take_measure(how.axis, s_.work[axis] - point);
  return std::nullopt;
}

/// The axis, the feed and the zone; or what is wrong with them.
Motion::Result Motion::check_measuring(const BlockWords& block, MeasuringMove& how) const {
  const Control& c = *facts_->control;
  const bool lathe = facts_->lathe();
  if (compensating()) return fault(Cause::MeasuringInCompensation, block);
  if (block.words.has(lathe ? 'T' : 'H')) return fault(Cause::MeasuringWithOffset, block);
  const int code = block.codes[at(Group::OneShot)].code;
  how.axis = -1;
  int count = 0;
  for (int i = 0; i < kAxes; ++i)
    if (block.words.has(kAxisNames[static_cast<std::size_t>(i)])) {
      how.axis = i;
      ++count;
    }
  const bool increments = facts_->machine == MachineType::LatheA && how.axis > 5;
  if (increments || s_.incremental) return fault(Cause::MeasuringIncremental, block);
  const bool other = lathe ? how.axis != (code == 360 ? 0 : 2) : how.axis > 2;
  const bool z_alone = c.measuring.value == Measuring::Of5040;
  if (count != 1 || other || (z_alone && (how.axis != 2 || s_.plane != 17)))
    return fault(Cause::MeasuringAxis, block);
  if ((lathe ? s_.tool_offset : s_.h) == 0) return fault(Cause::MeasuringOffset, block);
  const auto parameter = [&c](int number) {
    return std::max(0.0, c.parameter(std::to_string(number)));
  };
  const auto word = [&](char letter, int number) {
    return block.words.has(letter) ? std::max(0.0, this->number(block, letter)) : parameter(number);
  };
  const int z = lathe && how.axis == 2 ? 1 : 0;
  switch (c.measuring.value) {
    case Measuring::None:
      break;
    case Measuring::Of6241:
      how = {how.axis, parameter(6241), parameter(6251 + z), parameter(6254 + z)};
      break;
    case Measuring::Of141:
      how = {how.axis, parameter(141), parameter(142 + z), parameter(144 + z)};
      break;
    case Measuring::Of5040:
      how = {how.axis, parameter(5040), parameter(5043), parameter(5044)};
      break;
    case Measuring::Words:
      how = {how.axis, parameter(8004), word('R', 8005), word('D', 8006)};
      if (block.words.has('F'))
        if (auto wrong = feed_of(block, how.feed)) return wrong;
      break;
  }
  const bool inside =
      z_alone ? how.near <= how.zone : how.near < how.zone;  // [MDib 0282; Talm 054]
  if (inside && facts_->refuses(Cause::MeasuringZone)) return fault(Cause::MeasuringZone, block);
  if (how.feed <= 0) return fault(Cause::NoMeasuringFeed, block);
  return std::nullopt;
}

/// Adds what was measured to the offset of the tool. It counts from the next H or T on; on a
/// control that measures by words from the next move of the axis.
void Motion::take_measure(int axis, double off) {
  const Control& c = *facts_->control;
  if (c.measuring_subtracts.value) off = -off;
  OffsetTables& tables = own_tables();
  if (facts_->lathe()) {
    changed_tool(s_.tool_offset).value[static_cast<std::size_t>(axis)] += off;
    return;
  }
  const bool at_once = c.measuring.value == Measuring::Words;
  auto& table = at_once ? tables.length_wear : tables.length;
  changed(table[static_cast<std::size_t>(s_.h)]) += off;
  if (!at_once || s_.modal[at(Group::Length)].meaning == Meaning::LengthOff) return;
  s_.length[static_cast<std::size_t>(axis)] += off;
  s_.work[static_cast<std::size_t>(axis)] -= off;
}

}  // namespace cncsub
