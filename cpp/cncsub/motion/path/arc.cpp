// G02 and G03: the centre from R or I J K, the checks, and the angle run through.
#include <algorithm>
#include <bit>
#include <limits>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/geometry.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

constexpr std::string_view kCentreNames = "IJK";

/// Return the letter that gives the centre along an axis: I along U as well.
char centre_name(int axis) { return kCentreNames[centre_place(axis)]; }

bool has_centre(const BlockWords& block, const PlaneAxes& plane) {
  return block.words.has(centre_name(plane.a)) || block.words.has(centre_name(plane.b));
}

/// Return the first letter of a centre that the block has.
char centre_word(const BlockWords& block) {
  return block.words.has('I') ? 'I' : block.words.has('J') ? 'J' : 'K';
}

PlaneAxes axes_of(const Piece& piece) { return arc_axes(piece.plane, piece.state.parallel); }

/// Check an arc with G45 to G48, which change the radius of quarters and three quarters of a circle
/// that begin and end on the axes of their centre. [general knowledge: FANUC]
Result check_longer(MotionView m, const BlockWords& block, const Axes& end, bool by_radius) {
  if (block.axis_extension == 0) return std::nullopt;
  const PlaneAxes plane = plane_axes(m.state.plane);
  const Cause cause = Cause::LongerArc;
  if (by_radius) return fault(cause, block, "write I, J, K");
  const auto centre = [&](int axis) {
    const char name = kCentreNames[static_cast<std::size_t>(axis)];
    return block.words.has(name) ? number(m, block, name) : 0.0;
  };
  const double i = centre(plane.a), j = centre(plane.b), radius = std::hypot(i, j);
  const double a = end[plane.a] - m.state.work[plane.a], b = end[plane.b] - m.state.work[plane.b];
  const double miss = std::max(std::fabs(std::fabs(a) - radius), std::fabs(std::fabs(b) - radius));
  if ((i != 0) == (j != 0) || miss > m.facts.increment || radius + block.axis_extension <= 0)
    return fault(cause, block);
  return std::nullopt;
}

Result arc_by_radius(MotionView m, const BlockWords& block, Piece& piece) {
  const Control& c = *m.facts.control;
  const PlaneAxes plane = axes_of(piece);
  double radius = number(m, block, 'R');
  if (m.state.transform.scaling)
    radius *= std::fabs(m.state.transform.scale[static_cast<std::size_t>(plane.a)]);
  if (m.state.frame.turned)
    radius *= std::fabs(factor_in_plane(m.state.frame, plane_axes(piece.plane)));
  if (radius < 0 && !takes_negative_radius(m.facts))
    return fault_at('R', Cause::NegativeRadius, block);
  const Axes start = m.state.work + piece.offset;
  const double a0 = start[plane.a] * m.facts.share(plane.a),
               b0 = start[plane.b] * m.facts.share(plane.b);
  const double da = piece.end[plane.a] * m.facts.share(plane.a) - a0;
  const double db = piece.end[plane.b] * m.facts.share(plane.b) - b0;
  const double chord = std::hypot(da, db);
  if (chord < kStanding)
    return m.facts.refuses(Cause::NoArcTravel) ? Result(fault_at('R', Cause::NoArcTravel, block))
                                               : std::nullopt;
  double size = std::fabs(radius);
  if (const double miss = chord / 2 - size; miss > 0) {
    const bool half = c.motion.small_radius.value == SmallRadius::HalfCircle;
    if (miss >
        std::max({m.facts.increment / 2 + 1e-9, half ? c.motion.arc_tolerance.value * 1e-3 : 0,
                  c.motion.arc_rounding.value > 0 ? kRadiusSlack : 0}))
      return fault_at('R', Cause::RadiusTooSmall, block);
    size = chord / 2;
  }
  const bool clockwise = piece.kind == MoveKind::Cw;
  const Point to_centre = centre_by_radius({da, db}, std::copysign(size, radius), clockwise);
  const double ca = a0 + to_centre.a, cb = b0 + to_centre.b;
  piece.centre[centre_place(plane.a)] = ca / m.facts.share(plane.a);
  piece.centre[centre_place(plane.b)] = cb / m.facts.share(plane.b);
  piece.turn =
      turn_between(std::atan2(b0 - cb, a0 - ca), std::atan2(b0 + db - cb, a0 + da - ca), clockwise);
  return std::nullopt;
}

/// Return the arc in numbers, in the unit of the program, for controls whose message shows them.
std::string arc_in_numbers(MotionView m, const Piece& piece, Point start, Point centre, Point end) {
  const PlaneAxes plane = plane_axes(piece.plane);
  const double unit = m.state.unit;
  const auto shown = [&](Point p) {
    char text[96];
    std::snprintf(
        text, sizeof text, "(%c%.4f,%c%.4f)", kAxisNames[static_cast<std::size_t>(plane.a)],
        (p.a - piece.offset[plane.a]) / unit, kAxisNames[static_cast<std::size_t>(plane.b)],
        (p.b - piece.offset[plane.b]) / unit);
    return std::string(text);
  };
  const double first = size(start - centre) / unit, last = size(end - centre) / unit;
  const double miss = std::fabs(first - last);
  char radii[128];
  std::snprintf(radii, sizeof radii, " r1=%.4f r2=%.4f abs_err=%.4g rel_err=%.4f%%", first, last,
                miss, miss / std::max(first, last) * 100);
  return "start=" + shown(start) + " center=" + shown(centre) + " end=" + shown(end) + radii;
}

/// Return the fault of an arc that ends off its circle.
Fault off_circle(MotionView m, const BlockWords& block, const Piece& piece, Point start,
                 Point centre, Point end) {
  char text[64];
  std::snprintf(text, sizeof text, "radius %.4f at the start, %.4f at the end",
                size(start - centre), size(end - centre));
  Fault wrong =
      fault_at({.addresses = kEndWords | kCentreWords}, Cause::RadiusTolerance, block, text);
  wrong.name = arc_in_numbers(m, piece, start, centre, end);
  return wrong;
}

/// Return whether the pole is the centre of an arc: its end is polar, and it has neither a radius
/// nor a centre of its own. [802Dsl p.8-156]
bool is_about_pole(MotionView m, const BlockWords& block) {
  return m.facts.control->motion.poles.value && (block.words.mask & kPolarWords) != 0 &&
         !block.words.has('R') && !has_centre(block, plane_axes(m.state.plane));
}

/// Read the words of a centre as its way from the start.
void centre_words(MotionView m, const BlockWords& block, const Piece& piece, double& i, double& j) {
  const PlaneAxes plane = axes_of(piece);
  const Axes programmed = as_programmed(m.state, m.state.work);
  if (is_about_pole(m, block)) {
    i = m.state.pole[static_cast<std::size_t>(plane.a)] - programmed[plane.a];
    j = m.state.pole[static_cast<std::size_t>(plane.b)] - programmed[plane.b];
    return turn_vector(m.state, i, j, plane_axes(piece.plane));
  }
  const auto word = [&](int axis) {
    const char name = centre_name(axis);
    if (!block.words.has(name)) return 0.0;
    const bool own = (block.words.forms.absolute & bit(name)) != 0;
    const double zero = own                           ? programmed[static_cast<std::size_t>(axis)]
                        : centre_is_absolute(m.state) ? m.state.work[axis]
                                                      : 0;
    return number(m, block, name) - zero;
  };
  i = word(plane.a);
  j = word(plane.b);
  turn_vector(m.state, i, j, plane_axes(piece.plane));
}

Result arc_by_centre(MotionView m, const BlockWords& block, Piece& piece) {
  const Control& c = *m.facts.control;
  const PlaneAxes plane = axes_of(piece);
  double i = 0, j = 0;
  centre_words(m, block, piece, i, j);
  if (double& arm = i != 0 ? i : j; block.axis_extension != 0)
    arm += arm < 0 ? -block.axis_extension : block.axis_extension;
  const Axes start = m.state.work + piece.offset;
  const double a0 = start[plane.a] * m.facts.share(plane.a),
               b0 = start[plane.b] * m.facts.share(plane.b);
  const double a1 = piece.end[plane.a] * m.facts.share(plane.a),
               b1 = piece.end[plane.b] * m.facts.share(plane.b);
  const double ca = a0 + i, cb = b0 + j;
  const double first = std::hypot(i, j), last = std::hypot(a1 - ca, b1 - cb);
  if (piece.radius != 0 && first == 0)
    return fault_at(centre_word(block), Cause::CompensationArcStart, block);
  if (has_no_radius(c.motion, first, last) && m.facts.refuses(Cause::NoRadius))
    return fault_at({.addresses = kCentreWords}, Cause::NoRadius, block);
  if (is_off_circle(c.motion, first, last, m.state.unit != 1))
    return off_circle(m, block, piece, {a0, b0}, {ca, cb}, {a1, b1});
  if (first == 0) {
    piece.kind = MoveKind::Feed;
    return std::nullopt;
  }
  if (piece.radius != 0 && last < kStanding)
    return fault_at(centre_word(block), Cause::CompensationArcEnd, block);
  piece.centre[centre_place(plane.a)] = ca / m.facts.share(plane.a);
  piece.centre[centre_place(plane.b)] = cb / m.facts.share(plane.b);
  const bool clockwise = piece.kind == MoveKind::Cw;
  if (std::hypot(a1 - a0, b1 - b0) < kStanding)
    piece.turn = clockwise ? -2 * kPi : 2 * kPi;
  else
    piece.turn =
        turn_between(std::atan2(b0 - cb, a0 - ca), std::atan2(b1 - cb, a1 - ca), clockwise);
  return std::nullopt;
}

/// Return the axes of the plane whose parts U, V and W make. [source 003, G02 and G03]
std::uint8_t parallel_axes(MotionView m, std::uint32_t named) {
  if (!m.facts.control->motion.parallel_axes.value) return 0;
  const std::uint32_t across = axis_bit(plane_axes(m.state.plane).across);
  return static_cast<std::uint8_t>(named >> 6 & 7u & ~(named & 7u) & ~across);
}

/// Check an arc in U, V and W: what transforms or leads an arc of X, Y and Z is not computed for
/// it.
Result check_parallel(MotionView m, const BlockWords& block, const Piece& piece) {
  if (piece.state.parallel == 0) return std::nullopt;
  if (is_transformed(m.state) || polar(m.state) || piece.side != 0 || piece.corner != 0)
    return fault(Cause::CodeNotComputed, block,
                 "cncsub does not compute an arc of U, V or W in turned coordinates, with a radius "
                 "offset or a corner");
  return std::nullopt;
}

/// Check the axes of an arc: it moves in its plane, and across it where there are helices.
Result check_axes(MotionView m, const BlockWords& block, std::uint32_t named, bool radius) {
  const Control& c = *m.facts.control;
  const int across = plane_axes(m.state.plane).across;
  const auto out_of_plane = [&](int axis, Cause cause) {
    return fault_at(kAxisNames[static_cast<std::size_t>(axis)], cause, block);
  };
  const bool all = c.motion.helix.value == Helix::AllAxes;
  const bool helix = all || c.motion.helix.value == Helix::Everywhere ||
                     (c.motion.helix.value == Helix::MillsOnly && !m.facts.lathe());
  if ((named & axis_bit(across)) != 0 && !helix) return out_of_plane(across, Cause::ArcAxis);
  const std::uint32_t taken = 7u | std::uint32_t{parallel_axes(m, named)}
                                       << 6;  // X, Y, Z, or along
  if (const std::uint32_t beyond = all ? 0 : named & ~taken; beyond != 0)
    return out_of_plane(std::countr_zero(beyond),
                        m.facts.refuses(Cause::HelixAxis) ? Cause::HelixAxis : Cause::ArcAxis);
  const char word = kCentreNames[static_cast<std::size_t>(across)];
  const bool counts = block.words[word] != 0 || m.facts.refuses(Cause::ArcAxis);
  if (c.motion.drops_centre_across.value) return std::nullopt;
  if (!radius && block.words.has(word) && counts) return fault_at(word, Cause::ArcAxis, block);
  return std::nullopt;
}

/// Return whether one of the two words of a centre is missing.
bool lacks_centre(MotionView m, const BlockWords& block) {
  const PlaneAxes plane = plane_axes(m.state.plane);
  return !block.words.has(kCentreNames[static_cast<std::size_t>(plane.a)]) ||
         !block.words.has(kCentreNames[static_cast<std::size_t>(plane.b)]);
}

/// Add the full turns that P asks of an arc.
Result more_turns(MotionView m, const BlockWords& block, Piece& piece) {
  if (auto wrong = add_turns(m, block, piece)) return wrong;
  const MotionRules& rules = m.facts.control->motion;
  if (rules.helix.value != Helix::AllAxes || !rules.added_turns.value.empty() ||
      !block.words.has('P'))
    return std::nullopt;
  const double turns = std::round(block.words['P']);
  if (std::fabs(turns - block.words['P']) > 1e-3 || turns < 1 || turns > kMostMoves)
    return fault_at('P', Cause::ValueOutOfRange, block);
  if (piece.turn != 0) piece.turn += std::copysign(2 * kPi * (turns - 1), piece.turn);
  return std::nullopt;
}

/// Return the address of the angle of an arc that a block has; none where it has none.
char angle_name(MotionView m, const BlockWords& block) {
  for (const char name : m.facts.control->motion.arc_angle_words.value)
    if (block.words.has(name)) return name;
  return '\0';
}

/// Find the centre of an arc from its end and its angle, or its end from its centre and the angle.
Result arc_by_angle(MotionView m, const BlockWords& block, char name, bool centre, Piece& piece) {
  const PlaneAxes plane = axes_of(piece);
  const double angle = block.words[name] * kPi / 180;
  const bool inside = angle > 0 && angle < 2 * kPi;
  if (!inside) return fault_at(name, Cause::ValueOutOfRange, block);
  const bool clockwise = piece.kind == MoveKind::Cw;
  const PlaneView view{plane, m.facts.share(0)};
  const Axes start = m.state.work + piece.offset;
  const Point from = view.point(start);
  if (!centre) {
    const Point way = view.point(piece.end) - from;
    if (size(way) < kStanding) return fault_at(name, Cause::NoArcTravel, block);
    const double radius = size(way) / 2 / std::sin(angle / 2);
    const Point to_centre = centre_by_radius(way, angle > kPi ? -radius : radius, clockwise);
    view.set(piece.centre, from + to_centre);
  } else {
    double i = 0, j = 0;
    centre_words(m, block, piece, i, j);
    const Point middle = from + Point{i, j}, arm = from - middle;
    const double turn = clockwise ? -angle : angle;
    view.set(piece.centre, middle);
    view.set(piece.end, middle + Point{arm.a * std::cos(turn) - arm.b * std::sin(turn),
                                       arm.a * std::sin(turn) + arm.b * std::cos(turn)});
    piece.named |= axis_bit(plane.a) | axis_bit(plane.b);
  }
  piece.turn = clockwise ? -angle : angle;
  return add_turns(m, block, piece);
}

/// Find the centre and the angle of an arc, by R or by the words of its centre.
/// [source 003, note 3]
Result find_centre(MotionView m, const BlockWords& block, bool radius, bool centre, Piece& piece,
                   MotionOutcome& outcome) {
  if (radius) {
    outcome.drop(kCentreWords);  // R counts
    if (auto wrong = arc_by_radius(m, block, piece)) return wrong;
    return more_turns(m, block, piece);
  }
  if (centre) {
    if (centre_is_absolute(m.state) && lacks_centre(m, block))
      return fault_at({.addresses = kCentreWords}, Cause::NoRadius, block,
                      "an absolute centre needs both of its words");
    if (polar(m.state) && m.facts.refuses(Cause::PolarCentre))
      return fault_at({.addresses = kCentreWords}, Cause::PolarCentre, block);
    if (auto wrong = arc_by_centre(m, block, piece)) return wrong;
    return more_turns(m, block, piece);
  }
  if (is_about_pole(m, block)) {
    if (auto wrong = arc_by_centre(m, block, piece)) return wrong;
    return more_turns(m, block, piece);
  }
  if (m.facts.control->motion.no_radius.value == NoRadius::Alarm)
    return fault_at({.addresses = kCentreWords}, Cause::NoRadius, block);
  piece.kind = MoveKind::Feed;
  return std::nullopt;
}

/// Check G02 or G03 without a word of an arc.
Result bare_arc(MotionView m, const BlockWords& block) {
  return m.facts.refuses(Cause::NoRadius) ? check_axes(m, block, 0, false) : std::nullopt;
}

/// Refuse R beside the words of a centre, whatever they say.
Result check_form(MotionView m, const BlockWords& block) {
  if ((block.words.mask & kCentreWords) == 0 || !block.words.has('R') ||
      !m.facts.refuses(Cause::RadiusAndCentre))
    return std::nullopt;
  return fault_at('R', Cause::RadiusAndCentre, block);
}

bool has_radius(const BlockWords& block) { return block.words.has('R') && block.words['R'] != 0; }

}  // namespace

Result add_turns(MotionView m, const BlockWords& block, Piece& piece) {
  for (const char name : m.facts.control->motion.added_turns.value) {
    if (!block.words.has(name)) continue;
    const double turns = std::round(block.words[name]);
    if (turns < 0 || std::fabs(turns - block.words[name]) > 1e-3)
      return fault_at(name, Cause::ArcTurns, block);
    if (turns > kMostMoves) return fault_at(name, Cause::ValueOutOfRange, block);
    piece.turn += std::copysign(2 * kPi * turns, piece.turn);
  }
  return std::nullopt;
}

Result shape_arc(MotionView m, const BlockWords& block, Piece& piece, MotionOutcome& outcome) {
  const bool radius = has_radius(block);
  if (auto wrong = check_form(m, block)) return wrong;
  if (auto wrong = check_axes(m, block, piece.named, radius)) return wrong;
  return find_centre(m, block, radius, has_centre(block, plane_axes(m.state.plane)), piece,
                     outcome);
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one case after the other
Result arc(MotionContext& m, BlockWords& block, Meaning meaning) {
  const PlaneAxes plane = plane_axes(m.state.plane);
  const auto [written, named] = target(m, block);
  const Axes end = block.axis_extension == 0 ? written : lengthened(m, block, written, named);
  const bool centre = has_centre(block, plane);
  const bool radius = has_radius(block);
  const char angle = angle_name(m, block);
  if (auto wrong = check_form(m, block)) return wrong;
  if (angle != 0 && block.words.has('R')) return fault_at(angle, Cause::RadiusAndCentre, block);
  if (named == 0 && !centre && angle != 0) return fault_at(angle, Cause::NoArcTravel, block);
  if (named == 0 && !centre && !radius) return bare_arc(m, block);
  if (auto wrong = need_feed(m, block, meaning)) return wrong;
  if (auto wrong = check_longer(m, block, written, radius)) return wrong;
  if (auto wrong = check_axes(m, block, named, radius)) return wrong;
  if (m.facts.control->motion.drops_centre_across.value)
    m.outcome.drop(bit(centre_name(plane.across)));
  const bool clockwise = (meaning == Meaning::Cw) != mirrored_plane(m.state);
  Piece piece = make_piece(m, block, clockwise ? MoveKind::Cw : MoveKind::Ccw, end, named);
  piece.state.parallel = parallel_axes(m, named);
  if (auto wrong = corner_words(m, block, piece)) return wrong;
  if (auto wrong = check_parallel(m, block, piece)) return wrong;
  if (auto wrong = angle != 0 ? arc_by_angle(m, block, angle, centre, piece)
                              : find_centre(m, block, radius, centre, piece, m.outcome))
    return wrong;
  // R with the end at the start is no arc: only the move across the plane is left. [16TC p.67]
  const bool goes_across = (named & axis_bit(plane.across)) != 0;
  if (piece.corner != 0 && goes_across && m.facts.refuses(Cause::CornerHelix))
    return fault_at(m.facts.corner_name(piece), Cause::CornerHelix, block);
  if (piece.turn == 0 && piece.kind != MoveKind::Feed) {
    if (goes_across && m.facts.refuses(Cause::HelixTravel)) return fault(Cause::HelixTravel, block);
    piece.kind = MoveKind::Feed;
    m.outcome.axis_word = true;
    if (!goes_across) return std::nullopt;
  }
  return move(m, block, piece);
}

}  // namespace cncsub
