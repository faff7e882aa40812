// The fast path: its conditions, and its arcs.
#include "cncsub/motion/fast_path.hpp"

#include <algorithm>
#include <limits>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/motion.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/path/geometry.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/system/compiler.hpp"

namespace cncsub {
namespace {

/// Return whether the tool stands elsewhere than its offsets say: the next move takes it there.
bool tool_waits(const MotionState& state) {
  const Axes at = machine_point(state);
  if (same_bits(at, state.tool_at)) return false;
  const Axes way = at - state.tool_at;
  return std::any_of(way.begin(), way.end(), [](double d) { return std::fabs(d) >= kStanding; });
}

/// Return whether a code that is no plain path leaves nothing to a move after it with its own code.
bool leaves_nothing(Meaning motion) {
  return motion == Meaning::Thread || motion == Meaning::VariableThread || is_simple_cycle(motion);
}

/// Set the seconds per mm, zero while there is no feed.
void set_seconds_per_mm(MotionState& state) {
  const bool revolutions = state.modal[at(Group::Feed)].meaning == Meaning::PerRevolution;
  state.seconds_per_mm =
      state.feed > 0 ? 60 / (revolutions ? state.feed * turning(state.speed) : state.feed) : 0;
}

}  // namespace

void prepare_fast_path(const MotionFacts& facts, MotionState& state) {
  const MotionView m{facts, state};
  if (state.plain) state.tool_at = machine_point(state);
  settle_origin(state);
  const Meaning motion = state.modal[at(Group::Motion)].meaning;
  const int path = path_of(motion);
  state.row_moves = nullptr;
  state.motion_code = path >= 0 ? static_cast<std::uint8_t>(path) : kOtherPath;
  set_seconds_per_mm(state);
  const bool waits = compensating(state) || state.lookahead.engaged ||
                     !state.lookahead.radius.empty() || tool_waits(state);
  state.plain =
      !facts.general_only && !waits && (path >= 0 || leaves_nothing(motion)) && !in_cycle(state) &&
      !state.pending_angle.waiting() && state.lookahead.corner.empty() && !polar(state) &&
      facts.limits.empty() && !checks_area(state) && !lacks_speed(m) && !state.tool_pending &&
      !state.rigid_waits && facts.control->motion.max_feed.value == 0 && state.frame_angle == 0 &&
      !state.diameter && !state.no_motion && !centre_is_absolute(state) && !feed_of_each_cut(m) &&
      !is_turned(state) && state.modal_round == 0 && same_bits(state.unmoved, Axes{}) &&
      !state.surface && state.modal[at(Group::Feed)].meaning != Meaning::InverseTime;
}

void take_code(const MotionFacts& facts, MotionState& state, int code) {
  if (state.motion_code == kOtherPath) state.turn = {};  // as in take_motion_code
  state.motion_code = static_cast<std::uint8_t>(code);
  state.modal[at(Group::Motion)] = facts.path_codes[static_cast<std::size_t>(code)];
}

void take_feed(MotionState& state, double value) {
  value = plain_feed(state, value);
  if (value == state.feed) return;
  state.feed = value;
  state.row_moves = nullptr;
  set_seconds_per_mm(state);
}

void begin_row_state(const MotionFacts& facts, MotionState& state, Moves& moves) {
  if (moves.size() == 0)
    moves.begin(state.plain ? machine_point(state) : state.tool_at, facts.rapid, facts.diameters);
  state.row_state = moves.intern(move_state(state), state.offset + state.length);
  state.row_moves = &moves;
}

namespace {

/// A plain arc that is checked before anything changes, in work coordinates.
struct PlainArc {
  bool clockwise = false;
  std::array<double, 3> end{}, centre{};
  double in_plane = 0;  // its length there
};

/// Find the centre of an arc by its radius. Return false where the radius does not reach the end,
/// or may not be negative.
bool find_centre(const MotionFacts& facts, Point way, double radius, const PlaneAxes& plane,
                 PlainArc& arc) {
  const double chord = size(way);
  if (chord < kStanding || !(chord <= 2 * std::fabs(radius))) return false;
  if (radius < 0 && !takes_negative_radius(facts)) return false;
  const Point centre = centre_by_radius(way, radius, arc.clockwise);
  arc.centre[static_cast<std::size_t>(plane.a)] = centre.a;
  arc.centre[static_cast<std::size_t>(plane.b)] = centre.b;
  return true;
}

/// Plan the arc that these words describe, `values` in the order of the alphabet and without that
/// of F. Return false where the general path has something to say about it.
CNCSUB_ALWAYS_INLINE inline bool plan_arc(const MotionFacts& facts, const MotionState& s,
                                          std::uint32_t mask, const Cell* values, Plane of_plane,
                                          bool incremental, PlainArc& arc) {
  const MotionRules& rules = facts.control->motion;
  const PlaneAxes plane = plane_axes(of_plane);
  const auto word = [&](char address) {
    return (mask & bit(address)) != 0 ? (values++)->value : 0.0;
  };
  for (std::size_t i = 0; i < 3; ++i) arc.centre[i] = word("IJK"[i]) * s.unit;
  const double radius = word('R') * s.unit;
  for (std::size_t i = 0; i < 3; ++i) {
    const bool named = (mask & bit(kAxisNames[i])) != 0;
    const double value = word(kAxisNames[i]) * s.unit;
    arc.end[i] = named && !incremental ? value : s.work[i] + value;
  }
  const auto a = static_cast<std::size_t>(plane.a), b = static_cast<std::size_t>(plane.b),
             across = static_cast<std::size_t>(plane.across);
  const bool helix = (mask & bit(kAxisNames[across])) != 0;
  const bool off_plane = (mask & bit("IJK"[across])) != 0;
  if (off_plane || (helix && rules.helix.value == Helix::Refused)) return false;
  if ((mask & bit('R')) != 0 &&
      !find_centre(facts, {arc.end[a] - s.work[a], arc.end[b] - s.work[b]}, radius, plane, arc))
    return false;
  const double i = arc.centre[a], j = arc.centre[b];
  const double ca = s.work[a] + i, cb = s.work[b] + j;
  const double first = std::hypot(i, j), last = std::hypot(arc.end[a] - ca, arc.end[b] - cb);
  if (has_no_radius(rules, first, last) || is_off_circle(rules, first, last, s.unit != 1))
    return false;
  const bool full = std::hypot(arc.end[a] - s.work[a], arc.end[b] - s.work[b]) < kStanding;
  const double turn =
      full ? 2 * kPi
           : turn_between(std::atan2(-j, -i), std::atan2(arc.end[b] - cb, arc.end[a] - ca),
                          arc.clockwise);
  arc.in_plane = spiral_length(first, last, turn);
  arc.centre[a] = ca;
  arc.centre[b] = cb;
  arc.centre[across] = std::numeric_limits<double>::quiet_NaN();
  return true;
}

CNCSUB_ALWAYS_INLINE inline void go_along(const MotionFacts& facts, MotionState& s,
                                          const PlainArc& arc, std::uint32_t mask,
                                          std::uint32_t step, Moves* moves) {
  if (moves != nullptr && s.row_moves != moves) begin_row_state(facts, s, *moves);
  s.time += arc.in_plane * s.seconds_per_mm;
  s.moved_before = true;
  s.named |= straight_axes(mask);
  std::copy(arc.end.begin(), arc.end.end(), s.work.begin());
  if (moves == nullptr) return;
  moves->mark(straight_axes(mask));
  moves->push(step, arc.clockwise ? MoveKind::Cw : MoveKind::Ccw, s.work, s.row_state);
  moves->arc(arc.centre, arc.in_plane);
}

}  // namespace

bool Motion::arc(std::uint32_t mask, const Cell* values, int g, std::uint32_t step, Moves* moves) {
  MotionState& s = now();
  const int code = g >= 0 ? g : s.motion_code;
  if (!s.plain || (code != 2 && code != 3) || facts_->lathe()) return false;
  const bool has_feed = (mask & bit('F')) != 0;
  const double feed = has_feed ? (values++)->value : s.feed;
  PlainArc arc{.clockwise = code == 2};
  if (!(feed > 0) || !plan_arc(*facts_, s, mask, values, s.plane, s.incremental, arc)) return false;

  if (code != s.motion_code) take_code(*facts_, s, code);
  if (has_feed) take_feed(s, feed);
  go_along(*facts_, s, arc, mask, step, moves);
  return true;
}

}  // namespace cncsub
