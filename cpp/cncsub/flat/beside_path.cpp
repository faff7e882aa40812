// Axes beside the path: POS[X] of one control as moves along the path of another.
#include <string>
#include <vector>

#include "cncsub/flat/other.hpp"
#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/state/facts.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {

void OtherWriter::begin_block() { start_ = from_.motion().state().work; }

std::string OtherWriter::code_text(const GCode& own) const {
  bool idle = false;
  const int code = code_of(own, idle);
  return code < 0 ? "" : code_name(code) + " ";
}

/// Write the moves of axes beside the path as moves along it, for a control that has no such axes,
/// and put the modes in force again that this changes.
bool OtherWriter::put_as_path(std::string& to) {
  const MotionState& state = from_.motion().state();
  const GCode motion = state.modal[at(Group::Motion)], feed = state.modal[at(Group::Feed)];
  const bool per_minute = feed.meaning == Meaning::PerMinute;
  const GCodes& codes = facts_of(from_).codes;
  const std::string line = code_text(codes.of(Meaning::Line));
  if (line.empty() || (state.feed <= 0 && motion.meaning != Meaning::Rapid) ||
      (!per_minute && feed.meaning != Meaning::PerRevolution))
    return refuse(
        "axes beside the path cannot be written as a path move in the modes of this block");
  std::vector<BesideMove> moves = moves_beside_path(from_.motion().view(), start_, state.work);
  for (const BesideMove& move : moves) {
    if (state.incremental) to += code_text(codes.of(Meaning::Absolute));
    if (!per_minute) to += code_text(codes.of(Meaning::PerMinute));
    to += line;
    for (std::size_t i = 0; i < 3; ++i)
      if ((move.axes >> i & 1) != 0 && !put_word(to, kAxisNames[i] - 'A', move.end[i] / state.unit))
        return false;
    if (!put_word(to, 'F' - 'A', feed_there(move.feed / state.feed_unit))) return false;
    to.back() = '\n';
  }
  return moves.empty() || put_modes_again(to);
}

/// Put the modes in force again that a move along the path has changed.
bool OtherWriter::put_modes_again(std::string& to) {
  const MotionState& state = from_.motion().state();
  const GCode motion = state.modal[at(Group::Motion)], feed = state.modal[at(Group::Feed)];
  const bool per_minute = feed.meaning == Meaning::PerMinute;
  if (state.incremental) to += code_text(state.modal[at(Group::Distance)]);
  if (!per_minute) to += code_text(feed);
  if (motion.meaning != Meaning::Line) to += code_text(motion);
  if (state.feed > 0 && !put_word(to, 'F' - 'A', feed_there(state.feed / state.feed_unit)))
    return false;
  return true;
}

/// Write a block that moves axes beside the path.
bool OtherWriter::put_beside_path(std::string& to, const NcWords& words) {
  constexpr std::uint32_t kBeside = bit(Group::OneShot) | bit(Group::Motion);
  if (facts_of(to_).codes.of(Meaning::PositionAxes).code < 0) {
    if ((words.codes->groups & ~kBeside) != 0 || words.codes->m_count != 0)
      return refuse("codes stand beside axes that go beside the path");
    return put_as_path(to);
  }
  const Spelling& spelling = *to_.code().spelling;
  for (const int code : words.codes->g())
    if (facts_of(from_).codes.find(code).meaning != Meaning::PositionAxes)
      to += code_text(facts_of(from_).codes.find(code));
  for (std::size_t i = 0; i < 3; ++i) {
    const char axis = kAxisNames[i], feed = static_cast<char>('I' + i);
    const auto index = [&](const char* name) { return std::string(name) + "[" + axis + "]="; };
    if (words.has(axis)) {
      const bool adds = (words.forms.incremental & bit(axis)) != 0,
                 stays = (words.forms.absolute & bit(axis)) != 0;
      const Spelling::Around form = adds    ? spelling.incremental
                                    : stays ? spelling.absolute
                                            : Spelling::Around{};
      to += index("POS") + std::string(form.before);
      to += NumberText(words[axis]).text();
      to += std::string(form.behind) + " ";
    }
    if (words.has(feed)) to += index("FA") + std::string(NumberText(words[feed]).text()) + " ";
  }
  return put_m(to, words, false);
}

}  // namespace cncsub
