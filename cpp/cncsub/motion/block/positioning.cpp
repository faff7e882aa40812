// Axes that go beside the path, each at its own feed.
#include <algorithm>
#include <cmath>

#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

constexpr std::size_t kStraight = 3;  // axes that may go so
constexpr std::string_view kFeedNames = "IJK";

/// Axes on their way: how far each goes, how fast, and how long.
struct Way {
  std::array<double, kStraight> length{}, speed{}, minutes{};

  /// Return how far an axis has come after so long a time.
  double at(std::size_t axis, double time) const {
    return time >= minutes[axis] ? length[axis] : std::copysign(speed[axis] * time, length[axis]);
  }
};

/// Read the feeds of axes, which stay in force. 0 is that of the axis itself. [MD840, MD 32060]
Result read_feeds(MotionContext& m, const BlockWords& block) {
  for (std::size_t i = 0; i < kStraight; ++i) {
    if (!block.words.has(kFeedNames[i])) continue;
    const double feed = block.words[kFeedNames[i]] * m.state.feed_unit;
    if (feed < 0) return fault_at(kFeedNames[i], Cause::AxisFeedNegative, block);
    m.state.axis_feeds[i] = feed;
  }
  return std::nullopt;
}

Way way_of(MotionView m, const Axes& from, const Axes& end) {
  Way way;
  for (std::size_t i = 0; i < kStraight; ++i) {
    const int axis = static_cast<int>(i);
    way.length[i] = (end[i] - from[i]) * m.facts.share(axis);
    way.speed[i] = m.state.axis_feeds[i] > 0 ? m.state.axis_feeds[i] : m.facts.rapid[i];
    way.minutes[i] = way.speed[i] > 0 ? std::fabs(way.length[i]) / way.speed[i] : 0;
  }
  return way;
}

}  // namespace

std::vector<BesideMove> moves_beside_path(MotionView m, const Axes& from, const Axes& end) {
  const Way way = way_of(m, from, end);
  std::array<double, kStraight> times = way.minutes;
  std::sort(times.begin(), times.end());
  std::vector<BesideMove> moves;
  double before = 0;
  for (const double time : times) {
    if (time <= before) continue;
    BesideMove move{.end = from};
    double square = 0;  // of the speed
    for (std::size_t i = 0; i < kStraight; ++i) {
      const int axis = static_cast<int>(i);
      move.end[i] =
          time >= way.minutes[i] ? end[i] : from[i] + way.at(i, time) / m.facts.share(axis);
      if (way.minutes[i] <= before) continue;
      square += way.speed[i] * way.speed[i];
      move.axes |= axis_bit(axis);
    }
    move.feed = std::sqrt(square);
    moves.push_back(move);
    before = time;
  }
  return moves;
}

Result position_axes(MotionContext& m, BlockWords& block) {
  block.consumed = true;
  if (auto wrong = read_feeds(m, block)) return wrong;
  if ((block.words.mask & kAxisWords) == 0) return std::nullopt;  // FA alone
  if (moves_wait(m.state) || compensating(m.state) || is_turned(m.state))
    return fault(Cause::CodeNotComputed, block,
                 "cncsub computes axes beside the path neither in a frame that turns, scales or "
                 "mirrors nor while a radius is compensated or a corner waits");
  const auto [end, named] = target(m, block);
  for (const BesideMove& of : moves_beside_path(m, m.state.work, end)) {
    Piece piece = make_piece(m, block, MoveKind::Feed, of.end, of.axes & named);
    piece.state.feed = of.feed;
    piece.state.feed_mode = FeedMode::PerMinute;
    if (auto wrong = move(m, block, piece)) return wrong;
  }
  return std::nullopt;
}

}  // namespace cncsub
