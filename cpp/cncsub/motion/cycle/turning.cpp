// Straight-cut cycles of lathes: G90 G92 G94, grooving G74 G75.
#include <algorithm>

#include "cncsub/motion/cycle/cycles.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

/// Refuse a taper against the cut that is larger than the cut. [TA 6, 7]
Result check_taper(const TurnData& turn, double depth, bool face, const BlockWords& block) {
  if (turn.r * depth >= 0 || std::fabs(turn.r) <= std::fabs(depth)) return std::nullopt;
  return fault_at('R', face ? Cause::FaceTaper : Cause::Taper, block);
}

Result turn_once(MotionContext& m, BlockWords& block, Meaning meaning) {
  TurnData& turn = m.state.turn;
  const auto [end, named] = target(m, block);
  if (named & axis_bit(0)) turn.x = end[0], turn.has_x = true;
  if (named & axis_bit(2)) turn.z = end[2], turn.has_z = true;
  if (block.words.has('R')) turn.r = number(m, block, 'R');
  if (named == 0 && !block.words.has('R')) return std::nullopt;
  const bool thread = meaning == Meaning::ThreadCycle;
  if (auto wrong = thread ? take_run_out(m, block, true) : Result()) return wrong;
  if (auto wrong = thread ? need_lead(m, block) : need_feed(m, block, Meaning::Line)) return wrong;
  const Axes start = m.state.work;
  const double x = turn.has_x ? turn.x : start[0], z = turn.has_z ? turn.z : start[2];
  const bool face = meaning == Meaning::FaceCycle;
  const double depth = face ? z - start[2] : (x - start[0]) / 2;
  if (auto wrong = check_taper(turn, depth, face, block)) return wrong;
  Axes corner = start;
  corner[0] = x;
  corner[2] = z;
  const int first = face ? 2 : 0, second = face ? 0 : 2;
  const double in = face ? z + turn.r : x + 2 * turn.r;
  if (auto wrong = move_axis(m, block, MoveKind::Rapid, first, in)) return wrong;
  const double tenths = m.facts.control->turning.thread_chamfer.value;
  if (auto wrong = thread ? cut_cycle_thread(m, block, corner, tenths, start[0])
                          : move(m, block, MoveKind::Feed, corner, axis_bit(0) | axis_bit(2)))
    return wrong;
  if (auto wrong = move_axis(m, block, thread ? MoveKind::Rapid : MoveKind::Feed, first,
                             start[static_cast<std::size_t>(first)]))
    return wrong;
  return move_axis(m, block, MoveKind::Rapid, second, start[static_cast<std::size_t>(second)]);
}

/// Cut in at the lead, and out again. [TDi 24.5]
Result tap_cycle(MotionContext& m, BlockWords& block) {
  const Axes start = m.state.work;
  const auto [end, named] = target(m, block);
  if (named == 0) return std::nullopt;
  if (auto wrong = need_lead(m, block)) return wrong;
  if (auto wrong = cut_thread(m, block, end, named, {}, 1, 0)) return wrong;
  return cut_thread(m, block, start, named, {}, 1, 0);
}

bool has_end(const NcWords& w) { return w.has('X') || w.has('Z') || w.has('U') || w.has('W'); }

/// Return the columns or levels from one value to another in steps; the last step takes the rest.
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

/// Check the steps of a groove. None is below zero; where the control has alarms for them, a
/// written peck is above zero.
Result check_groove(MotionView m, const BlockWords& block, bool face, double p, double q) {
  const bool zero_alarms = m.facts.refuses(Cause::GrooveStep);
  const auto wrong = [&](char name, double value) {
    return value < 0 || (zero_alarms && value == 0 && block.words.has(name));
  };
  if (wrong('P', p)) return fault_at('P', face ? Cause::GrooveStep : Cause::GrooveP, block);
  if (wrong('Q', q)) return fault_at('Q', face ? Cause::GrooveQ : Cause::GrooveStep, block);
  return std::nullopt;
}

/// A groove, cut by pecking on one axis and stepping on the other.
struct Groove {
  int deep = 0, wide = 0;               // the axes
  std::vector<double> levels, columns;  // from the start to the end
  double retract = 0;                   // after a peck, away from the end
  double escape = 0;                    // to the side at the bottom
};

/// Peck down one column, and out again.
Result cut_column(MotionContext& m, BlockWords& block, const Groove& groove, double column) {
  const std::vector<double>& levels = groove.levels;
  for (std::size_t i = 1; i < levels.size(); ++i) {
    if (auto wrong = move_axis(m, block, MoveKind::Feed, groove.deep, levels[i])) return wrong;
    if (i + 1 == levels.size()) break;
    if (auto wrong = move_axis(m, block, MoveKind::Rapid, groove.deep, levels[i] + groove.retract))
      return wrong;
  }
  if (groove.escape != 0)
    if (auto wrong = move_axis(m, block, MoveKind::Rapid, groove.wide, column + groove.escape))
      return wrong;
  return move_axis(m, block, MoveKind::Rapid, groove.deep, levels.front());
}

Result cut_groove(MotionContext& m, BlockWords& block, const Groove& groove) {
  const std::vector<double>& columns = groove.columns;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (i > 0)
      if (auto wrong = move_axis(m, block, MoveKind::Rapid, groove.wide, columns[i])) return wrong;
    if (auto wrong = cut_column(m, block, groove, columns[i])) return wrong;
  }
  if (columns.size() == 1 && groove.escape == 0) return std::nullopt;
  return move_axis(m, block, MoveKind::Rapid, groove.wide, columns.front());
}

/// The steps of a groove as written: along X and along Z, and the escape. The older form writes I
/// along X and K along Z, and D for the escape. [general knowledge]
struct GrooveWords {
  double p = 0, q = 0, slip = 0;
  double x_share = 1;  // of P and I: 2 where they are radius values

  GrooveWords(MotionView m, const BlockWords& block, bool one_block)
      : x_share(m.facts.control->turning.groove_p_diameter.value && !one_block ? 1 : 2) {
    const NcWords& w = block.words;
    if (one_block) {
      p = (w.has('I') ? number(m, block, 'I') : 0) * x_share;
      q = w.has('K') ? number(m, block, 'K') : 0;
    } else {
      p = (w.has('P') ? cycle_length(m, block, 'P') : 0) * x_share;
      q = w.has('Q') ? cycle_length(m, block, 'Q') : 0;
    }
    if (one_block && w.has('D'))
      slip = cycle_length(m, block, 'D');
    else if (w.has('R'))
      slip = number(m, block, 'R');
  }
};

/// Take over the first of two blocks: how far a peck draws back.
Result set_peck_retract(MotionContext& m, const BlockWords& block) {
  double& retract = m.state.multiple.retract;
  if (block.words.has('R')) retract = number(m, block, 'R');
  return retract < 0 ? Result(fault_at('R', Cause::GrooveRetract, block)) : std::nullopt;
}

Groove groove_of(MotionView m, const GrooveWords& words, bool face, const Axes& end) {
  Groove groove;
  groove.deep = face ? 2 : 0, groove.wide = face ? 0 : 2;
  const auto deep = static_cast<std::size_t>(groove.deep),
             wide = static_cast<std::size_t>(groove.wide);
  const Axes& start = m.state.work;
  const double slip = words.slip * (face ? words.x_share : 1);
  groove.escape = start[wide] == end[wide]  ? slip
                  : start[wide] < end[wide] ? -std::fabs(slip)
                                            : std::fabs(slip);
  groove.retract = m.state.multiple.retract * (face ? 1 : 2) * (end[deep] < start[deep] ? 1 : -1);
  groove.levels = steps_between(start[deep], end[deep], face ? words.q : words.p);
  groove.columns = steps_between(start[wide], end[wide], face ? words.p : words.q);
  return groove;
}

/// Return whether a word of a cycle is written as increments: without a point, as far as that is
/// known, or computed at an address that takes none.
bool counts_increments(MotionView m, const BlockWords& block, char address) {
  const NcWords& w = block.words;
  if ((w.computed & bit(address)) != 0) return address == 'P';
  const bool point_known =
      address == 'Q' && m.facts.control->reading.whole_numbers.value == WholeNumbers::Increments;
  return point_known ? (w.whole & bit('Q')) != 0 : w[address] == std::floor(w[address]);
}

}  // namespace

double cycle_length(MotionView m, const BlockWords& block, char address) {
  const double value = block.words[address];
  const bool computed = (block.words.computed & bit(address)) != 0;
  if (!m.facts.lathe() || !counts_increments(m, block, address) ||
      m.facts.control->turning.cycle_unit.value != CycleUnit::Increments)
    return number(m, block, address);
  return (computed ? std::round(value) : value) * m.facts.increment *
         (g20(m.state) ? 0.1 * kInch : 1);
}

Result turning_cycle(MotionContext& m, BlockWords& block, Meaning meaning) {
  if (meaning == Meaning::TapCycle) return tap_cycle(m, block);
  const bool starts =
      meaning == Meaning::ThreadCycle && m.facts.control->turning.thread_starts.value;
  if (starts && block.words.has('L')) {
    m.state.turn.starts = whole(block.words['L']);
    if (m.state.turn.starts < 1 || m.state.turn.starts > 999)
      return fault_at('L', Cause::ValueOutOfRange, block,
                      "L, the number of starts of the thread, must be 1 to 999");
  }
  const int count = starts ? m.state.turn.starts : 1;
  for (int i = 0; i < count; ++i)
    if (auto wrong = turn_once(m, block, meaning)) return wrong;
  return std::nullopt;
}

Result grooving(MotionContext& m, BlockWords& block, Meaning meaning) {
  const NcWords& w = block.words;
  const bool face = meaning == Meaning::PeckFace;
  const bool one_block =
      m.facts.control->turning.one_block_cycles.value && (w.has('I') || w.has('K'));
  if (!has_end(w) && !w.has('P') && !w.has('Q') && !one_block) return set_peck_retract(m, block);
  const auto [end, named] = target(m, block);
  // The cycle is not done without the axis along which it pecks. [TDi 23.5; TA 12, 13]
  if ((named & axis_bit(face ? 2 : 0)) == 0)
    return !face && m.facts.refuses(Cause::GrooveAxis) ? Result(fault(Cause::GrooveAxis, block))
                                                       : std::nullopt;
  if (auto wrong = need_feed(m, block, Meaning::Line)) return wrong;
  const GrooveWords words(m, block, one_block);
  if (auto wrong = check_groove(m, block, face, words.p, words.q)) return wrong;
  const std::size_t wide = face ? 0 : 2;
  if (words.slip < 0 && m.state.work[wide] != end[wide] && m.facts.refuses(Cause::GrooveEscape))
    return fault_at('R', Cause::GrooveEscape, block);
  return cut_groove(m, block, groove_of(m, words, face, end));
}

}  // namespace cncsub
