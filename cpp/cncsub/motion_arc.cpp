// G02 and G03: the centre from R or I J K, the checks, and the angle run through.
#include <algorithm>
#include <bit>
#include <limits>

#include "cncsub/motion_facts.hpp"
#include "cncsub/motion_geometry.hpp"

namespace cncsub {
namespace {

constexpr std::string_view kCentreWords = "IJK";

/// The angle from one direction to another, counter-clockwise in (0, 2 pi], or clockwise in [-2 pi,
/// 0).
double turn_between(double from, double to, bool clockwise) {
  double turn = std::remainder(to - from, 2 * kPi);
  if (std::fabs(turn) < 1e-12) turn = 0;
  if (clockwise) return turn >= 0 ? turn - 2 * kPi : turn;
  return turn <= 0 ? turn + 2 * kPi : turn;
}

bool has_centre(const BlockWords& block, const PlaneAxes& plane) {
  return block.words.has(kCentreWords[static_cast<std::size_t>(plane.a)]) ||
         block.words.has(kCentreWords[static_cast<std::size_t>(plane.b)]);
}

}  // namespace

bool Motion::round(std::uint32_t mask, const Cell* values, int g, std::uint32_t step,
                   Moves* moves) {
  MotionState& s = s_;
  const int line = g >= 0 ? g : s.line;
  if (!s.plain || line < 2 || facts_->lathe()) return false;
  const Control& c = *facts_->control;
  const PlaneAxes plane = plane_axes(s.plane);
  const auto word = [&](char address) {
    return (mask & bit(address)) != 0 ? (values++)->value : 0.0;
  };
  const double feed = word('F');
  if (!((mask & bit('F')) != 0 ? feed > 0 : s.feed > 0)) return false;
  std::array<double, 3> centre{}, end{};
  for (std::size_t i = 0; i < 3; ++i) centre[i] = word(kCentreWords[i]) * s.unit;
  for (std::size_t i = 0; i < 3; ++i) {
    const bool named = (mask & bit(kAxisNames[i])) != 0;
    const double value = word(kAxisNames[i]) * s.unit;
    end[i] = named && !s.incremental ? value : s.work[i] + value;
  }
  const auto a = static_cast<std::size_t>(plane.a), b = static_cast<std::size_t>(plane.b),
             across = static_cast<std::size_t>(plane.across);
  const bool helix = (mask & bit(kAxisNames[across])) != 0;
  if (centre[across] != 0 || (helix && !c.helix.value)) return false;
  const double i = centre[a], j = centre[b];
  const double ca = s.work[a] + i, cb = s.work[b] + j;
  const double first = std::hypot(i, j), last = std::hypot(end[a] - ca, end[b] - cb);
  const double tolerance = c.arc_tolerance.value * 1e-3;
  if (first == 0 || (tolerance > 0 && std::fabs(first - last) > tolerance)) return false;
  const bool clockwise = line == 2;
  const bool full = std::hypot(end[a] - s.work[a], end[b] - s.work[b]) < 1e-9;
  const double turn =
      full ? 2 * kPi
           : turn_between(std::atan2(-j, -i), std::atan2(end[b] - cb, end[a] - ca), clockwise);
  const double in_plane = spiral_length(first, last, turn);

  if (line != s.line) switch_line(line);
  if ((mask & bit('F')) != 0) set_plain_feed(feed);
  if (moves != nullptr && s.row_moves != moves) new_row_state(*moves);
  std::copy(end.begin(), end.end(), s.work.begin());
  s.time += in_plane * s.seconds_per_mm;
  s.moved_before = true;
  if (moves == nullptr) return true;
  moves->mark(mask >> ('X' - 'A') & 7u);
  moves->push(step, clockwise ? MoveKind::Cw : MoveKind::Ccw, s.work, s.row_state);
  centre[a] = ca;
  centre[b] = cb;
  centre[across] = std::numeric_limits<double>::quiet_NaN();
  moves->arc(centre, in_plane);
  return true;
}

Motion::Result Motion::arc(BlockWords& block, Meaning meaning) {
  const Control& c = *facts_->control;
  const PlaneAxes plane = plane_axes(s_.plane);
  std::uint32_t named = 0;
  const Axes written = target(block, named);
  const Axes end = lengthened(block, written, named);
  const bool centre = has_centre(block, plane);
  const bool radius = block.words.has('R') && block.words['R'] != 0;
  if (named == 0 && !centre && !radius) return std::nullopt;
  if (auto wrong = need_feed(block, meaning)) return wrong;
  if (block.longer != 0)
    if (auto wrong = check_longer(block, written, radius)) return wrong;
  const char across = kCentreWords[static_cast<std::size_t>(plane.across)];
  const auto outside = [&](int axis, Cause cause) {
    return fault_at(kAxisNames[static_cast<std::size_t>(axis)], cause, block);
  };
  const bool helix = c.helix.value && (!facts_->lathe() || c.helix_on_lathes.value);
  if ((named & axis_bit(plane.across)) != 0 && !helix) return outside(plane.across, Cause::ArcAxis);
  if (const std::uint32_t beyond = named & ~7u; beyond != 0)  // neither X nor Y nor Z
    return outside(std::countr_zero(beyond),
                   facts_->refuses(Cause::HelixAxis) ? Cause::HelixAxis : Cause::ArcAxis);
  if (!radius && block.words.has(across) && block.words[across] != 0)
    return fault_at(across, Cause::ArcAxis, block);
  bool clockwise = meaning == Meaning::Cw;
  if (mirrored_plane()) clockwise = !clockwise;
  Piece piece = make_piece(block, clockwise ? MoveKind::Cw : MoveKind::Ccw, end, named);
  if (auto wrong = corner_words(block, piece)) return wrong;
  if (radius) {
    block.outcome.drop(bit('I') | bit('J') | bit('K'));  // R counts [source 003, note 3]
    if (auto wrong = arc_by_radius(block, piece)) return wrong;
  } else if (centre) {
    if (s_.modal[at(Group::Polar)].meaning == Meaning::PolarOn &&
        facts_->refuses(Cause::PolarCentre))
      return fault(Cause::PolarCentre, block);
    if (auto wrong = arc_by_centre(block, piece)) return wrong;
  } else if (c.no_radius.value == NoRadius::Alarm) {
    return fault(Cause::NoRadius, block);
  } else {
    piece.kind = MoveKind::Feed;
  }
  // R with the end at the start is no arc: nothing is left but what goes along. [16TC p.67]
  const bool goes_across = (named & axis_bit(plane.across)) != 0;
  if (piece.corner != 0 && goes_across && facts_->refuses(Cause::CornerHelix))
    return fault(Cause::CornerHelix, block);
  if (piece.turn == 0 && piece.kind != MoveKind::Feed) {
    if (goes_across && facts_->refuses(Cause::HelixTravel)) return fault(Cause::HelixTravel, block);
    piece.kind = MoveKind::Feed;
    block.outcome.axis_word = true;
    if (!goes_across) return std::nullopt;
  }
  return move(block, piece);
}

/// G45 to G48 change the radius of quarters and three quarters of a circle, which begin and end on
/// the axes of their centre. [K: FANUC, tool offset]
Motion::Result Motion::check_longer(const BlockWords& block, const Axes& end,
                                    bool by_radius) const {
  const PlaneAxes plane = plane_axes(s_.plane);
  const Cause cause = Cause::LongerArc;
  if (by_radius) return fault(cause, block, "write I, J, K");
  const auto centre = [&](int axis) {
    const char name = kCentreWords[static_cast<std::size_t>(axis)];
    return block.words.has(name) ? number(block, name) : 0.0;
  };
  const double i = centre(plane.a), j = centre(plane.b), radius = std::hypot(i, j);
  const double a = end[plane.a] - s_.work[plane.a], b = end[plane.b] - s_.work[plane.b];
  const double miss = std::max(std::fabs(std::fabs(a) - radius), std::fabs(std::fabs(b) - radius));
  if ((i != 0) == (j != 0) || miss > facts_->increment || radius + block.longer <= 0)
    return fault(cause, block);
  return std::nullopt;
}

Motion::Result Motion::arc_by_radius(BlockWords& block, Piece& piece) const {
  const Control& c = *facts_->control;
  const PlaneAxes plane = plane_axes(s_.plane);
  double radius = number(block, 'R');
  if (s_.turned.scaling) radius *= std::fabs(s_.turned.scale[static_cast<std::size_t>(plane.a)]);
  const bool negative_allowed =
      c.negative_radius.value && (!facts_->lathe() || c.negative_radius_on_lathes.value);
  if (radius < 0 && !negative_allowed) return fault(Cause::NegativeRadius, block);
  const Axes start = s_.work + piece.offset;
  const double a0 = start[plane.a] * facts_->share(plane.a),
               b0 = start[plane.b] * facts_->share(plane.b);
  const double da = piece.end[plane.a] * facts_->share(plane.a) - a0;
  const double db = piece.end[plane.b] * facts_->share(plane.b) - b0;
  const double chord = std::hypot(da, db);
  if (chord < 1e-9)
    return c.radius_needs_travel.value ? Result(fault(Cause::NoArcTravel, block)) : std::nullopt;
  double size = std::fabs(radius);
  if (const double miss = chord / 2 - size; miss > 0) {
    const bool half = c.small_radius.value == SmallRadius::HalfCircle;
    if (miss > std::max(facts_->increment / 2 + 1e-9, half ? c.arc_tolerance.value * 1e-3 : 0))
      return fault(Cause::RadiusTooSmall, block);
    size = chord / 2;
  }
  const double height = std::sqrt(std::max(0.0, size * size - chord * chord / 4));
  const bool clockwise = piece.kind == MoveKind::Cw;
  const double side =
      clockwise == (radius > 0) ? -1 : 1;  // -1: the centre lies on the right of the way
  const double ca = a0 + da / 2 - side * height * db / chord,
               cb = b0 + db / 2 + side * height * da / chord;
  piece.centre[plane.a] = ca / facts_->share(plane.a);
  piece.centre[plane.b] = cb / facts_->share(plane.b);
  piece.turn =
      turn_between(std::atan2(b0 - cb, a0 - ca), std::atan2(b0 + db - cb, a0 + da - ca), clockwise);
  return std::nullopt;
}

Motion::Result Motion::arc_by_centre(BlockWords& block, Piece& piece) const {
  const Control& c = *facts_->control;
  const PlaneAxes plane = plane_axes(s_.plane);
  const auto word = [&](int axis) {
    const char name = kCentreWords[static_cast<std::size_t>(axis)];
    return block.words.has(name) ? number(block, name) : 0.0;
  };
  double i = word(plane.a), j = word(plane.b);
  turn_vector(i, j, plane);
  if (double& arm = i != 0 ? i : j; block.longer != 0)
    arm += arm < 0 ? -block.longer : block.longer;
  const Axes start = s_.work + piece.offset;
  const double a0 = start[plane.a] * facts_->share(plane.a),
               b0 = start[plane.b] * facts_->share(plane.b);
  const double a1 = piece.end[plane.a] * facts_->share(plane.a),
               b1 = piece.end[plane.b] * facts_->share(plane.b);
  const double ca = a0 + i, cb = b0 + j;
  const double first = std::hypot(i, j), last = std::hypot(a1 - ca, b1 - cb);
  if (piece.radius != 0 && first == 0) return fault(Cause::CompensationArcStart, block);
  if (first == 0 && c.arc_centre_needed.value) return fault(Cause::NoRadius, block);
  const double tolerance = c.arc_tolerance.value * 1e-3;
  if (tolerance > 0 && std::fabs(first - last) > tolerance + 1e-9) {
    char text[64];
    std::snprintf(text, sizeof text, "radius %.4f at the start, %.4f at the end", first, last);
    return fault(Cause::RadiusTolerance, block, text);
  }
  if (first == 0) {
    piece.kind = MoveKind::Feed;
    return std::nullopt;
  }
  if (piece.radius != 0 && last == 0) return fault(Cause::CompensationArcEnd, block);
  piece.centre[plane.a] = ca / facts_->share(plane.a);
  piece.centre[plane.b] = cb / facts_->share(plane.b);
  const bool clockwise = piece.kind == MoveKind::Cw;
  if (std::hypot(a1 - a0, b1 - b0) < 1e-9)
    piece.turn = clockwise ? -2 * kPi : 2 * kPi;
  else
    piece.turn =
        turn_between(std::atan2(b0 - cb, a0 - ca), std::atan2(b1 - cb, a1 - ca), clockwise);
  return std::nullopt;
}

/// An arc through a third point: I and K lead to it from the start, or name it. [TDi 5]
Motion::Result Motion::arc_by_points(BlockWords& block, Meaning meaning) {
  const PlaneAxes plane = plane_axes(s_.plane);
  std::uint32_t named = 0;
  const Axes end = target(block, named);
  if (named == 0) return std::nullopt;
  if (auto wrong = need_feed(block, meaning)) return wrong;
  if (!has_centre(block, plane)) return fault(Cause::ThreePoints, block, "neither I nor K");
  Piece piece = make_piece(block, MoveKind::Cw, end, named);
  const PlaneView view{plane, facts_->share(0)};
  const Axes start = s_.work + piece.offset;
  Axes middle = start;
  for (const int axis : {plane.a, plane.b}) {
    const char name = kCentreWords[static_cast<std::size_t>(axis)];
    const double value = block.words.has(name) ? number(block, name) : 0;
    if (meaning == Meaning::ThreePointsAbsolute)
      middle[axis] = value + piece.offset[axis];
    else
      middle[axis] += value / facts_->share(axis);
  }
  const Point p = view.point(start), u = view.point(middle) - p, v = view.point(piece.end) - p;
  const double area = 2 * cross(u, v);
  if (std::fabs(area) < 1e-9) return fault(Cause::ThreePoints, block);
  const Point centre = p + Point{(v.b * dot(u, u) - u.b * dot(v, v)) / area,
                                 (u.a * dot(v, v) - v.a * dot(u, u)) / area};
  const bool clockwise = area < 0;
  view.set(piece.centre, centre);
  piece.kind = clockwise ? MoveKind::Cw : MoveKind::Ccw;
  const Point from = p - centre, to = p + v - centre;
  piece.turn = turn_between(std::atan2(from.b, from.a), std::atan2(to.b, to.a), clockwise);
  return move(block, piece);
}

}  // namespace cncsub
