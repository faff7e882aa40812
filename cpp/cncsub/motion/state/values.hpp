// The values of words: lengths, angles, counts.
#pragma once

#include <cmath>

#include "cncsub/motion/state/modes.hpp"

namespace cncsub {

/// Return the value of a word that counts something, or names it by its number, made whole as the
/// operands of calls are. A written number counts like the result of an expression: `flatten`
/// writes one for the other.
inline double counted(MotionView m, const NcWords& words, char letter) {
  const bool rounds = m.facts.control->calls.call_values.value == CallValues::Rounded;
  return rounds ? std::round(words[letter]) : words[letter];
}

/// Return how many millimetres the unit of F is while a code of units is in force.
double feed_unit_of(const MotionFacts& facts, const GCode& units);
/// Let lengths and F count in the units that are in force.
void take_units(const MotionFacts& facts, MotionState& state);
/// Return whether the words of an address count degrees.
constexpr bool counts_degrees(char address) {
  return ((bit('A') | bit('B') | bit('C') | bit('H')) & bit(address)) != 0;
}
/// Return whether a computed length is rounded to the least increment.
inline bool rounds_computed(const Control& control) {
  return control.motion.computed_lengths.value == ComputedLengths::Rounded;
}
inline bool in_pulses(const MotionState& state) {
  return state.modal[at(Group::Units)].meaning == Meaning::Pulses;
}
/// Return the value, in units of the program, of a word that is computed or written without a
/// point: it counts least increments, or is rounded to one.
double in_steps(MotionView m, const NcWords& words, char address);
/// Return the value in mm of the word at a place of the mask, a length that is no axis.
double length_at(MotionView m, const NcWords& words, int place);
/// Return the value of a word in units of the program.
inline double in_units(MotionView m, const NcWords& words, char address) {
  return ((words.computed | words.whole) & bit(address)) == 0 ? words[address]
                                                              : in_steps(m, words, address);
}
/// Return the value of an axis or length word in mm or degrees.
inline double number(MotionView m, const NcWords& words, char address) {
  const double value = in_units(m, words, address);
  if (address == 'X' && m.state.diameter) return value / 2 * m.state.unit;
  // Pulses count on every axis, inches on the straight ones alone. [source 003, G20 G21 G22]
  return counts_degrees(address) && !in_pulses(m.state) ? value : value * m.state.unit;
}
inline double number(MotionView m, const BlockWords& block, char address) {
  return number(m, block.words, address);
}
/// Return a computed value at an address as the control takes it: rounded to the least increment.
double rounded(MotionView m, char address, double value);
/// Return the diameter at which the tool stands, which a surface speed is that of.
inline double diameter_now(MotionView m) { return 2 * m.facts.share(0) * m.state.work[0]; }
/// Return the seconds that P of a drilling cycle says.
double dwell_in_hole(MotionView m, const NcWords& words);
/// Return the axes that addresses (a block's mask) can move, as the columns of the moves are
/// called.
std::string axes_of(MotionView m, std::uint32_t mask);

}  // namespace cncsub
