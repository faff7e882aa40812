// The length of all moves, and the box that they lie in: computed piece by piece by several
// threads, and put together in the order of the pieces.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "cncsub/trace/move_walk.hpp"
#include "cncsub/trace/parts.hpp"

namespace cncsub {

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = 3.14159265358979323846;

std::size_t pieces_of(std::size_t rows) { return (rows + kPieceRows - 1) / kPieceRows; }

/// Return a box that nothing is in yet.
Moves::Bounds nowhere() {
  Moves::Bounds box;
  box.low.fill(std::numeric_limits<double>::infinity());
  box.high.fill(-std::numeric_limits<double>::infinity());
  return box;
}

void widen(Moves::Bounds& box, std::size_t axis, const double* values, std::size_t count) {
  double low = box.low[axis], high = box.high[axis];
  for (std::size_t i = 0; i < count; ++i) {
    low = values[i] < low ? values[i] : low;
    high = values[i] > high ? values[i] : high;
  }
  box.low[axis] = low, box.high[axis] = high;
}

/// Widen a box by the quadrant points that an arc passes. `from` is where it starts, in its own
/// work coordinates.
void widen_by_arc(const MoveRow& row, const Axes& from, std::uint32_t diameters,
                  Moves::Bounds& box) {
  const PlaneAxes plane = arc_axes(*row.state);
  const auto a = static_cast<std::size_t>(plane.a), b = static_cast<std::size_t>(plane.b);
  const auto share = [&](std::size_t axis) { return (diameters >> axis & 1) != 0 ? 0.5 : 1.0; };
  const double ca = row.centre[centre_place(plane.a)], cb = row.centre[centre_place(plane.b)];
  const auto part = [&](const Axes& p) {
    return std::array{(p[a] - ca) * share(a), (p[b] - cb) * share(b)};
  };
  const auto first = part(from), last = part(row.point);
  const double start = std::hypot(first[0], first[1]), end = std::hypot(last[0], last[1]);
  const double angle = std::atan2(first[1], first[0]);
  double turn = std::atan2(last[1], last[0]) - angle;
  if (row.kind == MoveKind::Cw)
    turn = turn > -1e-9 ? turn - 2 * kPi : turn;
  else
    turn = turn < 1e-9 ? turn + 2 * kPi : turn;
  for (int quarter = -6; quarter <= 6; ++quarter) {
    const double t = quarter * kPi / 2, done = (t - angle) / turn;
    const bool passed = done >= 0 && done <= 1;
    if (!passed) continue;
    const double radius = start + (end - start) * done;
    const double pa = ca + radius * std::cos(t) / share(a),
                 pb = cb + radius * std::sin(t) / share(b);
    widen(box, a, &pa, 1);
    widen(box, b, &pb, 1);
  }
}

}  // namespace

double Moves::length(InterruptCheck* interrupt) const {
  std::vector<double> sums(pieces_of(rows_));
  in_parts(rows_, interrupt, [&](std::size_t first, std::size_t last) {
    Walk walk(*this);
    walk.seek(first);
    double sum = 0;
    for (std::size_t i = first; i < last; ++i) sum += walk.next<false>(i).length;
    sums[first / kPieceRows] = sum;
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

void Moves::Walk::widen_by_ends(std::size_t first, std::size_t last, Bounds& box) const {
  while (first < last) {
    const Chunk& chunk = moves_.chunks_[first / Chunk::kRows];
    const std::size_t at = first % Chunk::kRows, count = std::min(Chunk::kRows - at, last - first);
    widen(box, 0, chunk.x + at, count);
    widen(box, 1, chunk.y + at, count);
    widen(box, 2, chunk.z + at, count);
    first += count;
  }
}

void Moves::Walk::widen_by_extras(std::size_t first, std::size_t last, Bounds& box) const {
  for (const Extra& extra : moves_.extras_) {
    const auto axis = static_cast<std::size_t>(extra.axis);
    // Before the axis has a column it stands, in the work coordinates of each row.
    for (std::size_t i = first; i < std::min(last, extra.first); ++i) {
      const std::uint32_t state = moves_.chunks_[i / Chunk::kRows].state(i % Chunk::kRows);
      const Axes& offset = moves_.offsets_[moves_.states_[state].offset];
      const double still = moves_.start_[axis] - offset[axis];
      widen(box, axis, &still, 1);
    }
    if (last <= extra.first) continue;
    extra.values.for_each_run(
        std::max(first, extra.first) - extra.first, last - extra.first,
        [&](const double* values, std::size_t count) { widen(box, axis, values, count); });
  }
}

/// Widen a box by arcs. An arc begins where the row before ends, without a radius offset.
void Moves::Walk::widen_by_arcs(std::size_t first, std::size_t last, Bounds& box) {
  const std::size_t arc = find_row(moves_.arcs_, first);
  if (arc == moves_.arcs_.size() || moves_.arcs_[arc].row >= last) return;
  first = moves_.arcs_[arc].row;
  Axes base = moves_.start_;
  const auto offset = [this](const MoveRow& row) -> const Axes& {
    return moves_.offsets_[row.state->offset];
  };
  const std::size_t before = first == 0 ? 0 : first - 1;
  seek(before);
  Along<Leap> leaps(moves_.leaps_);
  leaps.seek(before);
  for (std::size_t i = before; i < last; ++i) {
    if (const Leap* const leap = leaps.at(i)) base = leap->from;
    const MoveRow row = next<false>(i);
    if (i >= first && (row.kind == MoveKind::Cw || row.kind == MoveKind::Ccw)) {
      Axes from = turned_by(-row.state->turned, base);
      for (std::size_t axis = 0; axis < from.size(); ++axis) from[axis] -= offset(row)[axis];
      widen_by_arc(row, from, moves_.diameters_, box);
    }
    for (std::size_t axis = 0; axis < base.size(); ++axis)
      base[axis] = row.point[axis] + offset(row)[axis];
    base = turned_by(row.state->turned, base);
  }
}

Moves::Bounds Moves::bounds(InterruptCheck* interrupt) const {
  std::vector<Bounds> boxes(pieces_of(rows_), nowhere());
  in_parts(rows_, interrupt, [&](std::size_t first, std::size_t last) {
    Walk walk(*this);
    Bounds& box = boxes[first / kPieceRows];
    walk.widen_by_ends(first, last, box);
    walk.widen_by_extras(first, last, box);
    walk.widen_by_arcs(first, last, box);
  });
  Bounds all = nowhere();
  for (const Bounds& box : boxes) {
    for (std::size_t i = 0; i < all.low.size(); ++i) {
      all.low[i] = std::min(all.low[i], box.low[i]);
      all.high[i] = std::max(all.high[i], box.high[i]);
    }
  }
  for (std::size_t i = 0; i < all.low.size(); ++i)
    if (rows_ == 0 || (used_ >> i & 1) == 0) all.low[i] = all.high[i] = kNone;
  return all;
}

}  // namespace cncsub
