#include "cncsub/motion/saved_modes.hpp"

#include <cmath>

#include "cncsub/motion/state/context.hpp"
#include "cncsub/motion/state/modes.hpp"

namespace cncsub {
namespace {

bool is_extended(const MotionState& state) { return state.length != Axes{}; }
double feed_of(MotionView m) {
  const MotionState& state = m.state;
  const bool times = state.modal[at(Group::Feed)].meaning == Meaning::InverseTime;
  if (times && m.facts.control->motion.feed_mode_change.value == FeedModeChange::EndsFeed)
    return state.feed_before / state.feed_unit;
  return times ? state.feed : state.feed / state.feed_unit;
}
double speed_of(const MotionState& state) {
  return state.surface ? state.surface_speed : state.speed;
}

/// Return the code that restores a mode. A side is known, not the form that began it: G41 is
/// written for G41.1. [rs274 2.9: write_g_codes]
int code_of(const MotionFacts& facts, const GCode& code) {
  return code.group == Group::Radius ? facts.codes.of(code.meaning).code : code.code;
}

}  // namespace

SavedModes modes_of(MotionView m) {
  return {m.state.modal, feed_of(m), speed_of(m.state),      m.state.shifted, is_extended(m.state),
          m.state.turns, false,      m.state.frames->program};
}

ReturnToModes units_to(MotionView m, const SavedModes& saved) {
  ReturnToModes block;
  const GCode units = saved.codes[at(Group::Units)];
  if (units.code >= 0 && units.code != m.state.modal[at(Group::Units)].code)
    block.codes.add_g(units.code);
  return block;
}

ReturnToModes modes_to(MotionView m, const SavedModes& saved) {
  const MotionState& state = m.state;
  ReturnToModes block;
  for (const Group group :
       {Group::Plane, Group::Radius, Group::Distance, Group::Feed, Group::Work, Group::Return,
        Group::Surface, Group::Centre, Group::Diameter, Group::Path}) {
    const int code = code_of(m.facts, saved.codes[at(group)]);
    if (code >= 0 && code != code_of(m.facts, state.modal[at(group)])) block.codes.add_g(code);
  }
  const auto add = [&](Meaning meaning) {
    if (const GCode code = m.facts.codes.of(meaning); code.code >= 0) block.codes.add_g(code.code);
  };
  if (saved.extended != is_extended(state))
    add(saved.extended ? Meaning::LengthPlus : Meaning::LengthOff);
  if (saved.shifted != state.shifted)
    add(saved.shifted ? Meaning::RestoreShift : Meaning::SuspendShift);
  if (saved.codes_alone) {
    const GCode motion = saved.codes[at(Group::Motion)];
    if (motion.code >= 0 && motion.code != state.modal[at(Group::Motion)].code)
      block.codes.add_g(motion.code);
    return block;
  }
  // F is written with one decimal, S with none.
  block.has_feed = saved.feed != feed_of(m);
  block.has_speed = saved.speed != speed_of(state);
  return block;
}

}  // namespace cncsub
