// G04.
#include <algorithm>
#include <cmath>

#include "cncsub/motion/emit.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/words.hpp"

namespace cncsub {
namespace {

/// How much of a dwell is waited until a skip signal ends it.
double dwell_part(MotionContext& m, const BlockWords& block) {
  if (!m.outside.skips.any()) return 1;
  const SignalMask signals = signals_of(m, block);
  double part = 1;
  if (signals != 0)
    for (const SkipSignal& told : m.outside.skips.take(signals).told)
      if (told.comes == SkipSignal::Comes::AtFraction) part = std::min(part, told.value);
  return part;
}

/// What a letter of G04 says, in seconds.
double seconds_of_letter(MotionView m, const NcWords& w, char letter) {
  const Control& c = *m.facts.control;
  double value = w[letter];
  if (letter != 'P') {
    const bool increments = c.motion.dwell_unit.value == DwellUnit::Milliseconds ||
                            c.reading.whole_numbers.value == WholeNumbers::Increments;
    return increments && (w.whole & bit(letter)) != 0 ? value * 0.001 : value;
  }
  const bool point = ((w.whole | w.computed) & bit('P')) == 0;
  if (point && c.motion.dwell_point.value == DwellPoint::Cut) value = std::floor(value);
  const bool counts_seconds = point && c.motion.dwell_point.value == DwellPoint::Seconds;
  return c.motion.dwell_unit.value == DwellUnit::PSeconds || counts_seconds ? value : value * 0.001;
}

/// The first of the letters of G04 that a block has, 0 where it has none, and the seconds it says.
struct DwellWord {
  char letter = 0;
  double seconds = 0;
};

DwellWord dwell_of(MotionView m, const NcWords& words) {
  for (const char letter : m.facts.control->motion.dwell_words.value)
    if (words.has(letter)) return {letter, seconds_of_letter(m, words, letter)};
  return {};
}

}  // namespace

double dwell_seconds(MotionView m, const NcWords& words) { return dwell_of(m, words).seconds; }

Result dwell(MotionContext& m, BlockWords& block) {
  const auto [letter, seconds] = dwell_of(m, block.words);
  if (letter == 0) return std::nullopt;
  for (const char other : m.facts.control->motion.dwell_words.value)
    if (other != letter) m.outcome.drop(bit(other));
  if (seconds <= 0) return std::nullopt;
  return add_dwell(m, block, seconds * dwell_part(m, block));
}

}  // namespace cncsub
