#include "cncsub/trace/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cncsub/trace/move_walk.hpp"
#include "cncsub/trace/parts.hpp"

namespace cncsub {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kQuarter = kPi / 2;  // the widest step of an arc
constexpr double kSamePoint = 1e-9;   // mm: what rounding leaves

using Point = MoveBegin::Point;

/// A move as a curve: mm, radii on every axis.
struct Curve {
  Point from{}, to{};
  bool begins = false;  // it does not begin where the one before ended
  std::size_t steps = 1;
  // Of an arc.
  std::size_t a = 0, b = 1;
  Point centre{};
  double angle = 0, turn = 0;  // where it starts, and how far it goes; plus = counter-clockwise
  double radius = 0, growth = 0;
  double turned = 0;  // radians by which the curve is rotated about Z, last of all

  Point at(std::size_t step) const { return turned_by(turned, before_turning(step)); }
  Point first() const { return turned_by(turned, from); }

 private:
  Point before_turning(std::size_t step) const {
    if (step >= steps) return to;
    const double part = static_cast<double>(step) / static_cast<double>(steps);
    Point point{};
    for (std::size_t i = 0; i < 3; ++i) point[i] = from[i] + (to[i] - from[i]) * part;
    const double now = radius + growth * part, towards = angle + turn * part;
    point[a] = centre[a] + now * std::cos(towards);
    point[b] = centre[b] + now * std::sin(towards);
    return point;
  }
};

/// Return the angle that a move runs through between two directions. Of those that differ by whole
/// turns it is the one nearest to `known`, the size of the angle; where that is NaN, up to one
/// turn.
double turn_between(double from, double to, bool clockwise, double known) {
  double turn = std::fmod(clockwise ? from - to : to - from, 2 * kPi);
  if (turn < 0) turn += 2 * kPi;
  if (std::isnan(known)) known = turn < kSamePoint ? 2 * kPi : turn;
  turn += 2 * kPi * std::round((known - turn) / (2 * kPi));
  return clockwise ? -turn : turn;
}

/// Return the size of the angle that the tool turns by, from its path; NaN where it stands.
double size_of_turn(double in_plane, double first, double last) {
  const double mean = (first + last) / 2, growth = last - first;
  if (mean <= kSamePoint) return std::numeric_limits<double>::quiet_NaN();
  return std::sqrt(std::max(0.0, in_plane * in_plane - growth * growth)) / mean;
}

/// Return the number of steps of an arc. The second derivative of the curve by its angle is no
/// longer than `bend`, and a chord leaves a curve by at most an eighth of it times the step
/// squared.
std::size_t steps_of(const Curve& arc, double tolerance) {
  const double size = std::fabs(arc.turn);
  if (size == 0) return 1;
  const double longest = std::max(arc.radius, arc.radius + arc.growth);
  const double bend = std::hypot(longest, 2 * arc.growth / size);
  const double step = std::min(kQuarter, std::sqrt(8 * tolerance / bend));
  const double steps = std::ceil(size / step);
  return steps < static_cast<double>(Sampler::kMostPoints)
             ? std::max<std::size_t>(1, static_cast<std::size_t>(steps))
             : Sampler::kMostPoints;
}

/// The curves of the rows, for one kind of path.
class Follower {
 public:
  Follower(PathFrame frame, double tolerance, std::uint32_t diameters)
      : frame_(frame), tolerance_(tolerance) {
    for (std::size_t i = 0; i < 3; ++i) share_[i] = (diameters >> i & 1) != 0 ? 0.5 : 1.0;
  }

  Curve next(const MoveRow& row, const MoveBegin& begin) {
    Curve curve;
    const auto of_frame = [&](const auto& point) {
      return turned_by(-begin.turned, Point{point[0], point[1], point[2]});
    };
    const Point start = of_frame(begin.machine), end = of_frame(row.machine);
    if (frame_ == PathFrame::Machine) curve.turned = begin.turned;
    for (std::size_t i = 0; i < 3; ++i) {
      const double back = frame_ == PathFrame::Tool ? begin.offset[i] : 0;
      const bool work = frame_ == PathFrame::Work;
      curve.from[i] = (work ? begin.point[i] : start[i] - back) * share_[i];
      curve.to[i] = (work ? row.point[i] : end[i] - back) * share_[i];
      curve.centre[i] = (work ? row.centre[i] : begin.centre[i] - back) * share_[i];
    }
    curve.begins = !known_ || leaps(curve.first());
    if (row.kind == MoveKind::Cw || row.kind == MoveKind::Ccw) bend(curve, row, begin);
    last_ = curve.at(curve.steps);
    known_ = true;
    return curve;
  }

 private:
  bool leaps(const Point& to) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (std::fabs(to[i] - last_[i]) > kSamePoint * (1 + std::fabs(to[i]))) return true;
    return false;
  }

  struct Polar {
    double radius, angle;
  };
  Polar polar(const Point& point, const Point& centre, const PlaneAxes& plane) const {
    const auto a = static_cast<std::size_t>(plane.a), b = static_cast<std::size_t>(plane.b);
    const double x = point[a] - centre[a], y = point[b] - centre[b];
    return {std::hypot(x, y), std::atan2(y, x)};
  }

  void bend(Curve& curve, const MoveRow& row, const MoveBegin& begin) const {
    if (row.state->parallel != 0) return;  // X, Y and Z do not make it alone
    const PlaneAxes plane = plane_axes(row.state->plane);
    curve.a = static_cast<std::size_t>(plane.a);
    curve.b = static_cast<std::size_t>(plane.b);
    const Polar first = polar(curve.from, curve.centre, plane);
    const Polar last = polar(curve.to, curve.centre, plane);
    if (!std::isfinite(first.radius) || !std::isfinite(last.radius)) return;
    curve.angle = first.angle;
    curve.radius = first.radius;
    curve.growth = last.radius - first.radius;
    curve.turn = turn_between(first.angle, last.angle, row.kind == MoveKind::Cw,
                              tool_turn(row, begin, plane));
    curve.steps = steps_of(curve, tolerance_);
  }

  double tool_turn(const MoveRow& row, const MoveBegin& begin, const PlaneAxes& plane) const {
    Point from{}, to{}, centre{};
    const Point start = turned_by(-begin.turned, begin.machine);
    const Point end =
        turned_by(-begin.turned, Point{row.machine[0], row.machine[1], row.machine[2]});
    for (std::size_t i = 0; i < 3; ++i) {
      from[i] = start[i] * share_[i];
      to[i] = end[i] * share_[i];
      centre[i] = begin.centre[i] * share_[i];
    }
    return size_of_turn(begin.in_plane, polar(from, centre, plane).radius,
                        polar(to, centre, plane).radius);
  }

  PathFrame frame_;
  double tolerance_;
  Point share_{};
  Point last_{};
  bool known_ = false;
};

}  // namespace

Sampler::Sampler(const Moves& moves, PathFrame frame, double tolerance, std::size_t first,
                 std::size_t last)
    : moves_(moves),
      frame_(frame),
      tolerance_(tolerance),
      first_(std::min(first, moves.size())),
      last_(std::min(std::max(first, last), moves.size())) {}

/// Call `use(index, curve, row)` for rows [first, last) of the table.
template <bool timed, class Use>
void Sampler::each_curve(std::size_t first, std::size_t last, Use&& use) const {
  const MoveReader reader(moves_);
  Follower follow(frame_, tolerance_, reader.diameters());
  const std::size_t known =
      first > first_ ? first - 1 : first;  // a leap is seen from the row before
  const auto one = [&](std::size_t i, const MoveRow& row, const MoveBegin& begin) {
    const Curve curve = follow.next(row, begin);
    if (i >= first) use(i, curve, row);
  };
  reader.each<timed>(known, last, one);
}

std::size_t Sampler::count(InterruptCheck* interrupt) {
  const std::size_t rows = last_ - first_;
  begins_.assign((rows + kPieceRows - 1) / kPieceRows + 1, 0);
  in_parts(rows, interrupt, [&](std::size_t first, std::size_t last) {
    std::size_t points = 0;
    each_curve(first_ + first, first_ + last, [&](std::size_t, const Curve& curve, const MoveRow&) {
      points = std::min(kMostPoints, points + curve.steps + (curve.begins ? 1 : 0));
    });
    begins_[first / kPieceRows + 1] = points;
  });
  for (std::size_t i = 1; i < begins_.size(); ++i)
    begins_[i] = std::min(kMostPoints, begins_[i] + begins_[i - 1]);
  return begins_.back();
}

void Sampler::write(const PolylinePlaces& places, InterruptCheck* interrupt) const {
  in_parts(last_ - first_, interrupt, [&](std::size_t first, std::size_t last) {
    std::size_t place = begins_[first / kPieceRows];
    const auto put = [&](const Point& point, std::size_t row, bool begins) {
      places.x[place] = point[0];
      places.y[place] = point[1];
      places.z[place] = point[2];
      places.row[place] = static_cast<std::int64_t>(row);
      places.begins[place++] = begins ? 1 : 0;
    };
    const auto one = [&](std::size_t i, const Curve& curve, const MoveRow&) {
      if (curve.begins) put(curve.first(), i, true);
      for (std::size_t step = 1; step <= curve.steps; ++step) put(curve.at(step), i, false);
    };
    each_curve(first_ + first, first_ + last, one);
  });
}

namespace {

/// Append a point to an outline, of one piece of the rows or of all.
void put(Outline& outline, const Point& point, std::size_t row, double time, std::int32_t key) {
  outline.x.push_back(point[0]);
  outline.y.push_back(point[1]);
  outline.z.push_back(point[2]);
  outline.time.push_back(time);
  outline.row.push_back(static_cast<std::uint32_t>(row));
  outline.key.push_back(key);
  if (key < 0) ++outline.begins;
  ++outline.points;
}

/// Remove the points that are not needed.
void thin_out(Outline& outline, double tolerance) {
  if (outline.x.empty()) return;
  std::vector<std::uint8_t> keep(outline.x.size());
  thin_piece(outline.x.data(), outline.y.data(), outline.z.data(), outline.key.data(), 0,
             keep.size(), tolerance, keep.data());
  const auto chosen = [&](auto& column) {
    std::size_t place = 0;
    for (std::size_t i = 0; i < keep.size(); ++i)
      if (keep[i] != 0) column[place++] = column[i];
    column.resize(place);
    column.shrink_to_fit();
  };
  chosen(outline.x), chosen(outline.y), chosen(outline.z);
  chosen(outline.time), chosen(outline.row), chosen(outline.key);
}

/// Join pieces in order, each begun when the one before has ended; they are given away.
Outline joined(std::vector<Outline>& pieces, const std::vector<double>& seconds) {
  Outline whole;
  double began = 0;
  std::size_t size = 0;
  for (const Outline& piece : pieces) size += piece.x.size();
  const auto move_all = [&](auto& to, auto& from) {
    to.reserve(size);
    to.insert(to.end(), from.begin(), from.end());
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    Outline piece = std::move(pieces[i]);
    for (double& time : piece.time) time += began;
    began += seconds[i];
    move_all(whole.x, piece.x), move_all(whole.y, piece.y), move_all(whole.z, piece.z);
    move_all(whole.time, piece.time), move_all(whole.row, piece.row);
    move_all(whole.key, piece.key);
    whole.points += piece.points;
    whole.begins += piece.begins;
  }
  return whole;
}

}  // namespace

Outline Sampler::outline(const std::int32_t* keys, double thinner,
                         InterruptCheck* interrupt) const {
  const std::size_t rows = last_ - first_, count = (rows + kPieceRows - 1) / kPieceRows;
  std::vector<Outline> pieces(count);
  std::vector<double> seconds(count);
  in_parts(rows, interrupt, [&](std::size_t first, std::size_t last) {
    Outline piece;
    double now = 0;
    const auto one = [&](std::size_t i, const Curve& curve, const MoveRow& row) {
      if (curve.begins) put(piece, curve.first(), i, now, -1);
      const auto steps = static_cast<double>(curve.steps);
      for (std::size_t step = 1; step <= curve.steps; ++step) {
        const double part = static_cast<double>(step) / steps;
        put(piece, curve.at(step), i, now + row.time * part, keys[i - first_]);
      }
      now += row.time;
    };
    each_curve<true>(first_ + first, first_ + last, one);
    if (thinner > 0) thin_out(piece, thinner);
    pieces[first / kPieceRows] = std::move(piece);
    seconds[first / kPieceRows] = now;
  });
  return joined(pieces, seconds);
}

}  // namespace cncsub
