// Questions about the modes in force, and about what a block does to them.
#pragma once

#include <bit>

#include "cncsub/motion/state/context.hpp"

namespace cncsub {

inline bool in_cycle(const MotionState& state) { return state.cycle.cycle != Meaning::CycleOff; }
inline bool compensating(const MotionState& state) {
  const Meaning radius = state.modal[at(Group::Radius)].meaning;
  return radius == Meaning::RadiusLeft || radius == Meaning::RadiusRight;
}
/// Return -1 to the left, 1 to the right, 0 where nothing is compensated.
inline int side_of(const MotionState& state) {
  const Meaning radius = state.modal[at(Group::Radius)].meaning;
  return radius == Meaning::RadiusLeft ? -1 : radius == Meaning::RadiusRight ? 1 : 0;
}
inline bool g20(const MotionState& state) {
  return state.modal[at(Group::Units)].meaning == Meaning::Inch;
}
/// Return what F counts of a round axis is divided by: degrees are not turned into millimetres.
inline double degree_of_feed(const MotionState& state) {
  return state.feed_unit == kInch ? kInch : 1;
}
inline bool polar(const MotionState& state) {
  return state.modal[at(Group::Polar)].meaning == Meaning::PolarOn;
}
/// Return whether I, J and K are coordinates of the centre.
inline bool centre_is_absolute(const MotionState& state) {
  return state.modal[at(Group::Centre)].meaning == Meaning::CentreAbsolute;
}
/// Return whether rotation, scaling or mirror is on.
inline bool is_transformed(const MotionState& state) {
  return state.transform.rotation || state.transform.scaling || state.transform.mirror;
}
/// Return whether programmed points differ from work coordinates.
inline bool is_turned(const MotionState& state) {
  return is_transformed(state) || state.frame.turned;
}
inline bool is_by_own_normal(const MotionFacts& facts) {
  return facts.control->motion.start_up.value == StartUp::OwnNormal;
}

/// Return whether a code is a cycle of one cut: G90, G92 or G94 of lathes, whatever they are
/// called, or a tap that goes back.
inline bool is_simple_cycle(Meaning motion) {
  return motion == Meaning::TurnCycle || motion == Meaning::ThreadCycle ||
         motion == Meaning::FaceCycle || motion == Meaning::TapCycle;
}

/// Put the codes of a block in these groups in force.
inline void remember(MotionState& state, const BlockCodes& codes, std::uint32_t groups) {
  for (std::uint32_t left = codes.groups & groups; left != 0; left &= left - 1) {
    const auto group = static_cast<std::size_t>(std::countr_zero(left));
    state.modal[group] = codes.of[group];
  }
}
/// Return whether a code of the block takes a word for itself. The word then sets no mode: F of G04
/// may be its time, D of G96 the limit of the spindle.
bool takes_word(MotionView m, const BlockWords& block, char letter);
/// Read F of a block as a feed.
Result feed_of(MotionView m, const BlockWords& block, double& feed);
/// Return the feed of F1 without a point. [general knowledge]
double feed_increment(const MotionState& state);
/// Return whether every cut has an F of its own: under G93, where the control says so.
bool feed_of_each_cut(MotionView m);
Result need_feed(MotionView m, const BlockWords& block, Meaning meaning);
/// Return whether a cut would wait for a spindle that was never given a speed.
bool lacks_speed(MotionView m);
/// Return whether the axis words of a block are those of a motion that follows its one-shot code.
inline bool leaves_axes(const MotionFacts& facts, const BlockWords& block) {
  return block.has(Group::OneShot) &&
         facts.control->motion.codes_that_move.value.has(block.code(Group::OneShot).code);
}
/// Return whether a radius is compensated when a block's codes after G40 to G42 are carried out.
/// Where moves end by their own normals, G40 to G42 come first. [rs274 2.9]
bool compensates_behind(MotionView m, const BlockWords& block);
/// Return whether a block's motion is made in spite of its one-shot code.
bool goes_with_motion(const MotionState& state, const BlockWords& block);

}  // namespace cncsub
