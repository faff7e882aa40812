// Canned cycles: drilling, boring, tapping of mills, and the drilling cycles of lathes.
#include "cncsub/motion_facts.hpp"

namespace cncsub {

Motion::Result Motion::enter_cycle(BlockWords& block) {
  const Meaning meaning = block.meaning(Group::Cycle);
  s_.modal[at(Group::Cycle)] = block.codes[at(Group::Cycle)];
  if (meaning == Meaning::CycleOff) {
    end_cycles();
    return std::nullopt;
  }
  const int code = block.codes[at(Group::Cycle)].code;
  if (!in_cycle()) {
    s_.cycle = {};
    s_.cycle.initial = s_.work[static_cast<std::size_t>(drill_axis(code))];
  }
  s_.cycle.cycle = meaning;
  s_.cycle.code = code;
  return std::nullopt;
}

/// The axis a cycle drills along: across the plane; of a lathe Z, or X for G87 to G89.
int Motion::drill_axis(int code) const {
  if (!facts_->lathe()) return plane_axes(s_.plane).across;
  return code >= 870 ? 0 : 2;
}

void Motion::end_cycles() {
  if (in_cycle()) s_.modal[at(Group::Cycle)] = facts_->codes.of(Meaning::CycleOff);
  s_.cycle = {};
}

/// Takes R Z Q P I J K and the count over; what is not written stays as it was.
Motion::Result Motion::cycle_words(BlockWords& block, int& repeats) {
  const NcWords& w = block.words;
  CycleData& cycle = s_.cycle;
  const Control& c = *facts_->control;
  const char depth = kAxisNames[static_cast<std::size_t>(drill_axis(cycle.code))];
  if (w.has('R'))
    cycle.r = number(block, 'R'), cycle.r_incremental = s_.incremental, cycle.has_r = true;
  if (w.has(depth))
    cycle.z = number(block, depth), cycle.z_incremental = s_.incremental, cycle.has_z = true;
  if (w.has('Q')) cycle.q = cycle_length(block, 'Q'), cycle.has_q = true;
  if (w.has('P')) cycle.p = raw(block, 'P') * (c.dwell_p_seconds.value ? 1 : 0.001);
  if (w.has('I') || w.has('J')) {
    cycle.shift_x = w.has('I') ? number(block, 'I') : 0;
    cycle.shift_y = w.has('J') ? number(block, 'J') : 0;
    cycle.has_shift = true;
  }
  if (facts_->lathe() && w.has('D')) cycle.clearance = number(block, 'D');
  if (c.drill_retract.value && w.has('J')) cycle.full = raw(block, 'J') == 1;
  if (w.has('K') && c.peck_words.value == PeckWords::K)
    cycle.k = number(block, 'K'), cycle.has_k = true;
  repeats = 1;
  for (const char letter : c.cycle_repeats.value)
    if (w.has(letter)) repeats = whole(raw(block, letter));
  if (w.has('K') && w.has('L') && facts_->refuses(Cause::CycleRepeatsTwice))
    return fault(Cause::CycleRepeatsTwice, block);
  const bool too_many = c.max_cycle_repeats.value > 0 && repeats > c.max_cycle_repeats.value;
  if (repeats < 0 || too_many ||
      (repeats == 0 && c.zero_cycle_repeats.value == ZeroCycleRepeats::Alarm))
    return fault(Cause::CycleRepeats, block);
  const bool pecks = cycle.cycle == Meaning::Peck || cycle.cycle == Meaning::PeckFast;
  if (pecks && !facts_->lathe() && cycle.q == 0 && c.peck_needed.value)
    return fault(Cause::NoPeck, block);
  return std::nullopt;
}

Motion::Result Motion::check_tap(const BlockWords& block) const {
  if (s_.cycle.cycle != Meaning::Tap && s_.cycle.cycle != Meaning::LeftTap) return std::nullopt;
  if (s_.speed <= 0 && s_.rigid && facts_->refuses(Cause::RigidSpeed))
    return fault(Cause::RigidSpeed, block);
  if (s_.speed <= 0 && facts_->refuses(Cause::TapSpeed)) return fault(Cause::TapSpeed, block);
  if (s_.feed <= 0 && facts_->refuses(Cause::TapLead)) return fault(Cause::TapLead, block);
  return std::nullopt;
}

Motion::Result Motion::canned_cycle(BlockWords& block) {
  const NcWords& w = block.words;
  bool position = w.has('R');
  for (const char axis : kAxisNames) position = position || w.has(axis);
  int repeats = 1;
  if (position || block.has(Group::Cycle))
    if (auto wrong = cycle_words(block, repeats)) return wrong;
  if (!position || repeats == 0) return std::nullopt;
  if (auto wrong = check_tap(block)) return wrong;
  if (auto wrong = need_feed(block, Meaning::Line)) return wrong;
  for (int i = 0; i < repeats; ++i)
    if (auto wrong = drill(block)) return wrong;
  return std::nullopt;
}

/// One hole: to the place, to R, down, up.
Motion::Result Motion::drill(BlockWords& block) {
  const CycleData cycle = s_.cycle;
  const int axis = drill_axis(cycle.code);
  const double present = s_.work[static_cast<std::size_t>(axis)];
  const double r = !cycle.has_r          ? cycle.initial
                   : cycle.r_incremental ? cycle.initial + cycle.r
                                         : cycle.r;
  const double z = !cycle.has_z ? r : cycle.z_incremental ? r + cycle.z : cycle.z;
  std::uint32_t named = 0;
  Axes place = target(block, named);
  place[static_cast<std::size_t>(axis)] = present;
  named &= ~axis_bit(axis);
  if (named != 0)
    if (auto wrong = move(block, MoveKind::Rapid, place, named)) return wrong;
  if (cycle.cycle == Meaning::BackBore) return bore_shifted(block, r, z);
  if (auto wrong = move_axis(block, MoveKind::Rapid, axis, r)) return wrong;
  if (auto wrong = drill_down(block, axis, r, z)) return wrong;
  return drill_up(block, axis, r);
}

Motion::Result Motion::drill_down(BlockWords& block, int axis, double r, double z) {
  const CycleData& cycle = s_.cycle;
  const bool pecks = cycle.cycle == Meaning::Peck || cycle.cycle == Meaning::PeckFast;
  const bool plain = facts_->control->drill_retract.value && cycle.r == 0;
  if (pecks && cycle.q != 0 && !plain) return peck(block, axis, r, z);
  if (auto wrong = move_axis(block, MoveKind::Feed, axis, z)) return wrong;
  switch (cycle.cycle) {
    case Meaning::LeftTap:
    case Meaning::FineBore:
    case Meaning::DrillDwell:
    case Meaning::Tap:
    case Meaning::BoreManual:
    case Meaning::BoreDwell:
      return cycle.p > 0 ? wait(block, cycle.p) : std::nullopt;
    default:
      return std::nullopt;
  }
}

/// Down in bits of Q: G73 draws back a little, G83 to R and down again to just above the last
/// depth.
Motion::Result Motion::peck(BlockWords& block, int axis, double r, double z) {
  const Control& c = *facts_->control;
  const CycleData cycle = s_.cycle;
  const double down = z < r ? -1 : 1, q = std::fabs(cycle.q);
  const bool fast = cycle.cycle == Meaning::PeckFast ||
                    (facts_->lathe() && !c.drill_full_retract.value && !cycle.full);
  double gap = (fast ? c.peck_retract.value : c.peck_clearance.value) * 1e-3;
  if (c.peck_words.value == PeckWords::K && cycle.has_k) gap = std::fabs(cycle.k);
  if (cycle.clearance >= 0) gap = cycle.clearance;
  if (c.drill_retract.value) gap = std::fabs(cycle.r);
  for (double depth = r + down * q; (z - depth) * down > 1e-9; depth += down * q) {
    if (auto wrong = move_axis(block, MoveKind::Feed, axis, depth)) return wrong;
    if (!fast)
      if (auto wrong = move_axis(block, MoveKind::Rapid, axis, r)) return wrong;
    if (auto wrong = move_axis(block, MoveKind::Rapid, axis, depth - down * gap)) return wrong;
  }
  return move_axis(block, MoveKind::Feed, axis, z);
}

Motion::Result Motion::drill_up(BlockWords& block, int axis, double r) {
  const CycleData cycle = s_.cycle;
  const bool to_r = s_.modal[at(Group::Return)].meaning == Meaning::ReturnR;
  const double level = to_r ? r : cycle.initial;
  switch (cycle.cycle) {
    case Meaning::LeftTap:
    case Meaning::Tap:
    case Meaning::Bore:
    case Meaning::BoreDwell:
      if (auto wrong = move_axis(block, MoveKind::Feed, axis, r)) return wrong;
      return to_r ? std::nullopt : move_axis(block, MoveKind::Rapid, axis, level);
    case Meaning::FineBore: {
      const Axes hole = s_.work;
      if (auto wrong = shift_tool(block, hole, true)) return wrong;
      if (auto wrong = move_axis(block, MoveKind::Rapid, axis, level)) return wrong;
      return shift_tool(block, hole, false);
    }
    default:
      return move_axis(block, MoveKind::Rapid, axis, level);
  }
}

/// The bar stands oriented and goes off its point, or back to the middle of the hole.
Motion::Result Motion::shift_tool(BlockWords& block, const Axes& hole, bool away) {
  const PlaneAxes plane = plane_axes(s_.plane);
  const CycleData& cycle = s_.cycle;
  Axes end = s_.work;
  const double a = cycle.has_shift ? cycle.shift_x : std::fabs(cycle.q),
               b = cycle.has_shift ? cycle.shift_y : 0;
  end[plane.a] = hole[plane.a] + (away ? a : 0);
  end[plane.b] = hole[plane.b] + (away ? b : 0);
  std::uint32_t named = axis_bit(plane.a);
  if (b != 0) named |= axis_bit(plane.b);
  return move(block, MoveKind::Rapid, end, named);
}

/// G87: down beside the hole, boring upward.
Motion::Result Motion::bore_shifted(BlockWords& block, double r, double z) {
  const int axis = drill_axis(s_.cycle.code);
  const Axes hole = s_.work;
  const double initial = s_.cycle.initial;
  if (auto wrong = shift_tool(block, hole, true)) return wrong;
  if (auto wrong = move_axis(block, MoveKind::Rapid, axis, r)) return wrong;
  if (auto wrong = shift_tool(block, hole, false)) return wrong;
  if (auto wrong = move_axis(block, MoveKind::Feed, axis, z)) return wrong;
  if (s_.cycle.p > 0)
    if (auto wrong = wait(block, s_.cycle.p)) return wrong;
  if (auto wrong = shift_tool(block, hole, true)) return wrong;
  if (auto wrong = move_axis(block, MoveKind::Rapid, axis, initial)) return wrong;
  return shift_tool(block, hole, false);
}

/// The drilling cycles of a lathe: R counts from the initial level, the way out leads back to it.
/// [TA 24]
Motion::Result Motion::drilling_cycle(BlockWords& block) {
  const NcWords& w = block.words;
  bool position = false;
  for (const char letter : std::string_view("XYZCUVWHR")) position = position || w.has(letter);
  int repeats = 1;
  if (position || block.has(Group::Cycle))
    if (auto wrong = cycle_words(block, repeats)) return wrong;
  if (!position || repeats == 0) return std::nullopt;
  if (auto wrong = need_feed(block, Meaning::Line)) return wrong;
  for (int i = 0; i < repeats; ++i)
    if (auto wrong = drill_lathe(block)) return wrong;
  return std::nullopt;
}

Motion::Result Motion::drill_lathe(BlockWords& block) {
  const int axis = drill_axis(s_.cycle.code);
  const auto place_axis = static_cast<std::size_t>(axis);
  const double double_x = axis == 0 ? 2 : 1;
  std::uint32_t named = 0;
  const Axes written = target(block, named);
  const double level = s_.work[place_axis];
  const bool plane = s_.cycle.has_r && !facts_->control->drill_retract.value;
  const double r = plane ? level + s_.cycle.r * double_x : level;
  double z = written[place_axis];
  const char increment = axis == 0 ? 'U' : 'W';
  if (block.words.has(increment)) z = r + number(block, increment);
  if ((named & axis_bit(axis)) == 0) z = s_.cycle.z;
  s_.cycle.z = z;
  s_.cycle.initial = level;
  Axes place = written;
  place[place_axis] = level;
  named &= ~axis_bit(axis);
  if (named != 0)
    if (auto wrong = move(block, MoveKind::Rapid, place, named)) return wrong;
  if (plane)
    if (auto wrong = move_axis(block, MoveKind::Rapid, axis, r)) return wrong;
  if (auto wrong = drill_down(block, axis, r, z)) return wrong;
  if (s_.cycle.cycle == Meaning::Peck && s_.cycle.p > 0)
    if (auto wrong = wait(block, s_.cycle.p)) return wrong;
  if (s_.cycle.cycle == Meaning::Peck) return move_axis(block, MoveKind::Rapid, axis, level);
  Axes out = s_.work;
  out[place_axis] = plane ? r : level;
  Piece back = make_piece(block, MoveKind::Feed, out, axis_bit(axis));
  if (s_.cycle.cycle == Meaning::Bore)
    back.state.feed *= facts_->control->bore_return.value * 0.01;  // [TA 26]
  if (auto wrong = move(block, back)) return wrong;
  return plane ? move_axis(block, MoveKind::Rapid, axis, level) : std::nullopt;
}

}  // namespace cncsub
