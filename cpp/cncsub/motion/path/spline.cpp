// G05 and G05.1: a curve of two or one control points, cut into lines that leave it by no more than
// the least increment.
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/geometry.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

constexpr double kFinest = 1e-3;  // mm that the lines may leave the curve by, at least

/// A curve of the third order in its plane: ends and control points. [LC g-code, G5]
struct Cubic {
  Point from, first, second, to;

  Point at(double t) const {
    const double s = 1 - t;
    return s * s * s * from + 3 * s * s * t * first + 3 * s * t * t * second + t * t * t * to;
  }
  /// Return how many lines of equal parts leave the curve by no more than this.
  double lines(double tolerance) const {
    const double bend =
        6 * std::max(size(from - 2 * first + second), size(first - 2 * second + to));
    return std::max(1.0, std::ceil(std::sqrt(bend / (8 * tolerance))));
  }
};

/// Refuse what a spline does not take.
Result check_spline(MotionView m, const BlockWords& block, bool by_one_point) {
  const NcWords& w = block.words;
  if (compensating(m.state)) return fault(Cause::SplineInCompensation, block);
  if (m.state.plane != Plane::XY) return fault(Cause::SplineWord, block, "a spline must be in G17");
  for (const char name : std::string_view("ZABC"))
    if (w.has(name)) return fault_at(name, Cause::SplineWord, block);
  if (w.has('I') != w.has('J') || (by_one_point && !w.has('I')))
    return fault(Cause::SplineWord, block, "I and J must be given together");
  if (!by_one_point && (!w.has('P') || !w.has('Q')))
    return fault(Cause::SplineWord, block, "P and Q must be given together");
  return std::nullopt;
}

}  // namespace

Result spline(MotionContext& m, BlockWords& block) {
  const bool by_one_point = block.code(Group::Motion).variant == 1;
  const auto [end, named] = end_point(m, block);
  if (named == 0) return std::nullopt;
  if (auto wrong = check_spline(m, block, by_one_point)) return wrong;
  if (auto wrong = need_feed(m, block, Meaning::Line)) return wrong;
  const auto pair = [&](char a, char b) { return Point{number(m, block, a), number(m, block, b)}; };
  const Point from{m.state.work[0], m.state.work[1]}, to{end[0], end[1]};
  const Point way =
      block.words.has('I') ? pair('I', 'J') : Point{m.state.spline_way[0], m.state.spline_way[1]};
  Cubic curve{from, from + way, to, to};
  if (by_one_point) {  // of the second order: its one control point is two thirds of the path to
                       // both
    curve.first = from + (2.0 / 3) * way;
    curve.second = to + (2.0 / 3) * (from + way - to);
  } else {
    const Point back = pair('P', 'Q');
    curve.second = to + back;
    m.state.spline_way = {-back.a, -back.b};
  }
  const double lines = curve.lines(std::max(kFinest, m.facts.increment));
  for (double i = 1; i < lines; ++i) {
    const Point point = curve.at(i / lines);
    Axes next = end;
    next[0] = point.a;
    next[1] = point.b;
    if (auto wrong = move(m, block, MoveKind::Feed, next, 3u)) return wrong;
  }
  return move(m, block, MoveKind::Feed, end, named);
}

}  // namespace cncsub
