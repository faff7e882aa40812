// G04.
#include <algorithm>
#include <cmath>

#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/emit.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

/// Return the part of a dwell that passes until a skip signal ends it.
double dwell_part(MotionContext& m, const BlockWords& block) {
  if (!m.inputs.skips.any()) return 1;
  const SignalMask signals = signals_of(m, block);
  double part = 1;
  if (signals != 0)
    for (const SkipSignal& reported : m.inputs.skips.take(signals).reported)
      if (reported.comes == SkipSignal::Comes::AtFraction) part = std::min(part, reported.value);
  return part;
}

/// Return the seconds that a letter of G04 says.
double seconds_of_letter(MotionView m, const NcWords& w, char letter) {
  const Control& c = *m.facts.control;
  double value = w[letter];
  if (letter != 'P') {
    if ((w.computed & bit(letter)) != 0 && rounds_computed(c))
      value = std::round(value * 1000) / 1000;
    const bool increments = c.motion.dwell_unit.value == DwellUnit::Milliseconds ||
                            c.reading.whole_numbers.value == WholeNumbers::Increments;
    return increments && (w.whole & bit(letter)) != 0 ? value * 0.001 : value;
  }
  const bool point = ((w.whole | w.computed) & bit('P')) == 0;
  const DwellPoint of_point = c.motion.dwell_point.value;
  if (point && of_point == DwellPoint::Cut) value = std::floor(value);
  const bool counts_seconds =
      point && (of_point == DwellPoint::Seconds || of_point == DwellPoint::CyclesToo);
  return c.motion.dwell_unit.value == DwellUnit::PSeconds || counts_seconds ? value : value * 0.001;
}

/// Return how fast the spindle turns where the tool stands, in r/min.
double speed_now(MotionView m) {
  const MotionState& s = m.state;
  return s.surface ? spindle_at(s.surface_speed, s.max_speed, diameter_now(m)) : s.speed;
}

/// The first of the letters of G04 that a block has, 0 where it has none, and the seconds it says.
struct DwellWord {
  char letter = 0;
  double seconds = 0;
};

DwellWord dwell_of(MotionView m, const NcWords& words) {
  const MotionRules& rules = m.facts.control->motion;
  for (const char letter : rules.dwell_words.value)
    if (words.has(letter)) return {letter, seconds_of_letter(m, words, letter)};
  for (const char letter : rules.dwell_turn_words.value)
    if (words.has(letter)) return {letter, words[letter] / turning(speed_now(m)) * 60};
  return {};
}

}  // namespace

double dwell_seconds(MotionView m, const NcWords& words) { return dwell_of(m, words).seconds; }

Result dwell(MotionContext& m, BlockWords& block) {
  const auto [letter, seconds] = dwell_of(m, block.words);
  const std::uint32_t used = letter == 0 ? 0 : bit(letter);
  if (!leaves_axes(m.facts, block)) m.outcome.drop(kAxisWords & ~used);
  if (letter == 0) return std::nullopt;
  const MotionRules& rules = m.facts.control->motion;
  for (const Letters* letters : {&rules.dwell_words.value, &rules.dwell_turn_words.value})
    for (const char other : *letters)
      if (other != letter) m.outcome.drop(bit(other));
  if (seconds < 0 && m.facts.refuses(Cause::ValueOutOfRange))
    return fault_at(letter, Cause::ValueOutOfRange, block, "a dwell is not below zero");
  if (seconds <= 0) return std::nullopt;
  return add_dwell(m, block, seconds * dwell_part(m, block));
}

}  // namespace cncsub
