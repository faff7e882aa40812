// A block's words: their meanings, what does not go together, and the modes that they set.
#pragma once

#include <bit>

#include "cncsub/motion/context.hpp"

namespace cncsub {

/// Carries a block out. `of_cycle`: as a part of a cycle's profile.
Result run_block(MotionContext& m, const NcWords& words, std::uint32_t step, bool of_cycle = false);

/// What is wrong with a G code by itself, and which of them do not count.
Result read_codes(MotionContext& m, const BlockWords& block);
/// What may not stand together, before anything changes.
Result check_block(MotionView m, const BlockWords& block);
Result check_conflicts(MotionView m, const BlockWords& block);
Result set_modes(MotionContext& m, BlockWords& block);
/// The codes of these groups that a block has are in force from here on.
inline void remember(MotionState& state, const BlockCodes& codes, std::uint32_t groups) {
  for (std::uint32_t left = codes.groups & groups; left != 0; left &= left - 1) {
    const auto group = static_cast<std::size_t>(std::countr_zero(left));
    state.modal[group] = codes.of[group];
  }
}

/// Whether a code of the block takes a word for itself, which then sets no mode: F of G04 may be
/// its time, D of G96 the limit of the spindle.
bool takes_word(MotionView m, const BlockWords& block, char letter);

/// How many millimetres the unit of a code of units is.
double unit_of(const MotionFacts& facts, Meaning units);
/// Whether the words of an address count degrees.
constexpr bool counts_degrees(char address) {
  return ((bit('A') | bit('B') | bit('C') | bit('H')) & bit(address)) != 0;
}
/// Whether a length that is computed is brought to the least increment.
inline bool rounds_computed(const Control& control) {
  return control.motion.computed_lengths.value == ComputedLengths::Rounded;
}
inline bool in_pulses(const MotionState& state) {
  return state.modal[at(Group::Units)].meaning == Meaning::Pulses;
}
/// The value of a word in units of the program that is computed, or written without a point: that
/// counts least increments, or is brought to one.
double in_steps(MotionView m, const NcWords& words, char address);
/// The value of the word at a place of the mask, a length that is no axis, in mm.
double length_at(MotionView m, const NcWords& words, int place);
/// The value of a word in units of the program.
inline double in_units(MotionView m, const NcWords& words, char address) {
  return ((words.computed | words.whole) & bit(address)) == 0 ? words[address]
                                                              : in_steps(m, words, address);
}
/// The value of an axis or length word in mm or degrees.
inline double number(MotionView m, const NcWords& words, char address) {
  const double value = in_units(m, words, address);
  if (address == 'X' && m.state.diameter) return value / 2 * m.state.unit;
  // Pulses count on every axis, inches on the straight ones alone. [source 003, G20 G21 G22]
  return counts_degrees(address) && !in_pulses(m.state) ? value : value * m.state.unit;
}
inline double number(MotionView m, const BlockWords& block, char address) {
  return number(m, block.words, address);
}
/// G04.
Result dwell(MotionContext& m, BlockWords& block);
/// The seconds that the words of a G04 say, 0 where none of them does.
double dwell_seconds(MotionView m, const NcWords& words);
/// The seconds that P of a drilling cycle says.
double dwell_in_hole(MotionView m, const NcWords& words);
/// Takes F over, where it is a feed.
Result set_feed(MotionContext& m, const BlockWords& block);
/// F of a block as a feed.
Result feed_of(MotionView m, const BlockWords& block, double& feed);
/// M06: the tool of T is in the spindle.
void change_tool(const Control& control, MotionState& state);
/// What an M code does to the spindle.
void take_spindle(MotionState& state, Role role);
/// What F1 without a point is. [general knowledge]
double feed_increment(const MotionState& state);
/// Whether every cut has an F of its own: under G93, where the control says so.
bool feed_of_each_cut(MotionView m);
Result need_feed(MotionView m, const BlockWords& block, Meaning meaning);
/// Whether a cut would wait for a spindle that was never told how fast to turn.
bool lacks_speed(MotionView m);
/// Whether the axis words of a block are those of a motion, which is made after its one-shot code.
inline bool leaves_axes(const MotionFacts& facts, const BlockWords& block) {
  return block.has(Group::OneShot) &&
         facts.control->motion.codes_that_move.value.has(block.code(Group::OneShot).code);
}
/// Whether a radius is compensated when a block's codes behind G40 to G42 are carried out: where
/// moves end by their own normals these come first. [rs274 2.9]
bool compensates_behind(MotionView m, const BlockWords& block);
/// Whether a block's motion is made in spite of its one-shot code.
bool goes_with_motion(const MotionState& state, const BlockWords& block);

}  // namespace cncsub
