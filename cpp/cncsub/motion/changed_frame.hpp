// Blocks that change where things lie, a work system or the length of a tool, and else are plain.
#pragma once

#include "cncsub/motion/facts.hpp"
#include "cncsub/motion/state.hpp"

namespace cncsub {

/// Whether the words of a block may change where things lie: a code of another work system than the
/// one in force, a code of lengths, H.
inline bool changes_frame(const MotionState& state, const NcWords& words) {
  const BlockCodes& codes = *words.codes;
  if (codes.has(Group::Length) || words.has('H'))
    return words.has('H') || codes.meaning(Group::Length) != Meaning::LengthOff ||
           state.length != Axes{};
  return codes.has(Group::Work) &&
         (codes.meaning(Group::Work) == Meaning::WorkExtra ||
          codes.meaning(Group::Work) != state.modal[at(Group::Work)].meaning);
}

/// The letters by which it is said what lies elsewhere: H, and P of G54.1.
inline std::uint32_t words_of_frame(const NcWords& words) {
  const GCode& work = words.codes->of[at(Group::Work)];
  return bit('H') | (work.meaning == Meaning::WorkExtra && work.which == 0 ? bit('P') : 0);
}

}  // namespace cncsub
