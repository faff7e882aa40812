// Canned cycles: drilling, boring, tapping of mills, and the drilling cycles of lathes.
#include "cncsub/motion/cycle/cycles.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

/// Return the axis a cycle drills along: across the plane; of a lathe Z, or X for G87 to G89.
int drill_axis(MotionView m, const GCode& code) {
  if (!m.facts.lathe()) return plane_axes(m.state.plane).across;
  return code.variant == 1 ? 0 : 2;
}

bool taps(const CycleData& cycle) {
  return cycle.cycle == Meaning::Tap || cycle.cycle == Meaning::LeftTap;
}
bool pecks(const CycleData& cycle) {
  return cycle.cycle == Meaning::Peck || cycle.cycle == Meaning::PeckFast;
}

/// Return whether a cycle waits at the bottom of its hole.
bool dwells(Meaning cycle) {
  switch (cycle) {
    case Meaning::LeftTap:
    case Meaning::FineBore:
    case Meaning::DrillDwell:
    case Meaning::Tap:
    case Meaning::BoreManual:
    case Meaning::BoreDwell:
      return true;
    default:
      return false;
  }
}

/// Take over R Z Q P I J K; what is not written stays as it was.
void take_cycle_words(MotionContext& m, const BlockWords& block) {
  const NcWords& w = block.words;
  CycleData& cycle = m.state.cycle;
  const Control& c = *m.facts.control;
  const char depth = kAxisNames[static_cast<std::size_t>(drill_axis(m, cycle.code))];
  const bool incremental = m.state.incremental;
  if (w.has('R'))
    cycle.r = number(m, block, 'R'), cycle.r_incremental = incremental, cycle.has_r = true;
  if (w.has(depth))
    cycle.z = number(m, block, depth), cycle.z_incremental = incremental, cycle.has_z = true;
  if (w.has('Q')) cycle.q = cycle_length(m, block, 'Q'), cycle.has_q = true;
  if (w.has('P') && (dwells(cycle.cycle) || !goes_to_r_first(m.facts)))
    cycle.p = dwell_in_hole(m, w);
  if (w.has('I') || w.has('J')) {
    cycle.shift_x = w.has('I') ? number(m, block, 'I') : 0;
    cycle.shift_y = w.has('J') ? number(m, block, 'J') : 0;
    cycle.has_shift = true;
  }
  if (m.facts.lathe() && w.has('D')) cycle.clearance = number(m, block, 'D');
  if (c.turning.drill_retract.value && w.has('J')) cycle.full = w['J'] == 1;
  if (w.has('K') && c.motion.peck_words.value == PeckWords::K)
    cycle.k = number(m, block, 'K'), cycle.has_k = true;
}

/// Check for the words that the first block of a cycle must have.
Result check_first_words(MotionView m, const BlockWords& block) {
  const CycleData& cycle = m.state.cycle;
  const bool first =
      block.has(Group::Cycle) && block.code(Group::Cycle).code != m.state.cycle_before;
  if (!goes_to_r_first(m.facts) || !first) return std::nullopt;
  const bool dwells = cycle.cycle == Meaning::DrillDwell || cycle.cycle == Meaning::BoreManual ||
                      cycle.cycle == Meaning::BoreDwell;
  const char depth = kAxisNames[static_cast<std::size_t>(drill_axis(m, cycle.code))];
  const NcWords& w = block.words;
  const bool missing =
      !w.has('R') || !w.has(depth) || (dwells && !w.has('P')) || (pecks(cycle) && !w.has('Q'));
  return missing ? Result(fault(Cause::MotionWordMissing, block)) : std::nullopt;
}

/// Refuse words that change the moves of the cycle in a way that is not computed.
Result check_computed(MotionView m, const BlockWords& block) {
  for (const char letter : m.facts.control->motion.cycle_words_not_computed.value)
    if (block.words.has(letter))
      return fault_at(letter, Cause::CodeNotComputed, block,
                      std::string("a canned cycle with ") + letter);
  return std::nullopt;
}

/// Read how often the cycle is done, or return what is wrong with its words.
Result cycle_words(MotionContext& m, const BlockWords& block, int& repeats) {
  if (auto wrong = check_computed(m, block)) return wrong;
  take_cycle_words(m, block);
  if (auto wrong = check_first_words(m, block)) return wrong;
  const NcWords& w = block.words;
  const CycleData& cycle = m.state.cycle;
  const Control& c = *m.facts.control;
  repeats = 1;
  for (const char letter : c.motion.cycle_repeats.value)
    if (w.has(letter)) repeats = whole(counted(m, w, letter));
  if (w.has('K') && w.has('L') && m.facts.refuses(Cause::CycleRepeatsTwice))
    return fault_at({.addresses = bit('K') | bit('L')}, Cause::CycleRepeatsTwice, block);
  const int most = c.motion.max_cycle_repeats.value;
  if (repeats < 0 || (most > 0 && repeats > most) ||
      (repeats == 0 && c.motion.zero_cycle_repeats.value == ZeroCycleRepeats::Alarm))
    return fault_at({.addresses = bit('K') | bit('L')}, Cause::CycleRepeats, block);
  if (pecks(cycle) && !m.facts.lathe() && cycle.q == 0 && m.facts.refuses(Cause::NoPeck))
    return fault_at('Q', Cause::NoPeck, block);
  if (pecks(cycle) && w.has('Q') && w['Q'] < 0 && m.facts.refuses(Cause::PeckNegative))
    return fault_at('Q', Cause::PeckNegative, block);
  return std::nullopt;
}

Result check_rotary(MotionView m, const BlockWords& block) {
  if (!m.facts.refuses(Cause::CycleRotary)) return std::nullopt;
  for (const char name : std::string_view("ABC")) {
    if (!block.words.has(name)) continue;
    Fault wrong = fault_at(name, Cause::CycleRotary, block);
    wrong.name = name == 'A' ? "an a" : std::string("a ") + static_cast<char>(name - 'A' + 'a');
    return wrong;
  }
  return std::nullopt;
}

/// Check the spindle. Cycles that stop or reverse it need it to turn, taps in their own direction.
Result check_spindle(MotionView m, const BlockWords& block) {
  if (!goes_to_r_first(m.facts) || !m.facts.refuses(Cause::SpindleStands)) return std::nullopt;
  const Meaning cycle = m.state.cycle.cycle;
  const bool tap = taps(m.state.cycle);
  if (!tap && cycle != Meaning::BoreStop && cycle != Meaning::BackBore &&
      cycle != Meaning::BoreManual)
    return std::nullopt;
  if (!m.state.turns) return fault(Cause::SpindleStands, block);
  return tap && m.state.backward != (cycle == Meaning::LeftTap)
             ? Result(fault(Cause::SpindleDirection, block))
             : std::nullopt;
}

Result check_tap(MotionView m, const BlockWords& block) {
  if (!taps(m.state.cycle)) return std::nullopt;
  if (m.state.speed <= 0 && m.state.rigid && m.facts.refuses(Cause::RigidSpeed))
    return fault_at('S', Cause::RigidSpeed, block);
  if (m.state.speed <= 0 && m.facts.refuses(Cause::TapSpeed))
    return fault_at('S', Cause::TapSpeed, block);
  if (m.state.feed <= 0 && m.facts.refuses(Cause::TapLead))
    return fault_at('F', Cause::TapLead, block);
  return std::nullopt;
}

/// Feed down in bits of Q. G73 draws back a little; G83 goes to R and down again to just above the
/// last depth.
Result peck(MotionContext& m, BlockWords& block, int axis, double r, double z) {
  const Control& c = *m.facts.control;
  const CycleData cycle = m.state.cycle;
  const double down = z < r ? -1 : 1, q = std::fabs(cycle.q);
  const bool fast = cycle.cycle == Meaning::PeckFast ||
                    (m.facts.lathe() && !c.turning.drill_full_retract.value && !cycle.full);
  double gap = (fast ? c.motion.peck_retract.value : c.motion.peck_clearance.value) * 1e-3;
  if (c.motion.peck_words.value == PeckWords::K && cycle.has_k) gap = std::fabs(cycle.k);
  if (cycle.clearance >= 0) gap = cycle.clearance;
  if (c.turning.drill_retract.value) gap = std::fabs(cycle.r);
  const double clear = r - down * c.motion.peck_above.value * 1e-3;
  for (double depth = r + down * q; (z - depth) * down > 1e-9; depth += down * q) {
    if (auto wrong = move_axis(m, block, MoveKind::Feed, axis, depth)) return wrong;
    if (!fast)
      if (auto wrong = move_axis(m, block, MoveKind::Rapid, axis, clear)) return wrong;
    if (auto wrong = move_axis(m, block, MoveKind::Rapid, axis, depth - down * gap)) return wrong;
  }
  return move_axis(m, block, MoveKind::Feed, axis, z);
}

/// Feed a tap to a level. Where the control takes its axes for each other outside of G17, so do we;
/// the cycle goes on over its hole. [rs274 2.9: convert_cycle_g74_g84]
Result feed_tap(MotionContext& m, BlockWords& block, int axis, double level) {
  const MotionRules& rules = m.facts.control->motion;
  Axes hole = m.state.work;
  Axes end = hole;
  hole[static_cast<std::size_t>(axis)] = level;
  if (rules.tap_return.value != TapReturn::Shuffled || m.state.plane == Plane::XY) {
    Piece piece = make_piece(m, block, MoveKind::Feed, hole, axis_bit(axis));
    if (rules.tap_feed.value == TapFeed::Lead) piece.state.feed_mode = FeedMode::PerRevolution;
    return move(m, block, piece);
  }
  if (m.state.plane == Plane::ZX)
    end[0] = level, end[1] = hole[2], end[2] = hole[0];
  else
    end[0] = hole[2], end[1] = level, end[2] = hole[1];
  auto wrong = move(m, block, MoveKind::Feed, end, straight_axes(~0U));
  m.state.work = hole;
  return wrong;
}

Result drill_down(MotionContext& m, BlockWords& block, int axis, double r, double z) {
  const CycleData& cycle = m.state.cycle;
  const bool plain = m.facts.control->turning.drill_retract.value && cycle.r == 0;
  if (pecks(cycle) && cycle.q != 0 && !plain) return peck(m, block, axis, r, z);
  if (auto wrong =
          taps(cycle) ? feed_tap(m, block, axis, z) : move_axis(m, block, MoveKind::Feed, axis, z))
    return wrong;
  return dwells(cycle.cycle) && cycle.p > 0 ? add_dwell(m, block, cycle.p) : std::nullopt;
}

/// Shift the oriented bar off its point, or back to the middle of the hole.
Result shift_tool(MotionContext& m, BlockWords& block, const Axes& hole, bool away) {
  const PlaneAxes plane = plane_axes(m.state.plane);
  const CycleData& cycle = m.state.cycle;
  Axes end = m.state.work;
  const double a = cycle.has_shift ? cycle.shift_x : std::fabs(cycle.q),
               b = cycle.has_shift ? cycle.shift_y : 0;
  end[plane.a] = hole[plane.a] + (away ? a : 0);
  end[plane.b] = hole[plane.b] + (away ? b : 0);
  std::uint32_t named = axis_bit(plane.a);
  if (b != 0) named |= axis_bit(plane.b);
  return move(m, block, MoveKind::Rapid, end, named);
}

/// Leave the hole of a tap or a bore at the feed: to R and on at rapid, or all the way to the
/// level, as the control does. `to_r`: the level is R.
Result feed_up(MotionContext& m, BlockWords& block, int axis, double r, double level, bool to_r) {
  const TapReturn form = m.facts.control->motion.tap_return.value;
  const bool tap = taps(m.state.cycle);
  const bool whole = tap ? form != TapReturn::R
                         : m.state.cycle.cycle == Meaning::BoreDwell && form == TapReturn::Shuffled;
  const double end = whole ? level : r;
  if (auto wrong =
          tap ? feed_tap(m, block, axis, end) : move_axis(m, block, MoveKind::Feed, axis, end))
    return wrong;
  return whole || to_r ? std::nullopt : move_axis(m, block, MoveKind::Rapid, axis, level);
}

Result drill_up(MotionContext& m, BlockWords& block, int axis, double r) {
  const CycleData cycle = m.state.cycle;
  const bool below = goes_to_r_first(m.facts) && cycle.initial < r;
  const bool to_r = below || returns_to_r(m.state);
  const double level = to_r ? r : cycle.initial;
  switch (cycle.cycle) {
    case Meaning::LeftTap:
    case Meaning::Tap:
    case Meaning::Bore:
    case Meaning::BoreDwell:
      return feed_up(m, block, axis, r, level, to_r);
    case Meaning::FineBore: {
      const Axes hole = m.state.work;
      if (auto wrong = shift_tool(m, block, hole, true)) return wrong;
      if (auto wrong = move_axis(m, block, MoveKind::Rapid, axis, level)) return wrong;
      return shift_tool(m, block, hole, false);
    }
    default:
      return move_axis(m, block, MoveKind::Rapid, axis, level);
  }
}

/// Execute G87: down beside the hole, boring upward.
Result bore_shifted(MotionContext& m, BlockWords& block, double r, double z) {
  const int axis = drill_axis(m, m.state.cycle.code);
  const Axes hole = m.state.work;
  const double initial = m.state.cycle.initial;
  if (auto wrong = shift_tool(m, block, hole, true)) return wrong;
  if (auto wrong = move_axis(m, block, MoveKind::Rapid, axis, r)) return wrong;
  if (auto wrong = shift_tool(m, block, hole, false)) return wrong;
  if (auto wrong = move_axis(m, block, MoveKind::Feed, axis, z)) return wrong;
  if (m.state.cycle.p > 0)
    if (auto wrong = add_dwell(m, block, m.state.cycle.p)) return wrong;
  if (auto wrong = shift_tool(m, block, hole, true)) return wrong;
  if (auto wrong = move_axis(m, block, MoveKind::Rapid, axis, initial)) return wrong;
  return shift_tool(m, block, hole, false);
}

/// Drill one hole, the `first` of its block or a repeat: to the place, to R, down, up.
Result drill(MotionContext& m, BlockWords& block, bool first) {
  const int axis = drill_axis(m, m.state.cycle.code);
  const auto [r, z] = hole_levels(m);
  if (goes_to_r_first(m.facts) && r < z) return fault_at('R', Cause::CycleLevels, block);
  if (auto wrong = approach_hole(m, block, axis, r, first)) return wrong;
  if (m.state.cycle.cycle == Meaning::BackBore) return bore_shifted(m, block, r, z);
  if (auto wrong = drill_down(m, block, axis, r, z)) return wrong;
  return drill_up(m, block, axis, r);
}

/// Return whether R names a level between the one where the cycle begins and the hole.
bool has_r_plane(MotionView m) {
  return m.state.cycle.has_r && !m.facts.control->turning.drill_retract.value;
}

/// Leave a hole of a lathe: back to where the cycle began.
Result drill_lathe_up(MotionContext& m, BlockWords& block, int axis, double r) {
  const CycleData& cycle = m.state.cycle;
  const double level = cycle.initial;
  if (cycle.cycle == Meaning::Peck) {
    if (cycle.p > 0)
      if (auto wrong = add_dwell(m, block, cycle.p)) return wrong;
    return move_axis(m, block, MoveKind::Rapid, axis, level);
  }
  Axes out = m.state.work;
  out[static_cast<std::size_t>(axis)] = r;
  Piece back = make_piece(m, block, MoveKind::Feed, out, axis_bit(axis));
  if (cycle.cycle == Meaning::Bore)
    back.state.feed *= m.facts.control->turning.bore_return.value * 0.01;  // [TA 26]
  if (auto wrong = move(m, block, back)) return wrong;
  return has_r_plane(m) ? move_axis(m, block, MoveKind::Rapid, axis, level) : std::nullopt;
}

Result drill_lathe(MotionContext& m, BlockWords& block) {
  CycleData& cycle = m.state.cycle;
  const int axis = drill_axis(m, cycle.code);
  const auto along = static_cast<std::size_t>(axis);
  auto [place, named] = target(m, block);
  const double level = m.state.work[along];
  const double r = has_r_plane(m) ? level + cycle.r * (axis == 0 ? 2 : 1) : level;
  const char increment = axis == 0 ? 'U' : 'W';
  if ((named & axis_bit(axis)) != 0)
    cycle.z = block.words.has(increment) ? r + number(m, block, increment) : place[along];
  cycle.initial = level;
  place[along] = level;
  named &= ~axis_bit(axis);
  if (named != 0)
    if (auto wrong = move(m, block, MoveKind::Rapid, place, named)) return wrong;
  if (has_r_plane(m))
    if (auto wrong = move_axis(m, block, MoveKind::Rapid, axis, r)) return wrong;
  if (auto wrong = drill_down(m, block, axis, r, cycle.z)) return wrong;
  return drill_lathe_up(m, block, axis, r);
}

/// Forget what a cycle keeps, but for its dwell where the control has one for all cycles: a tap
/// without P dwells as the cycle before it. [rs274 2.9]
void forget_cycle(const MotionFacts& facts, MotionState& state) {
  const double dwell = state.cycle.p;
  state.cycle = {};
  if (goes_to_r_first(facts)) state.cycle.p = dwell;
}

}  // namespace

Result enter_cycle(MotionContext& m, BlockWords& block) {
  const Meaning meaning = block.meaning(Group::Cycle);
  m.state.modal[at(Group::Cycle)] = block.code(Group::Cycle);
  m.state.no_motion = meaning == Meaning::CycleOff && m.facts.refuses(Cause::NoMotionCode);
  if (meaning == Meaning::CycleOff) {
    end_cycles(m.facts, m.state);
    return std::nullopt;
  }
  const GCode& code = block.code(Group::Cycle);
  m.state.cycle_before = in_cycle(m.state) ? m.state.cycle.code.code : -1;
  if (!in_cycle(m.state)) {
    forget_cycle(m.facts, m.state);
    m.state.cycle.initial = m.state.work[static_cast<std::size_t>(drill_axis(m, code))];
  }
  m.state.cycle.cycle = meaning;
  m.state.cycle.code = code;
  return std::nullopt;
}

void end_cycles(const MotionFacts& facts, MotionState& state) {
  if (!in_cycle(state)) return;
  state.modal[at(Group::Cycle)] = facts.codes.of(Meaning::CycleOff);
  forget_cycle(facts, state);
}

Result canned_cycle(MotionContext& m, BlockWords& block) {
  constexpr std::uint32_t kOfMills = kAxisWords | bit('R');
  constexpr std::uint32_t kOfLathes =
      kEndWords | bit('C') | bit('U') | bit('V') | bit('W') | bit('H') | bit('R');
  const bool lathe = m.facts.lathe();
  const bool position = (block.words.mask & (lathe ? kOfLathes : kOfMills)) != 0;
  int repeats = 1;
  if (auto wrong = lathe ? Result() : check_rotary(m, block)) return wrong;
  if (position || block.has(Group::Cycle))
    if (auto wrong = cycle_words(m, block, repeats)) return wrong;
  if (!position || repeats == 0) return std::nullopt;
  if (auto wrong = check_tap(m, block)) return wrong;
  if (auto wrong = lathe ? Result() : check_spindle(m, block)) return wrong;
  if (auto wrong = need_feed(m, block, Meaning::Line)) return wrong;
  for (int i = 0; i < repeats; ++i)
    if (auto wrong = lathe ? drill_lathe(m, block) : drill(m, block, i == 0)) return wrong;
  return std::nullopt;
}

}  // namespace cncsub
