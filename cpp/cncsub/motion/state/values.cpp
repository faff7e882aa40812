// The values of words in the units of the program and of the machine.
#include "cncsub/motion/state/values.hpp"

#include <cmath>

#include "cncsub/motion/state/modes.hpp"

namespace cncsub {

/// Return how many millimetres the unit of a code of units is.
static double unit_of(const MotionFacts& facts, Meaning units) {
  return units == Meaning::Inch ? kInch : units == Meaning::Pulses ? facts.increment : 1;
}

double feed_unit_of(const MotionFacts& facts, const GCode& units) {
  if (units.variant != kLengthsAlone) return unit_of(facts, units.meaning);
  return facts.control->common.power_on.value.has(PowerOn::G20) ? kInch : 1;
}

void take_units(const MotionFacts& facts, MotionState& state) {
  const GCode units = state.modal[at(Group::Units)];
  state.unit = unit_of(facts, units.meaning);
  state.feed_unit = feed_unit_of(facts, units);
}

namespace {

/// Return how many least increments a unit of the program has, of a length or of an angle.
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

double dwell_in_hole(MotionView m, const NcWords& words) {
  const MotionRules& rules = m.facts.control->motion;
  const bool point = ((words.whole | words.computed) & bit('P')) == 0;
  const bool seconds = rules.dwell_unit.value == DwellUnit::PSeconds ||
                       (point && rules.dwell_point.value == DwellPoint::CyclesToo);
  return words['P'] * (seconds ? 1 : 0.001);
}

std::string axes_of(MotionView m, std::uint32_t mask) {
  const bool lathe_a = m.facts.machine == MachineType::LatheA;
  std::string names = "XYZ";
  for (const char name : kAxisNames.substr(3, lathe_a ? 3 : 6))
    if ((mask & bit(name)) != 0) names += name;
  if (lathe_a && (mask & bit('H')) != 0 && (mask & bit('C')) == 0) names += 'C';
  return names;
}

}  // namespace cncsub
