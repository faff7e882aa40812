// The meanings of a block's words, and the modes that they set.
#include "cncsub/motion/state/modes.hpp"

#include <utility>

#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/cycle/cycles.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {

Result set_feed(MotionContext& m, const BlockWords& block) {
  const Control& c = *m.facts.control;
  if (!block.words.has('F')) {
    if (feed_of_each_cut(m)) m.state.feed = 0;
    return std::nullopt;
  }
  if (takes_word(m, block, 'F')) return std::nullopt;
  if (c.turning.lead_apart.value && cuts_thread(m.state, block)) return std::nullopt;
  const Meaning once = block.meaning(Group::OneShot);
  if (c.motion.skip_own_feed.value && (once == Meaning::Skip || once == Meaning::MeasureTool))
    return std::nullopt;
  return feed_of(m, block, m.state.feed);
}

namespace {

/// Execute the M codes. After a tool change that comes before a move has led from the compensation
/// to the path, the control counts on from where the tool stands. [rs274 2.9]
void take_codes(MotionContext& m, const BlockWords& block) {
  if (block.words.has(Role::ToolChange)) change_tool(*m.facts.control, m.state);
  for (const int code : block.words.codes->m())
    take_spindle(m.state, m.facts.control->calls.roles.value.of_m(code));
  if (m.state.lookahead.ended && block.words.has(Role::ToolChange))
    m.state.work = m.state.tool_at - m.state.offset - m.state.length;
}

/// Take the limit of the spindle speed that has a word of its own.
Result set_speed_limit(MotionContext& m, const BlockWords& block) {
  if (m.facts.control->motion.speed_limit.value != SpeedLimit::OwnWord || !block.words.has('L'))
    return std::nullopt;
  if (block.words['L'] < 0) return fault_at('L', Cause::SpeedLimitNegative, block);
  m.state.max_speed = block.words['L'];
  return std::nullopt;
}

/// Check S, and that a surface speed is known where its code comes.
Result check_speed(MotionView m, const BlockWords& block) {
  const MotionState& s = m.state;
  const bool written = block.words.has('S') && !takes_word(m, block, 'S');
  const double speed = s.surface ? s.surface_speed : s.speed;
  if (written && (speed < 0 || (speed == 0 && s.surface)) &&
      m.facts.refuses(Cause::ValueOutOfRange))
    return fault_at('S', Cause::ValueOutOfRange, block,
                    s.surface ? "a surface speed is above zero" : "a speed is not below zero");
  if (s.surface && s.surface_speed <= 0 && m.facts.refuses(Cause::NoSurfaceSpeed))
    return fault_at({.groups = bit(Group::Surface)}, Cause::NoSurfaceSpeed, block);
  return std::nullopt;
}

Result set_spindle(MotionContext& m, const BlockWords& block) {
  const SpeedLimit limit = m.facts.control->motion.speed_limit.value;
  if (limit == SpeedLimit::OfSurface && block.meaning(Group::Surface) == Meaning::SurfaceSpeed)
    m.state.max_speed = block.words['D'];  // without D it has no limit
  if (block.words.has('S') && !takes_word(m, block, 'S')) {
    const double value = block.words['S'];
    if (limit == SpeedLimit::OfCoordinates &&
        block.meaning(Group::OneShot) == Meaning::SetCoordinate)
      m.state.max_speed = value;
    else
      (m.state.surface ? m.state.surface_speed : m.state.speed) = value;
  }
  if (auto wrong = set_speed_limit(m, block)) return wrong;
  if (auto wrong = check_speed(m, block)) return wrong;
  take_codes(m, block);
  if (block.words.has(Role::RigidTapping)) m.state.rigid_waits = m.facts.refuses(Cause::RigidMove);
  if (block.has(Group::Cycle)) m.state.rigid = std::exchange(m.state.rigid_waits, false);
  return std::nullopt;
}

}  // namespace

Result read_codes(MotionContext& m, const BlockWords& block) {
  const BlockCodes& codes = *block.words.codes;
  m.outcome.dropped_codes |= codes.dropped;
  if (codes.data_end >= 0 && !m.state.data_set)
    return fault_of(codes.data_end, Cause::DataEndFirst, block);
  return codes.wrong < 0 ? Result() : fault_of(codes.wrong, codes.why, block);
}

Result check_block(MotionView m, const BlockWords& block) {
  const Control& c = *m.facts.control;
  if ((block.words.whole >> kPointedH & 1) != 0 && m.facts.machine != MachineType::LatheA)
    return fault_at('H', Cause::IllegalDecimalPoint, block, "H cannot have a decimal point");
  if (block.has(Group::Units) && c.motion.unit_change.value != UnitChange::Anywhere) {
    const bool shares =
        c.motion.unit_change.value == UnitChange::Alone && block.words.codes->g_count > 1;
    if (m.state.moved_before || shares || (block.words.mask & ~bit('N')) != 0)
      return fault_at({.groups = bit(Group::Units)}, Cause::UnitChangeLate, block);
  }
  if ((block.words.mask & kPolarWords) != 0)
    if (auto wrong = check_polar_words(m, block)) return wrong;
  if (!m.state.lookahead.corner.empty() && block.has(Group::Plane))
    return fault_at({.groups = bit(Group::Plane)}, Cause::CornerPlane, block);
  if (compensating(m.state) && block.has(Group::Plane) &&
      plane_of(block.meaning(Group::Plane)) != m.state.plane)
    return fault_at({.groups = bit(Group::Plane)}, Cause::CompensationPlane, block);
  return check_conflicts(m, block);
}

namespace {

/// Delete the feed where its mode is not the one before any more, and the control deletes it then.
void delete_feed(MotionContext& m, Meaning before) {
  if (m.facts.control->motion.feed_mode_change.value == FeedModeChange::DeletesFeed &&
      m.state.modal[at(Group::Feed)].meaning != before)
    m.state.feed = 0;
}

/// Set the mode of G93, G94 and G95.
void set_feed_mode(MotionContext& m, const BlockWords& block) {
  if (!block.has(Group::Feed)) return;
  const Meaning before = m.state.modal[at(Group::Feed)].meaning;
  remember(m.state, *block.words.codes, bit(Group::Feed));
  delete_feed(m, before);
  if (m.facts.control->motion.feed_mode_change.value != FeedModeChange::EndsFeed) return;
  if (block.meaning(Group::Feed) != Meaning::InverseTime)
    m.state.feed_before = 0;
  else if (before != Meaning::InverseTime)
    m.state.feed_before = m.state.feed;
  m.state.feed = 0;
}

}  // namespace

/// Set the mode of the feed that a code of the spindle brings, and end the surface speed where a
/// mode of the feed does. [SONE p.99; 840De p.7-40]
static void set_feed_by_spindle(MotionContext& m, const BlockWords& block) {
  GCode& surface = m.state.modal[at(Group::Surface)];
  if (surface.variant == 0) return;
  GCode& feed = m.state.modal[at(Group::Feed)];
  const Meaning before = feed.meaning;
  if (block.has(Group::Surface)) {
    feed = m.facts.codes.of(surface.variant == 1 ? Meaning::PerRevolution : Meaning::PerMinute);
    delete_feed(m, before);
  } else if (block.has(Group::Feed)) {
    surface = {};
  }
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one case after the other
Result set_modes(MotionContext& m, BlockWords& block) {
  constexpr std::uint32_t kRemembered =
      bit(Group::Plane) | bit(Group::Distance) | bit(Group::Stroke) | bit(Group::Units) |
      bit(Group::Return) | bit(Group::Macro) | bit(Group::Surface) | bit(Group::Path) |
      bit(Group::Turret) | bit(Group::Fluctuation) | bit(Group::PolarMilling) | bit(Group::Centre) |
      bit(Group::Diameter) | bit(Group::Corner);
  const bool feed_first =
      block.has(Group::Units) && m.facts.control->motion.feed_unit.value == FeedUnit::BeforeBlock;
  set_feed_mode(m, block);
  if (feed_first)
    if (auto wrong = set_feed(m, block)) return wrong;
  remember(m.state, *block.words.codes, kRemembered);
  set_feed_by_spindle(m, block);
  if (block.has(Group::Plane)) m.state.plane = plane_of(block.meaning(Group::Plane));
  const bool surface = m.state.modal[at(Group::Surface)].meaning == Meaning::SurfaceSpeed;
  // G97 without S keeps the speed that there is. [TDi 25 note 4]
  if (m.state.surface && !surface && (m.state.work[0] != 0 || m.state.max_speed > 0))
    if (const double last = spindle_at(move_state(m.state), diameter_now(m)); last > 0)
      m.state.speed = last;
  m.state.surface = surface;
  take_units(m.facts, m.state);
  m.state.incremental = m.state.modal[at(Group::Distance)].meaning == Meaning::Incremental;
  if (block.meaning(Group::Stroke) == Meaning::StrokeOn) {
    if (auto wrong = set_area(m, block)) return wrong;
  }
  if (!feed_first)
    if (auto wrong = set_feed(m, block)) return wrong;
  set_lead(m, block);
  if (auto wrong = set_tool(m, block)) return wrong;  // T1 M06 changes to tool 1 [source 003]
  if (auto wrong = set_spindle(m, block)) return wrong;
  if (m.facts.control->motion.tool_edges.value)
    if (auto wrong = set_edge(m, block)) return wrong;
  if (auto wrong = select_work(m, block)) return wrong;
  if (block.has(Group::Polar)) {
    m.state.modal[at(Group::Polar)] = block.code(Group::Polar);
    m.state.polar_known = false;
  }
  return (block.words.codes->groups & kTurning) != 0 ? set_turned(m, block) : std::nullopt;
}

void change_tool(const Control& control, MotionState& state) {
  state.tool = state.t;
  if (control.motion.spindle_at_change.value == SpindleAtChange::Stopped) state.turns = false;
}

void take_spindle(MotionState& state, Role role) {
  switch (role) {
    case Role::SpindleForward:
    case Role::SpindleBackward:
      state.turns = true;
      state.backward = role == Role::SpindleBackward;
      break;
    case Role::SpindleStop:
      state.turns = false;
      break;
    default:
      break;
  }
}

}  // namespace cncsub
