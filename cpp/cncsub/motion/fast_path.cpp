// The fast path: what it needs to know, and the arcs that go it.
#include "cncsub/motion/fast_path.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "cncsub/motion/emit.hpp"
#include "cncsub/motion/geometry.hpp"
#include "cncsub/motion/motion.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/words.hpp"

namespace cncsub {
namespace {

/// Whether the tool stands elsewhere than its offsets say: the next move takes it there.
bool tool_waits(const MotionState& state) {
  const Axes way = machine_point(state) - state.tool_at;
  return std::any_of(way.begin(), way.end(), [](double d) { return std::fabs(d) > 1e-9; });
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
  const Meaning motion = state.modal[at(Group::Motion)].meaning;
  const Meaning feed = state.modal[at(Group::Feed)].meaning;
  state.row_moves = nullptr;
  state.motion_code = 0;
  while (state.motion_code < facts.path_codes.size() &&
         facts.path_codes[state.motion_code].meaning != motion)
    ++state.motion_code;
  set_seconds_per_mm(state);
  state.plain = state.motion_code < facts.path_codes.size() && !in_cycle(state) &&
                !compensating(state) && !state.angled.waiting && state.held.corner.empty() &&
                state.held.radius.empty() && !state.held.engaged && feed != Meaning::InverseTime &&
                !polar(state) && !turned(state) && facts.limits.empty() && !checks_area(state) &&
                !state.surface && !lacks_speed(m) && !state.tool_pending && !tool_waits(state) &&
                !state.rigid_waits && facts.control->motion.max_feed.value == 0;
}

void Motion::take_code(int code) {
  state_.motion_code = static_cast<std::uint8_t>(code);
  state_.modal[at(Group::Motion)] = facts_->path_codes[static_cast<std::size_t>(code)];
}

void Motion::take_feed(double value) {
  value *= state_.unit;
  if (value == state_.feed) return;
  state_.feed = value;
  state_.row_moves = nullptr;
  set_seconds_per_mm(state_);
}

void Motion::new_row_state(Moves& moves) {
  if (moves.size() == 0) moves.begin(machine_point(state_), facts_->rapid, facts_->diameters);
  state_.row_state = moves.intern(move_state(state_), state_.offset + state_.length);
  state_.row_moves = &moves;
}

bool Motion::arc(std::uint32_t mask, const Cell* values, int g, std::uint32_t step, Moves* moves) {
  MotionState& s = state_;
  const int code = g >= 0 ? g : s.motion_code;
  if (!s.plain || code < 2 || facts_->lathe()) return false;
  const Control& c = *facts_->control;
  const PlaneAxes plane = plane_axes(s.plane);
  const auto word = [&](char address) {
    return (mask & bit(address)) != 0 ? (values++)->value : 0.0;
  };
  const bool has_feed = (mask & bit('F')) != 0;
  const double feed = word('F');
  if (!((has_feed ? feed : s.feed) > 0)) return false;
  std::array<double, 3> centre{}, end{};
  for (std::size_t i = 0; i < 3; ++i) centre[i] = word("IJK"[i]) * s.unit;
  for (std::size_t i = 0; i < 3; ++i) {
    const bool named = (mask & bit(kAxisNames[i])) != 0;
    const double value = word(kAxisNames[i]) * s.unit;
    end[i] = named && !s.incremental ? value : s.work[i] + value;
  }
  const auto a = static_cast<std::size_t>(plane.a), b = static_cast<std::size_t>(plane.b),
             across = static_cast<std::size_t>(plane.across);
  const bool helix = (mask & bit(kAxisNames[across])) != 0;
  if (centre[across] != 0 || (helix && c.motion.helix.value == Helix::Refused)) return false;
  const double i = centre[a], j = centre[b];
  const double ca = s.work[a] + i, cb = s.work[b] + j;
  const double first = std::hypot(i, j), last = std::hypot(end[a] - ca, end[b] - cb);
  if (first == 0 || is_off_circle(c.motion, first, last, s.unit != 1)) return false;
  const bool clockwise = code == 2;
  const bool full = std::hypot(end[a] - s.work[a], end[b] - s.work[b]) < 1e-9;
  const double turn =
      full ? 2 * kPi
           : turn_between(std::atan2(-j, -i), std::atan2(end[b] - cb, end[a] - ca), clockwise);
  const double in_plane = spiral_length(first, last, turn);

  if (code != s.motion_code) take_code(code);
  if (has_feed) take_feed(feed);
  if (moves != nullptr && s.row_moves != moves) new_row_state(*moves);
  std::copy(end.begin(), end.end(), s.work.begin());
  s.time += in_plane * s.seconds_per_mm;
  s.moved_before = true;
  s.named |= mask >> ('X' - 'A') & 7u;
  if (moves == nullptr) return true;
  moves->mark(mask >> ('X' - 'A') & 7u);
  moves->push(step, clockwise ? MoveKind::Cw : MoveKind::Ccw, s.work, s.row_state);
  centre[a] = ca;
  centre[b] = cb;
  centre[across] = std::numeric_limits<double>::quiet_NaN();
  moves->arc(centre, in_plane);
  return true;
}

namespace {

/// What a block of nothing but modes sets. `plain`: all of it is known to be that.
struct Modes {
  Modes(const MotionFacts& facts, const MotionState& state, const NcWords& words)
      : facts_(facts), state_(state) {
    plain = !words.has(Role::RigidTapping);
    for (int i = 0; i < words.g_count && plain; ++i)
      plain = take(facts.codes.find(words.g[static_cast<std::size_t>(i)]));
  }

  void set(MotionState& state) const {
    for (std::size_t i = 0; i < count_; ++i) state.modal[at(codes_[i].group)] = codes_[i];
    if (plane) state.plane = state.modal[at(Group::Plane)].code / 10;
    if (cycle_off) state.rigid = false;
    if (work) state.moved_before = true;  // as behind G54 that changes something
    state.incremental = state.modal[at(Group::Distance)].meaning == Meaning::Incremental;
  }

  bool plain = false;
  int path = -1;  // G00 to G03
  bool plane = false, cycle_off = false, work = false;

 private:
  bool take(const GCode& code) {
    if (code.meaning == Meaning::Neutral) return !state_.data_set && code.code != kDataEnd;
    for (std::size_t i = 0; i < count_; ++i)
      if (codes_[i].group == code.group) return false;
    codes_[count_++] = code;
    switch (code.group) {
      case Group::Motion:
        path = static_cast<int>(code.meaning) - static_cast<int>(Meaning::Rapid);
        return path >= 0 && path < 4 &&
               facts_.path_codes[static_cast<std::size_t>(path)].code == code.code;
      case Group::Plane:
        return plane = true;
      case Group::Distance:
      case Group::Return:
        return true;
      case Group::Work:
        return work = is_as_before(code) && code.meaning != Meaning::WorkExtra;
      case Group::Units:
        return is_as_before(code) &&
               facts_.control->motion.unit_change.value == UnitChange::Anywhere;
      case Group::Feed:
        return is_as_before(code);
      case Group::Radius:
        return code.meaning == Meaning::RadiusOff;
      case Group::Cycle:
        return cycle_off = code.meaning == Meaning::CycleOff;
      case Group::Length:
        return code.meaning == Meaning::LengthOff && !facts_.lathe() && state_.length == Axes{};
      default:
        return false;
    }
  }
  bool is_as_before(const GCode& code) const {
    return state_.modal[at(code.group)].meaning == code.meaning;
  }

  static constexpr std::int16_t kDataEnd = 110;  // alarms where no data were begun
  const MotionFacts& facts_;
  const MotionState& state_;
  std::array<GCode, 12> codes_{};
  std::size_t count_ = 0;
};

/// What modes change, before they do: an arc may still want the general path.
struct Before {
  explicit Before(const MotionState& s)
      : modal(s.modal),
        row_moves(s.row_moves),
        seconds_per_mm(s.seconds_per_mm),
        speed(s.speed),
        plane(s.plane),
        t(s.t),
        tool(s.tool),
        incremental(s.incremental),
        turns(s.turns),
        rigid(s.rigid),
        moved_before(s.moved_before) {}
  void put_back(MotionState& s) const {
    s.modal = modal;
    s.row_moves = row_moves;
    s.seconds_per_mm = seconds_per_mm;
    s.speed = speed;
    s.plane = plane;
    s.t = t;
    s.tool = tool;
    s.moved_before = moved_before;
    s.incremental = incremental;
    s.turns = turns;
    s.rigid = rigid;
  }

  std::array<GCode, kGroups> modal;
  const Moves* row_moves;
  double seconds_per_mm, speed;
  int plane, t, tool;
  bool incremental, turns, rigid, moved_before;
};

constexpr std::uint32_t kEnds = bit('X') | bit('Y') | bit('Z');
constexpr std::uint32_t kCentres = bit('I') | bit('J') | bit('K');

}  // namespace

bool Motion::modes(const NcWords& words, std::uint32_t step, Moves* moves, Outcome& outcome) {
  MotionState& s = state_;
  const std::uint32_t path_words = words.mask & (kEnds | kCentres | bit('F'));
  const std::uint32_t others = bit('S') | (facts_->lathe() ? 0 : bit('T'));
  if (!s.plain || words.stops || (words.mask & ~(path_words | others)) != 0) return false;
  const bool has_feed = words.has('F'), has_speed = words.has('S');
  if ((has_feed && !(words['F'] > 0)) || (has_speed && !(words['S'] > 0))) return false;
  if ((words.whole & bit('F')) != 0 &&
      facts_->control->reading.whole_numbers.value == WholeNumbers::Increments)
    return false;
  const Modes modes(*facts_, s, words);
  if (!modes.plain) return false;
  const int path = modes.path >= 0 ? modes.path : s.motion_code;
  const bool moves_on = (words.mask & (kEnds | kCentres)) != 0;
  if (moves_on && path < 2 && (words.has('I') || words.has('J') || words.has('K'))) return false;
  if (moves_on && path != 0 && !has_feed && !(s.feed > 0)) return false;

  std::array<Cell, 7> values{};
  std::size_t count = 0;
  for (std::uint32_t left = path_words; left != 0; left &= left - 1) {
    const char address = static_cast<char>('A' + std::countr_zero(left));
    values[count++].value = address == 'F' ? words['F'] : in_units(view(), words, address);
  }
  const Before before(s);
  modes.set(s);
  if (words.has('T')) s.t = whole(words['T']);
  for (int i = 0; i < words.m_count; ++i)
    take_spindle(s, facts_->control->calls.roles.value.of_m(words.m[static_cast<std::size_t>(i)]));
  if (has_speed) s.speed = words['S'];
  if (has_speed || modes.plane || s.tool != before.tool) s.row_moves = nullptr;
  if (has_speed) set_seconds_per_mm(s);
  outcome = {};
  if (!moves_on) {
    if (modes.path >= 0) take_code(modes.path);
    if (has_feed) take_feed(words['F']);
    return true;
  }
  const bool done = path < 2 ? linear(path_words, values.data(), path, step, moves, outcome.moved)
                             : arc(path_words, values.data(), path, step, moves);
  if (!done) before.put_back(s);
  if (path > 1) outcome.moved = done;
  outcome.axis_word = done;
  outcome.moves = 1;
  return done;
}

}  // namespace cncsub
