// The fast path: what it needs to know, and the arcs that go it.
#include "cncsub/motion/fast_path.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "cncsub/motion/changed_frame.hpp"
#include "cncsub/motion/emit.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/geometry.hpp"
#include "cncsub/motion/motion.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/plain_line.hpp"
#include "cncsub/motion/words.hpp"
#include "cncsub/system/compiler.hpp"

namespace cncsub {
namespace {

constexpr std::uint32_t kArcWords = kCentreWords | bit('R');

/// Whether the tool stands elsewhere than its offsets say: the next move takes it there.
bool tool_waits(const MotionState& state) {
  const Axes at = machine_point(state);
  if (same_bits(at, state.tool_at)) return false;
  const Axes way = at - state.tool_at;
  return std::any_of(way.begin(), way.end(), [](double d) { return std::fabs(d) >= kStanding; });
}

/// Whether a code that is no plain path leaves nothing to a move behind it that has its own code.
bool leaves_nothing(Meaning motion) {
  switch (motion) {
    case Meaning::Thread:
    case Meaning::VariableThread:
    case Meaning::TurnCycle:
    case Meaning::ThreadCycle:
    case Meaning::FaceCycle:
    case Meaning::TapCycle:
      return true;
    default:
      return false;
  }
}

/// Zero while there is no feed.
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
  const bool moves_alone =
      !facts.general_only && (path >= 0 || leaves_nothing(motion)) && !in_cycle(state) &&
      !state.angled.waiting() && state.held.corner.empty() && !polar(state) &&
      facts.limits.empty() && !checks_area(state) && !lacks_speed(m) && !state.tool_pending &&
      !state.rigid_waits && facts.control->motion.max_feed.value == 0 && state.frame_angle == 0 &&
      !state.diameter && !state.no_motion && !centre_is_absolute(state) && !feed_of_each_cut(m);
  const bool beside = compensating(state) || state.held.engaged || !state.held.radius.empty();
  state.beside = moves_alone && beside;
  state.direct = moves_alone && !beside && !tool_waits(state);
  state.plain = state.direct && !turned(state) && !state.surface &&
                state.modal[at(Group::Feed)].meaning != Meaning::InverseTime;
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

/// A plain arc as it is checked, before anything changes: work coordinates.
struct PlainArc {
  bool clockwise = false;
  std::array<double, 3> end{}, centre{};
  double in_plane = 0;  // its length there
};

/// The centre of an arc with a radius that its end is within.
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

/// The arc that these words describe, `values` in the order of the alphabet and without that of F.
/// False where the general path has something to say about it.
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
  if (arc.centre[across] != 0 || (helix && rules.helix.value == Helix::Refused)) return false;
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
  MotionState& s = state_;
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

namespace {

/// What the codes of a block set that are nothing but modes.
struct Modes {
  explicit Modes(const MotionState& state, const BlockCodes& of)
      : codes(of),
        path(of.has(Group::Motion) ? path_of(of.meaning(Group::Motion)) : -1),
        plane(of.has(Group::Plane) ? plane_of(of.meaning(Group::Plane)) : state.plane),
        incremental(of.has(Group::Distance) ? of.meaning(Group::Distance) == Meaning::Incremental
                                            : state.incremental) {}

  void set(const MotionFacts& facts, MotionState& state) const {
    remember(state, codes, ~bit(Group::OneShot));
    if (plane != state.plane || codes.has(Group::Units)) state.row_moves = nullptr;
    if (codes.has(Group::Units)) state.unit = unit_of(facts, codes.meaning(Group::Units));
    state.plane = plane, state.incremental = incremental;
    if (codes.has(Group::Cycle)) state.rigid = false;
    if (codes.has(Group::Work)) state.moved_before = true;  // as behind G54 that changes something
  }

  const BlockCodes& codes;
  int path;  // G00 to G03, -1: none
  Plane plane;
  bool incremental;
};

/// Whether the codes are nothing but modes here: of these groups what holds already, but for a unit
/// that changes where no word counts in it. What turns points stands in the way of more.
bool are_modes(const MotionState& state, const NcWords& words) {
  const BlockCodes& codes = *words.codes;
  constexpr std::uint32_t kTurned = bit(Group::Motion) | bit(Group::Distance);
  if (turned(state) && ((codes.groups & ~kTurned) != 0 || codes.m_count > 0)) return false;
  if (codes.has(Role::RigidTapping)) return false;
  for (const Group group : {Group::Work, Group::Feed, Group::Units})
    if ((group != Group::Units || words.mask != 0) && codes.has(group) &&
        codes.meaning(group) != state.modal[at(group)].meaning)
      return false;
  return true;
}

/// Whether the words other than G and M codes are those of a plain move, S and T, with values that
/// the general path has nothing to say about. `speeds`: S may stand with a plain move.
bool has_plain_words(const MotionFacts& facts, const NcWords& words, bool speeds) {
  const std::uint32_t known = kEndWords | kArcWords | bit('F') | bit('S') |
                              (facts.lathe() ? 0 : bit('T')) | words_of_frame(words);
  const std::uint32_t others = words.mask & (facts.other_axes | facts.increments);
  if ((others != 0 || !speeds) && words.has('S')) return false;
  if (words.stops || (words.mask & ~(known | others)) != 0) return false;
  if (words.has('S') && !(words['S'] > 0)) return false;
  return has_plain_values(facts, words);
}

/// What the T, M and S of a block set.
void set_tool_and_spindle(MotionState& s, const Control& control, const NcWords& words) {
  const Roles& roles = control.calls.roles.value;
  const int tool = s.tool;
  if (words.has('T')) s.t = whole(std::round(words['T']));
  if (words.has(Role::ToolChange)) change_tool(control, s);
  for (const int code : words.codes->m()) take_spindle(s, roles.of_m(code));
  if (words.has('S')) {
    s.speed = words['S'];
    set_seconds_per_mm(s);
  }
  if (words.has('S') || s.tool != tool) s.row_moves = nullptr;
}

/// The values of the letters of a mask, in the order of the alphabet.
std::array<Cell, 8> values_of(MotionView m, const NcWords& words, std::uint32_t letters) {
  std::array<Cell, 8> values{};
  std::size_t count = 0;
  for (; letters != 0; letters &= letters - 1) {
    const char address = static_cast<char>('A' + std::countr_zero(letters));
    values[count++].value = address == 'F' ? words['F'] : in_units(m, words, address);
  }
  return values;
}

/// Whether a straight move may have these values: where it leads to is not asked., see
/// Builder::words
bool are_small(const std::array<Cell, 8>& values) {
  constexpr double kMost = 1e30;
  return std::all_of(values.begin(), values.end(),
                     [](const Cell& of) { return std::fabs(of.value) <= kMost; });
}

/// A block of the fast path before anything changes: how it moves, and along what.
struct PlainBlock {
  enum class Way : std::uint8_t { None, Straight, OtherAxes, Arc } way = Way::None;
  int path = 0;               // G00 to G03
  std::uint32_t letters = 0;  // of a plain move, and F
  std::array<Cell, 8> values{};
  double feed = 0;  // mm/min, mm/rev
  PlainArc arc;
  PlainLine line;

  MoveKind kind() const { return path == 0 ? MoveKind::Rapid : MoveKind::Feed; }  // of a line
};

/// False where the general path has something to say about it.
bool plan_block(MotionView m, const Modes& modes, const NcWords& words, PlainBlock& block) {
  using Way = PlainBlock::Way;
  const MotionState& s = m.state;
  const std::uint32_t others = words.mask & (m.facts.other_axes | m.facts.increments);
  block.path = modes.path >= 0 ? modes.path : s.motion_code;
  if (block.path == kOtherPath) return false;
  block.letters = words.mask & (kEndWords | kArcWords | bit('F'));
  block.feed = words.has('F') ? plain_feed(s, words['F']) : s.feed;
  block.values = values_of(m, words, block.letters);
  if (((block.letters | others) & ~bit('F')) == 0) return true;
  if (block.path != 0 && !(block.feed > 0)) return false;
  if (block.path > 1) {
    block.way = Way::Arc;
    block.arc.clockwise = block.path == 2;
    const bool both = (block.letters & bit('R')) != 0 && (block.letters & kCentreWords) != 0;
    return others == 0 && !both && !m.facts.lathe() && s.plain &&
           plan_arc(m.facts, s, block.letters, block.values.data() + words.has('F'), modes.plane,
                    modes.incremental, block.arc);
  }
  if ((block.letters & kArcWords) != 0) return false;
  block.way = others == 0 && s.plain ? Way::Straight : Way::OtherAxes;
  if (block.way == Way::Straight) return are_small(block.values);
  return plan_line(m, words, block.kind(), modes.incremental ? nullptr : &kOrigin, block.feed,
                   block.line);
}

/// G53 with a rapid.
bool plan_machine_move(MotionView m, const Modes& modes, const NcWords& words, PlainBlock& block) {
  const MotionState& s = m.state;
  block.path = modes.path >= 0 ? modes.path : s.motion_code;
  const bool axes = (words.mask & (kEndWords | m.facts.other_axes)) != 0 &&
                    (words.mask & ~(kEndWords | m.facts.other_axes)) == 0;
  const bool homed = m.facts.homed || !m.facts.refuses(Cause::NotHomed);
  if (block.path != 0 || !axes || !homed || modes.incremental || !s.plain || s.length != Axes{})
    return false;
  if (check_conflicts(m, {.words = words, .step = 0})) return false;
  block.way = PlainBlock::Way::OtherAxes;
  const Axes zero = Axes{} - s.offset;
  return plan_line(m, words, MoveKind::Rapid, &zero, s.feed, block.line);
}

}  // namespace

bool Motion::modes(const NcWords& words, std::uint32_t step, Moves* moves, Outcome& outcome) {
  const MotionState& s = state_;
  if (s.beside) return move_alone(words, step, moves, outcome);
  if (!s.direct || !words.codes->plain) return false;
  return changes_frame(s, words) ? in_changed_frame(words, step, moves, outcome)
                                 : plain_modes(words, s.plain, step, moves, outcome);
}

bool Motion::plain_modes(const NcWords& words, bool speeds, std::uint32_t step, Moves* moves,
                         Outcome& outcome) {
  using Way = PlainBlock::Way;
  MotionState& s = state_;
  if (!are_modes(s, words) || !has_plain_words(*facts_, words, speeds)) return false;
  if (words.codes->has(Group::Cycle) && facts_->refuses(Cause::NoMotionCode)) return false;
  if (turned(s) && check_conflicts(view(), {.words = words, .step = step})) return false;
  const Modes modes(s, *words.codes);
  PlainBlock block;
  const bool machine = words.codes->meaning(Group::OneShot) == Meaning::Machine;
  if (!(machine ? plan_machine_move : plan_block)(view(), modes, words, block))
    return block.way == Way::Arc && facts_->lathe() && move_alone(words, step, moves, outcome);

  modes.set(*facts_, s);
  set_tool_and_spindle(s, *facts_->control, words);

  outcome = {};
  const bool moves_on = block.way != Way::None;
  if (moves_on) outcome.moved = outcome.axis_word = true, outcome.moves = 1;
  if (block.way == Way::Straight)
    return linear(block.letters, block.values.data(), block.path, step, moves, outcome.moved);
  if (moves_on || modes.path >= 0) take_code(*facts_, state_, block.path);
  if (words.has('F')) take_feed(state_, words['F']);
  if (block.way == Way::Arc) go_along(*facts_, s, block.arc, block.letters, step, moves);
  if (block.way == Way::OtherAxes) {
    outcome.moved = block.line.moved;
    go_along(*facts_, s, block.line, block.kind(), step, moves);
  }
  return true;
}

}  // namespace cncsub
