// The lathe's cycles of straight cuts: G90 G92 G94, grooving G74 G75.
#include <algorithm>

#include "cncsub/motion_facts.hpp"

namespace cncsub {

/// P and Q of a lathe's cycles: whole numbers count least increments, also where a length would be
/// millimetres.
double Motion::cycle_length(const BlockWords& block, char address) const {
  const double value = raw(block, address);
  const bool whole =
      value == std::floor(value) && (address == 'P' || (block.words.computed & bit(address)) == 0);
  if (!facts_->lathe() || !whole || !facts_->control->cycle_increments.value)
    return number(block, address);
  return value * facts_->increment * (g20() ? 0.1 * kInch : 1);
}

/// G90, G92, G94. A thread of several starts is cut start by start. [TDi 24.9, TA 18: L]
Motion::Result Motion::turning_cycle(BlockWords& block, Meaning meaning) {
  if (meaning == Meaning::TapCycle) return tap_cycle(block);
  const bool starts = meaning == Meaning::ThreadCycle && facts_->control->thread_starts.value;
  if (starts && block.words.has('L')) {
    s_.turn.starts = whole(raw(block, 'L'));
    if (s_.turn.starts < 1 || s_.turn.starts > 999)
      return fault_at('L', Cause::ValueOutOfRange, block, "L of a thread");
  }
  const int count = starts ? s_.turn.starts : 1;
  for (int i = 0; i < count; ++i)
    if (auto wrong = turn_once(block, meaning)) return wrong;
  return std::nullopt;
}

Motion::Result Motion::turn_once(BlockWords& block, Meaning meaning) {
  TurnData& turn = s_.turn;
  std::uint32_t named = 0;
  const Axes end = target(block, named);
  if (named & axis_bit(0)) turn.x = end[0], turn.has_x = true;
  if (named & axis_bit(2)) turn.z = end[2], turn.has_z = true;
  if (block.words.has('R')) turn.r = number(block, 'R');
  if (named == 0 && !block.words.has('R')) return std::nullopt;
  const bool thread = meaning == Meaning::ThreadCycle;
  if (thread) take_run_out(block);
  if (auto wrong = thread ? need_lead(block) : need_feed(block, Meaning::Line)) return wrong;
  const Axes start = s_.work;
  const double x = turn.has_x ? turn.x : start[0], z = turn.has_z ? turn.z : start[2];
  const bool face = meaning == Meaning::FaceCycle;
  // A taper against the cut must not be larger than the cut. [TA 6, 7]
  const double depth = face ? z - start[2] : (x - start[0]) / 2;
  if (turn.r * depth < 0 && std::fabs(turn.r) > std::fabs(depth))
    return fault(face ? Cause::FaceTaper : Cause::Taper, block);
  Axes corner = start;
  corner[0] = x;
  corner[2] = z;
  const int first = face ? 2 : 0, second = face ? 0 : 2;
  const double in = face ? z + turn.r : x + 2 * turn.r;
  if (auto wrong = move_axis(block, MoveKind::Rapid, first, in)) return wrong;
  const double tenths = facts_->control->thread_chamfer.value;
  if (auto wrong = thread ? cut_cycle_thread(block, corner, tenths, start[0])
                          : move(block, MoveKind::Feed, corner, axis_bit(0) | axis_bit(2)))
    return wrong;
  if (auto wrong = move_axis(block, thread ? MoveKind::Rapid : MoveKind::Feed, first,
                             start[static_cast<std::size_t>(first)]))
    return wrong;
  return move_axis(block, MoveKind::Rapid, second, start[static_cast<std::size_t>(second)]);
}

/// In at the lead, out again. [TDi 24.5]
Motion::Result Motion::tap_cycle(BlockWords& block) {
  std::uint32_t named = 0;
  const Axes start = s_.work, end = target(block, named);
  if (named == 0) return std::nullopt;
  if (auto wrong = need_lead(block)) return wrong;
  if (auto wrong = cut_thread(block, end, named, {}, 1, 0)) return wrong;
  return cut_thread(block, start, named, {}, 1, 0);
}

namespace {

bool has_end(const NcWords& w) { return w.has('X') || w.has('Z') || w.has('U') || w.has('W'); }

/// The columns or levels from one value to another in steps; the last takes the rest.
std::vector<double> steps_between(double from, double to, double step) {
  std::vector<double> list{from};
  if (from == to) return list;
  const double way = to > from ? 1 : -1;
  if (step > 0)
    for (double at = from + way * step; (to - at) * way > 1e-9 && list.size() <= kMostMoves;
         at += way * step)
      list.push_back(at);
  list.push_back(to);
  return list;
}

}  // namespace

/// A step of a groove is not below zero; where the control has alarms for them, a peck that is
/// written is above zero.
Motion::Result Motion::check_groove(const BlockWords& block, bool face, double p, double q) const {
  const bool zero_alarms = facts_->refuses(Cause::GrooveStep);
  const auto wrong = [&](char name, double value) {
    return value < 0 || (zero_alarms && value == 0 && block.words.has(name));
  };
  if (wrong('P', p)) return fault_at('P', face ? Cause::GrooveStep : Cause::GrooveP, block);
  if (wrong('Q', q)) return fault_at('Q', face ? Cause::GrooveQ : Cause::GrooveStep, block);
  return std::nullopt;
}

/// G74 pecks along Z and steps along X, G75 the other way around.
Motion::Result Motion::grooving(BlockWords& block, Meaning meaning) {
  const NcWords& w = block.words;
  const bool face = meaning == Meaning::PeckFace;
  const Control& c = *facts_->control;
  const bool one_block = c.one_block_cycles.value && (w.has('I') || w.has('K'));
  if (!has_end(w) && !w.has('P') && !w.has('Q') && !one_block) {
    if (w.has('R')) s_.multiple.retract = number(block, 'R');
    return s_.multiple.retract < 0 ? Result(fault(Cause::GrooveRetract, block)) : std::nullopt;
  }
  std::uint32_t named = 0;
  const Axes start = s_.work, end = target(block, named);
  const int deep = face ? 2 : 0, wide = face ? 0 : 2;
  // Without the axis it pecks along, the cycle is not done. [TDi 23.5; TA 12, 13]
  if ((named & axis_bit(deep)) == 0)
    return !face && facts_->refuses(Cause::GrooveAxis) ? Result(fault(Cause::GrooveAxis, block))
                                                       : std::nullopt;
  if (auto wrong = need_feed(block, Meaning::Line)) return wrong;
  // The older form writes I along X and K along Z, and D for the escape. [K]
  const auto word = [&](char now, char older) {
    if (one_block) return w.has(older) ? number(block, older) : 0.0;
    return w.has(now) ? cycle_length(block, now) : 0.0;
  };
  const double x_share = c.groove_p_diameter.value && !one_block ? 1 : 2;
  const double p = word('P', 'I') * x_share, q = word('Q', 'K');
  const double slip = one_block && w.has('D') ? cycle_length(block, 'D')
                      : w.has('R')            ? number(block, 'R')
                                              : 0;
  if (auto wrong = check_groove(block, face, p, q)) return wrong;
  const double deep_share = deep == 0 ? 2 : 1, wide_share = wide == 0 ? x_share : 1;
  const double retract = s_.multiple.retract * deep_share;
  const double from = start[static_cast<std::size_t>(deep)],
               to = end[static_cast<std::size_t>(deep)];
  const double way = to < from ? -1 : 1;
  const double first = start[static_cast<std::size_t>(wide)],
               last = end[static_cast<std::size_t>(wide)];
  if (slip < 0 && first != last && facts_->refuses(Cause::GrooveEscape))
    return fault(Cause::GrooveEscape, block);
  const double escape = (first == last ? slip : std::fabs(slip)) * wide_share;
  const std::vector<double> levels = steps_between(from, to, face ? q : p);
  bool begun = false;
  for (const double column : steps_between(first, last, face ? p : q)) {
    if (begun)
      if (auto wrong = move_axis(block, MoveKind::Rapid, wide, column)) return wrong;
    for (std::size_t i = 1; i < levels.size(); ++i) {
      if (auto wrong = move_axis(block, MoveKind::Feed, deep, levels[i])) return wrong;
      if (i + 1 < levels.size())
        if (auto wrong = move_axis(block, MoveKind::Rapid, deep, levels[i] - way * retract))
          return wrong;
    }
    if (escape != 0) {
      const double back = first == last ? 1 : (last > first ? -1 : 1);
      if (auto wrong = move_axis(block, MoveKind::Rapid, wide, column + back * escape))
        return wrong;
    }
    if (auto wrong = move_axis(block, MoveKind::Rapid, deep, from)) return wrong;
    begun = true;
  }
  return first == last && escape == 0 ? std::nullopt
                                      : move_axis(block, MoveKind::Rapid, wide, first);
}

}  // namespace cncsub
