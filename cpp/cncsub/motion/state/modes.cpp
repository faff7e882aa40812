// Answers that take both modes and words: feeds, the words of other codes.
#include "cncsub/motion/state/modes.hpp"

namespace cncsub {

bool takes_word(MotionView m, const BlockWords& block, char letter) {
  const MotionRules& rules = m.facts.control->motion;
  if (block.meaning(Group::OneShot) == Meaning::Dwell)
    return rules.dwell_words.value.has(letter) || rules.dwell_turn_words.value.has(letter);
  const GCode& motion =
      block.has(Group::Motion) ? block.code(Group::Motion) : m.state.modal[at(Group::Motion)];
  if (letter == 'F' && motion.meaning == Meaning::Thread && motion.variant >= 4) return true;
  return letter == 'D' && rules.speed_limit.value == SpeedLimit::OfSurface &&
         block.meaning(Group::Surface) == Meaning::SurfaceSpeed;
}

Result feed_of(MotionView m, const BlockWords& block, double& feed) {
  const double value = block.words['F'];
  const bool times = m.state.modal[at(Group::Feed)].meaning == Meaning::InverseTime;
  double unit = times ? 1 : m.state.feed_unit;  // times a minute have no unit of length
  if (!times && (block.words.whole & bit('F')) != 0 &&
      m.facts.control->reading.whole_numbers.value == WholeNumbers::Increments)
    unit *= feed_increment(m.state);
  const int most = m.facts.control->motion.max_feed.value;
  const bool zero = value == 0 && m.facts.refuses(Cause::FeedOutOfRange);
  if (value < 0 || zero || (most > 0 && value * unit > most))
    return fault_at('F', Cause::FeedOutOfRange, block);
  feed = value * unit;
  return std::nullopt;
}

double feed_increment(const MotionState& state) {
  const bool per_minute = state.modal[at(Group::Feed)].meaning != Meaning::PerRevolution;
  return (per_minute ? 1 : 0.01) * (g20(state) ? 0.01 : 1);
}

bool feed_of_each_cut(MotionView m) {
  return m.facts.control->motion.feed_mode_change.value == FeedModeChange::EndsFeed &&
         m.state.modal[at(Group::Feed)].meaning == Meaning::InverseTime;
}

Result need_feed(MotionView m, const BlockWords& block, Meaning meaning) {
  if (meaning == Meaning::Rapid) return std::nullopt;
  if (m.state.feed <= 0) {
    const bool zero = block.words.has('F') && m.facts.refuses(Cause::ArcFeedZero);
    const bool arc = meaning == Meaning::Cw || meaning == Meaning::Ccw;
    return fault_at('F', zero && arc ? Cause::ArcFeedZero : Cause::NoFeed, block);
  }
  if (lacks_speed(m)) return fault_at('S', Cause::NoSpeed, block);
  return std::nullopt;
}

bool lacks_speed(MotionView m) {
  const bool revolutions = m.state.modal[at(Group::Feed)].meaning == Meaning::PerRevolution;
  return revolutions && (m.state.surface ? m.state.surface_speed : m.state.speed) <= 0 &&
         m.facts.refuses(Cause::NoSpeed);
}

bool compensates_behind(MotionView m, const BlockWords& block) {
  if (!block.has(Group::Radius) || !is_by_own_normal(m.facts)) return compensating(m.state);
  return block.meaning(Group::Radius) != Meaning::RadiusOff;
}

bool goes_with_motion(const MotionState& state, const BlockWords& block) {
  switch (block.meaning(Group::OneShot)) {
    case Meaning::None:
    case Meaning::ExactStop:
    case Meaning::Lengthen:
    case Meaning::Shorten:
    case Meaning::LengthenTwice:
    case Meaning::ShortenTwice:
      return true;
    case Meaning::OneWay:
      return !block.has(Group::Motion) && (in_cycle(state) || block.has(Group::Cycle));
    default:
      return false;
  }
}

}  // namespace cncsub
