#include "cncsub/motion/state/workpiece.hpp"

#include <algorithm>
#include <cmath>

namespace cncsub {
namespace {

constexpr double kTouch = 2e-6;  // mm: less is grazing, and the place of a touch is rounded
constexpr double kBehind = 2;    // a place beyond the end of the path

double dot(const Point3& a, const Point3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point3 between(const Point3& from, const Point3& to, double t) {
  return {from[0] + (to[0] - from[0]) * t, from[1] + (to[1] - from[1]) * t,
          from[2] + (to[2] - from[2]) * t};
}

/// Return the distance from a point to the surface of a convex body, negative inside. Along a line
/// it never turns twice.
double distance(const Solid& solid, const Point3& p) {
  const Point3 d{p[0] - solid.at[0], p[1] - solid.at[1], p[2] - solid.at[2]};
  switch (solid.shape) {
    case Solid::Shape::Plane:
      return dot(d, solid.direction);
    case Solid::Shape::Sphere:
      return std::sqrt(dot(d, d)) - solid.radius;
    case Solid::Shape::Cylinder: {
      const double along = dot(d, solid.direction);
      double across = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const double part = d[i] - solid.direction[i] * along;
        across += part * part;
      }
      const double side = std::sqrt(across) - solid.radius;
      const double end = std::max(along - solid.last, solid.first - along);
      return side > 0 && end > 0 ? std::hypot(side, end) : std::max(side, end);
    }
    case Solid::Shape::Box: {
      double outside = 0, inside = -Solid::kOpen;
      for (std::size_t i = 0; i < 3; ++i) {
        const double beyond = std::max(p[i] - solid.high[i], solid.low[i] - p[i]);
        inside = std::max(inside, beyond);
        if (beyond > 0) outside += beyond * beyond;
      }
      return outside > 0 ? std::sqrt(outside) : inside;
    }
  }
  return Solid::kOpen;
}

struct Span {
  double from = 0, to = kBehind;
};

/// Return where a function that falls and then rises crosses a level, between two places on its
/// sides.
template <class Function>
double crossing(const Function& f, double above, double below, double level) {
  for (int i = 0; i < 100; ++i) {
    const double middle = (above + below) / 2;
    if (middle == above || middle == below) break;
    (f(middle) > level ? above : below) = middle;
  }
  return above;
}

/// Return where such a function is lowest.
template <class Function>
double lowest(const Function& f) {
  constexpr double kGolden = 0.6180339887498949;
  double low = 0, high = 1;
  double a = high - kGolden, b = low + kGolden, fa = f(a), fb = f(b);
  for (int i = 0; i < 80; ++i) {
    if (fa <= fb) {
      high = b, b = a, fb = fa;
      fa = f(a = high - kGolden * (high - low));
    } else {
      low = a, a = b, fa = fb;
      fb = f(b = low + kGolden * (high - low));
    }
  }
  double best = (low + high) / 2;
  for (const double end : {0.0, 1.0})
    if (f(end) < f(best)) best = end;
  return best;
}

/// Return where the ball presses on a body. `gap` is the distance from the ball to the body.
template <class Function>
std::optional<Span> pressing(const Function& gap) {
  const double deepest = lowest(gap);
  if (!(gap(deepest) < -kTouch)) return std::nullopt;
  Span span;
  if (gap(0) > 0) span.from = crossing(gap, 0, deepest, 0);
  if (gap(1) > 0) span.to = crossing(gap, 1, deepest, 0);
  return span;
}

/// Return where the ball is free in a hole; the end is where it meets the wall. `past` is how far
/// the ball reaches into the wall.
template <class Function>
std::optional<Span> free(const Function& past) {
  const double widest = lowest(past);
  if (!(past(widest) <= kTouch)) return std::nullopt;
  Span span;
  if (past(0) > kTouch) span.from = crossing(past, 0, widest, kTouch);
  if (past(1) > kTouch) span.to = crossing(past, 1, widest, std::max(0.0, past(widest)));
  return span;
}

/// The spans in which the ball presses on bodies, and those in which it is free in holes.
struct Spans {
  std::vector<Span> bodies, holes;
};

/// Return the spans of the solids that give one of these signals, nothing where the ball can touch
/// none.
std::optional<Spans> spans_of(const Workpiece& workpiece, SignalMask signals, const Point3& from,
                              const Point3& to) {
  const double radius = workpiece.stylus;
  Spans spans;
  bool silent_body = false, any_body = false, any = false;
  for (const Solid& solid : workpiece.solids) {
    if (solid.signal != 0 && (signals & signal_bit(solid.signal)) == 0) {
      silent_body = silent_body || !solid.hole;
      continue;
    }
    any = true;
    any_body = any_body || !solid.hole;
    const auto here = [&](double t) { return distance(solid, between(from, to, t)); };
    const auto span = solid.hole ? free([&](double t) { return here(t) + radius; })
                                 : pressing([&](double t) { return here(t) - radius; });
    if (span) (solid.hole ? spans.holes : spans.bodies).push_back(*span);
  }
  if (!any || (silent_body && !any_body)) return std::nullopt;  // or holes in what is silent
  if (!any_body) spans.bodies.emplace_back();
  return spans;
}

/// Return the first place from `t` on where the ball presses on a body.
double touched_from(const std::vector<Span>& bodies, double t) {
  double touched = kBehind;
  for (const Span& body : bodies)
    if (t <= body.to) touched = std::min(touched, std::max(t, body.from));
  return touched;
}

/// Return where the ball leaves the holes in which it is at `t`, -1 where it is in none.
double left_from(const std::vector<Span>& holes, double t) {
  double left = -1;
  for (const Span& hole : holes)
    if (hole.from <= t && t < hole.to) left = std::max(left, hole.to);
  return left;
}

}  // namespace

std::optional<double> first_contact(const Workpiece& workpiece, SignalMask signals,
                                    const Point3& from, const Point3& to) {
  const auto spans = spans_of(workpiece, signals, from, to);
  if (!spans) return std::nullopt;
  // The ball goes from body to body and from hole to hole, each of which is left once.
  for (double t = 0;;) {
    const double touched = touched_from(spans->bodies, t);
    if (touched > 1) return std::nullopt;
    t = left_from(spans->holes, touched);
    if (t < 0) return touched;
  }
}

namespace {

constexpr double kJustOutside = 1e-6;

/// Return whether a point beside a hole is in no body, or in another hole.
bool in_the_open(const std::vector<Solid>& solids, const Solid& hole, const Point3& p) {
  bool body = false;
  for (const Solid& solid : solids) {
    if (&solid == &hole || !(distance(solid, p) < 0)) continue;
    if (solid.hole) return true;
    body = true;
  }
  return !body;
}

/// Return whether all of an end of a cylinder is open: its middle, and points around it.
bool end_is_open(const std::vector<Solid>& solids, const Solid& hole, double along) {
  const Point3& d = hole.direction;
  // Two directions across the axis.
  const Point3 other = std::fabs(d[0]) < 0.9 ? Point3{1, 0, 0} : Point3{0, 1, 0};
  Point3 u{d[1] * other[2] - d[2] * other[1], d[2] * other[0] - d[0] * other[2],
           d[0] * other[1] - d[1] * other[0]};
  const double length = std::sqrt(dot(u, u));
  for (double& part : u) part /= length;
  const Point3 v{d[1] * u[2] - d[2] * u[1], d[2] * u[0] - d[0] * u[2], d[0] * u[1] - d[1] * u[0]};
  constexpr std::array<std::array<double, 2>, 5> kPlaces = {
      {{0, 0}, {0.9, 0}, {-0.9, 0}, {0, 0.9}, {0, -0.9}}};
  return std::all_of(kPlaces.begin(), kPlaces.end(), [&](const auto& place) {
    Point3 p = hole.at;
    for (std::size_t i = 0; i < 3; ++i)
      p[i] += d[i] * along + hole.radius * (u[i] * place[0] + v[i] * place[1]);
    return in_the_open(solids, hole, p);
  });
}

/// Return a place between the ends of a side of a box, near one of them where there is no other.
double place_on(const Solid& box, std::size_t axis, double share) {
  const double low = box.low[axis], high = box.high[axis];
  if (std::isfinite(low) && std::isfinite(high)) return low + (high - low) * share;
  if (std::isfinite(low)) return low + share;
  return std::isfinite(high) ? high - share : share;
}

/// Return whether all of a face of a box is open.
bool face_is_open(const std::vector<Solid>& solids, const Solid& box, std::size_t axis,
                  double value) {
  Point3 p{};
  p[axis] = value;
  const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
  for (const double along : {0.05, 0.5, 0.95})
    for (const double across : {0.05, 0.5, 0.95}) {
      p[a] = place_on(box, a, along), p[b] = place_on(box, b, across);
      if (!in_the_open(solids, box, p)) return false;
    }
  return true;
}

void open_cylinder(const std::vector<Solid>& solids, Solid& hole) {
  if (std::isfinite(hole.first) && end_is_open(solids, hole, hole.first - kJustOutside))
    hole.first = -Solid::kOpen;
  if (std::isfinite(hole.last) && end_is_open(solids, hole, hole.last + kJustOutside))
    hole.last = Solid::kOpen;
}

void open_box(const std::vector<Solid>& solids, Solid& hole) {
  for (std::size_t i = 0; i < 3; ++i) {
    const bool lower =
        std::isfinite(hole.low[i]) && face_is_open(solids, hole, i, hole.low[i] - kJustOutside);
    const bool upper =
        std::isfinite(hole.high[i]) && face_is_open(solids, hole, i, hole.high[i] + kJustOutside);
    if (lower) hole.low[i] = -Solid::kOpen;
    if (upper) hole.high[i] = Solid::kOpen;
  }
}

}  // namespace

void open_holes(std::vector<Solid>& solids) {
  if (std::all_of(solids.begin(), solids.end(), [](const Solid& solid) { return solid.hole; }))
    return;
  for (Solid& hole : solids) {
    if (!hole.hole) continue;
    if (hole.shape == Solid::Shape::Cylinder) open_cylinder(solids, hole);
    if (hole.shape == Solid::Shape::Box) open_box(solids, hole);
  }
}

}  // namespace cncsub
