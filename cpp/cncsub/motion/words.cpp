// The meanings of a block's words, and the modes that they set.
#include "cncsub/motion/words.hpp"

#include <utility>

#include "cncsub/motion/cycle/cycles.hpp"
#include "cncsub/motion/emit.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/path.hpp"

namespace cncsub {
bool takes_word(MotionView m, const BlockWords& block, char letter) {
  const MotionRules& rules = m.facts.control->motion;
  if (block.meaning(Group::OneShot) == Meaning::Dwell)
    return rules.dwell_words.value.has(letter) || rules.dwell_turn_words.value.has(letter);
  return letter == 'D' && rules.speed_limit.value == SpeedLimit::OfSurface &&
         block.meaning(Group::Surface) == Meaning::SurfaceSpeed;
}

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

/// M codes. After a change of the tool a control whose compensation G40 let go counts on from where
/// the tool stands. [rs274 2.9]
void take_codes(MotionContext& m, const BlockWords& block) {
  if (block.words.has(Role::ToolChange)) change_tool(*m.facts.control, m.state);
  for (const int code : block.words.codes->m())
    take_spindle(m.state, m.facts.control->calls.roles.value.of_m(code));
  if (m.state.held.ended && block.words.has(Role::ToolChange))
    m.state.work = m.state.tool_at - m.state.offset - m.state.length;
}

void set_spindle(MotionContext& m, const BlockWords& block) {
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
  take_codes(m, block);
  if (block.words.has(Role::RigidTapping)) m.state.rigid_waits = m.facts.refuses(Cause::RigidMove);
  if (block.has(Group::Cycle)) m.state.rigid = std::exchange(m.state.rigid_waits, false);
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
    return fault_at('H', Cause::IllegalDecimalPoint, block, "H takes no decimal point");
  if (block.has(Group::Units) && c.motion.unit_change.value != UnitChange::Anywhere) {
    const bool shares =
        c.motion.unit_change.value == UnitChange::Alone && block.words.codes->g_count > 1;
    if (m.state.moved_before || shares || (block.words.mask & ~bit('N')) != 0)
      return fault(Cause::UnitChangeLate, block);
  }
  if ((block.words.mask & kPolarWords) != 0)
    if (auto wrong = check_polar_words(m, block)) return wrong;
  if (!m.state.held.corner.empty() && block.has(Group::Plane))
    return fault(Cause::CornerPlane, block);
  if (compensating(m.state) && block.has(Group::Plane) &&
      plane_of(block.meaning(Group::Plane)) != m.state.plane)
    return fault(Cause::CompensationPlane, block);
  return check_conflicts(m, block);
}

double unit_of(const MotionFacts& facts, Meaning units) {
  return units == Meaning::Inch ? kInch : units == Meaning::Pulses ? facts.increment : 1;
}

namespace {

/// G93, G94 and G95.
void set_feed_mode(MotionContext& m, const BlockWords& block) {
  if (!block.has(Group::Feed)) return;
  const Meaning before = m.state.modal[at(Group::Feed)].meaning;
  remember(m.state, *block.words.codes, bit(Group::Feed));
  if (m.facts.control->motion.feed_mode_change.value != FeedModeChange::EndsFeed) return;
  if (block.meaning(Group::Feed) != Meaning::InverseTime)
    m.state.feed_before = 0;
  else if (before != Meaning::InverseTime)
    m.state.feed_before = m.state.feed;
  m.state.feed = 0;
}

}  // namespace

bool feed_of_each_cut(MotionView m) {
  return m.facts.control->motion.feed_mode_change.value == FeedModeChange::EndsFeed &&
         m.state.modal[at(Group::Feed)].meaning == Meaning::InverseTime;
}

Result set_modes(MotionContext& m, BlockWords& block) {
  constexpr std::uint32_t kRemembered =
      bit(Group::Plane) | bit(Group::Distance) | bit(Group::Stroke) | bit(Group::Units) |
      bit(Group::Return) | bit(Group::Macro) | bit(Group::Surface) | bit(Group::Path) |
      bit(Group::Turret) | bit(Group::Fluctuation) | bit(Group::PolarMilling) | bit(Group::Centre) |
      bit(Group::Diameter);
  const bool feed_first =
      block.has(Group::Units) && m.facts.control->motion.feed_unit.value == FeedUnit::BeforeBlock;
  set_feed_mode(m, block);
  if (feed_first)
    if (auto wrong = set_feed(m, block)) return wrong;
  remember(m.state, *block.words.codes, kRemembered);
  if (block.has(Group::Plane)) m.state.plane = plane_of(block.meaning(Group::Plane));
  const bool surface = m.state.modal[at(Group::Surface)].meaning == Meaning::SurfaceSpeed;
  // G97 without S keeps the speed that there is. [TDi 25 note 4]
  if (m.state.surface && !surface && (m.state.work[0] != 0 || m.state.max_speed > 0))
    if (const double last = spindle_at(move_state(m.state), std::fabs(m.state.work[0])); last > 0)
      m.state.speed = last;
  m.state.surface = surface;
  m.state.unit = unit_of(m.facts, m.state.modal[at(Group::Units)].meaning);
  m.state.incremental = m.state.modal[at(Group::Distance)].meaning == Meaning::Incremental;
  if (block.meaning(Group::Stroke) == Meaning::StrokeOn) {
    if (auto wrong = set_area(m, block)) return wrong;
  }
  if (!feed_first)
    if (auto wrong = set_feed(m, block)) return wrong;
  set_lead(m, block);
  if (auto wrong = set_tool(m, block)) return wrong;  // T1 M06 changes to tool 1 [source 003]
  set_spindle(m, block);
  if (auto wrong = select_work(m, block)) return wrong;
  if (block.has(Group::Polar)) {
    m.state.modal[at(Group::Polar)] = block.code(Group::Polar);
    m.state.polar_known = false;
  }
  constexpr std::uint32_t kTurning =
      bit(Group::Rotation) | bit(Group::Scaling) | bit(Group::Mirror);
  return (block.words.codes->groups & kTurning) != 0 ? set_turned(m, block) : std::nullopt;
}

Result feed_of(MotionView m, const BlockWords& block, double& feed) {
  const double value = block.words['F'];
  const bool times = m.state.modal[at(Group::Feed)].meaning == Meaning::InverseTime;
  double unit = times ? 1 : m.state.unit;  // times a minute have no unit of length
  if (!times && (block.words.whole & bit('F')) != 0 &&
      m.facts.control->reading.whole_numbers.value == WholeNumbers::Increments)
    unit *= feed_increment(m.state);
  const int most = m.facts.control->motion.max_feed.value;
  if (value < 0 || (most > 0 && value * unit > most)) return fault(Cause::FeedOutOfRange, block);
  feed = value * unit;
  return std::nullopt;
}

bool compensates_behind(MotionView m, const BlockWords& block) {
  if (!block.has(Group::Radius) || !is_by_own_normal(m.facts)) return compensating(m.state);
  return block.meaning(Group::Radius) != Meaning::RadiusOff;
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

double feed_increment(const MotionState& state) {
  const bool per_minute = state.modal[at(Group::Feed)].meaning != Meaning::PerRevolution;
  return (per_minute ? 1 : 0.01) * (g20(state) ? 0.01 : 1);
}

Result need_feed(MotionView m, const BlockWords& block, Meaning meaning) {
  if (meaning == Meaning::Rapid) return std::nullopt;
  if (m.state.feed <= 0) {
    const bool zero = block.words.has('F') && m.facts.refuses(Cause::ArcFeedZero);
    const bool arc = meaning == Meaning::Cw || meaning == Meaning::Ccw;
    return fault(zero && arc ? Cause::ArcFeedZero : Cause::NoFeed, block);
  }
  if (lacks_speed(m)) return fault(Cause::NoSpeed, block);
  return std::nullopt;
}

bool lacks_speed(MotionView m) {
  const bool revolutions = m.state.modal[at(Group::Feed)].meaning == Meaning::PerRevolution;
  return revolutions && (m.state.surface ? m.state.surface_speed : m.state.speed) <= 0 &&
         m.facts.refuses(Cause::NoSpeed);
}

namespace {

/// How many least increments a unit of the program has, of a length or of an angle.
double steps_of(MotionView m, bool degrees) {
  const bool tenth = !degrees && g20(m.state);
  return 1 / (in_pulses(m.state) ? 1 : m.facts.increment * (tenth ? 0.1 : 1));
}

double in_steps(MotionView m, const NcWords& words, std::size_t place, bool degrees) {
  const double value = words.value[place];
  const bool computed = (words.computed >> place & 1) != 0;
  const bool counts =
      computed ? rounds_computed(*m.facts.control)
               : (words.whole >> place & 1) != 0 &&
                     m.facts.control->reading.whole_numbers.value == WholeNumbers::Increments;
  if (!counts) return value;
  const double steps = steps_of(m, degrees);
  return (computed ? std::round(value * steps) : value) / steps;
}

}  // namespace

double in_steps(MotionView m, const NcWords& words, char address) {
  return in_steps(m, words, static_cast<std::size_t>(address - 'A'), counts_degrees(address));
}

double length_at(MotionView m, const NcWords& words, int place) {
  return in_steps(m, words, static_cast<std::size_t>(place), false) * m.state.unit;
}

double rounded(MotionView m, char address, double value) {
  const double steps = steps_of(m, counts_degrees(address));
  return std::round(value * steps) / steps;
}

}  // namespace cncsub
