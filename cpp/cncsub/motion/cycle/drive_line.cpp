// G76 of a mill: a thread in passes beside a drive line, which leads from the tool to Z.
#include "cncsub/motion/cycle/cycles.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

/// The words of the block. [LC g-code, G76]
struct DriveLine {
  Axes start{}, end{};
  double side = 1;  // the side of X on which the thread is
  double peak = 0, cut = 0, height = 0;
  double pitch = 0, angle = 0, degression = 1;
  double taper = 0;  // along the drive line, with the sign of the move back
  bool at_begin = false, at_end = false;
  int springs = 0;

  double last() const { return peak + height; }
  /// Return how far along the flank a pass of this depth is moved.
  double along(double depth) const { return (depth - peak) * std::tan(angle); }
};

Result read(MotionContext& m, BlockWords& block, const Axes& end, DriveLine& t) {
  const NcWords& w = block.words;
  if (!w.has('P')) return fault_at('P', Cause::ThreadLead, block);
  for (const char name : std::string_view("IJK"))
    if (!w.has(name)) return fault(Cause::ThreadHeight, block);
  const double share = m.state.diameter ? 0.5 : 1;
  const double i = number(m, block, 'I') * share;
  t.cut = number(m, block, 'J') * share;
  t.height = number(m, block, 'K') * share;
  if (i == 0) return fault_at('I', Cause::ThreadTravel, block);
  if (t.cut <= 0) return fault_at('J', Cause::ThreadCut, block);
  if (t.height <= t.cut) return fault_at('K', Cause::ThreadHeightValue, block);
  t.start = m.state.work;
  t.end = end;
  t.side = i > 0 ? 1 : -1;
  t.peak = std::fabs(i);
  t.pitch = number(m, block, 'P');
  const double back = end[2] > t.start[2] ? -1 : 1;
  t.angle = w.has('Q') ? back * w['Q'] * kPi / 180 : 0;
  t.springs = w.has('H') ? std::clamp(whole(w['H']), 0, static_cast<int>(kMostMoves)) : 0;
  t.degression = w.has('R') ? std::max(1.0, w['R']) : 1;
  t.taper = w.has('E') ? back * std::max(0.0, number(m, block, 'E')) : 0;
  const int tapers = w.has('L') ? whole(w['L']) : 0;
  t.at_begin = t.taper != 0 && (tapers & 1) != 0;
  t.at_end = t.taper != 0 && (tapers & 2) != 0;
  return std::nullopt;
}

/// The moves of one pass.
struct Pass {
  MotionContext& m;
  BlockWords& block;
  const DriveLine& t;

  Result go(bool cuts, bool tapers, double x, double z) const {
    Axes to = t.start;
    to[0] = t.start[0] + t.side * x;
    to[2] = z;
    if (!cuts) return move(m, block, MoveKind::Rapid, to, axis_bit(0) | axis_bit(2));
    Piece piece = make_piece(m, block, MoveKind::Thread, to, axis_bit(0) | axis_bit(2));
    const double flat = std::fabs(t.taper);
    piece.state.feed = tapers ? t.pitch * std::hypot(flat, t.height) / flat : t.pitch;
    piece.state.feed_mode = FeedMode::PerRevolution;
    return move(m, block, piece);
  }

  Result cut(double depth) const {
    const double first = t.start[2] - t.along(depth);
    const double last = t.end[2] + t.height * std::tan(t.angle) - t.along(depth);
    const double out = depth - t.last(), above = depth - t.height;
    if (auto wrong = go(false, false, out, first)) return wrong;
    if (auto wrong = go(t.at_begin, true, t.at_begin ? above : depth, first)) return wrong;
    if (t.at_begin)
      if (auto wrong = go(true, true, depth, first - t.taper)) return wrong;
    if (auto wrong = go(true, false, depth, last + (t.at_end ? t.taper : 0))) return wrong;
    if (t.at_end)
      if (auto wrong = go(true, true, above, last)) return wrong;
    return go(false, false, out, last);
  }
};

}  // namespace

Result drive_line_thread(MotionContext& m, BlockWords& block) {
  const auto [end, named] = end_point(m, block);
  if (named == 0) return std::nullopt;
  if (compensating(m.state)) return fault(Cause::CompensationCycle, block);
  if (m.facts.refuses(Cause::SpindleStands) && !m.state.turns)
    return fault(Cause::SpindleStands, block);
  DriveLine thread;
  if (auto wrong = read(m, block, end, thread)) return wrong;
  block.cycle = true;
  const Pass pass{m, block, thread};
  double count = 1;
  for (double depth = thread.peak + thread.cut; depth < thread.last();
       depth = thread.peak + thread.cut * std::pow(++count, 1 / thread.degression))
    if (auto wrong = pass.cut(depth)) return wrong;
  for (int i = 0; i <= thread.springs; ++i)
    if (auto wrong = pass.cut(thread.last())) return wrong;
  return move(m, block, MoveKind::Rapid, end, named | axis_bit(0) | axis_bit(2));
}

}  // namespace cncsub
