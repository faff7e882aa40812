#include "cncsub/motion/changed_frame.hpp"

#include "cncsub/motion/emit.hpp"
#include "cncsub/motion/fast_path.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/motion.hpp"
#include "cncsub/motion/words.hpp"

namespace cncsub {
namespace {

/// Where things lie, and what says so.
struct LaidOut {
  explicit LaidOut(const MotionState& s)
      : work(s.work),
        offset(s.offset),
        origin(s.origin),
        length(s.length),
        work_code(s.modal[at(Group::Work)]),
        length_code(s.modal[at(Group::Length)]),
        work_system(s.work_system),
        extra_system(s.extra_system),
        length_axis(s.length_axis),
        h(s.h) {}

  void put_back(MotionState& s) const {
    s.work = work, s.offset = offset, s.origin = origin, s.length = length;
    s.modal[at(Group::Work)] = work_code, s.modal[at(Group::Length)] = length_code;
    s.work_system = work_system, s.extra_system = extra_system;
    s.length_axis = length_axis, s.h = h;
  }

  Axes work, offset, origin, length;
  GCode work_code, length_code;
  int work_system, extra_system, length_axis, h;
};

/// Whether the general path has nothing to say about how a block changes the frame: it does not
/// select the plane or the tool that a length is of, and no system is turned.
bool changes_plainly(MotionView m, const BlockWords& block) {
  const NcWords& words = block.words;
  const bool length = block.has(Group::Length) || words.has('H');
  if (!m.state.plain || !words.codes->plain || !m.state.tables.turned.empty()) return false;
  if (!length) return true;
  return !m.facts.lathe() && !block.has(Group::Plane) && !words.has('T') &&
         (words.whole >> kPointedH & 1) == 0;
}

/// Takes the words of the frame over. False where a fault comes of it, or a move that no axis word
/// says: a length moves its axis at once.
bool take_frame(MotionContext& m, BlockWords& block) {
  const Axes before = m.state.length;
  m.state.row_moves = nullptr;
  if (select_work(m, block)) return false;
  if (block.has(Group::Work) && !in_range(m.state.offset)) return false;
  if (block.has(Group::Length) || block.words.has('H')) {
    if (set_length(m, block) || !in_range(m.state.length)) return false;
    const bool moves = (block.words.mask & (kEndWords | m.facts.other_axes)) != 0;
    const bool shifts = m.facts.control->motion.length_type.value == LengthType::Shift;
    if (!moves && !shifts && m.state.length != before) return false;
  }
  return in_range(m.state.work);
}

}  // namespace

bool Motion::in_changed_frame(const NcWords& words, std::uint32_t step, Moves* moves,
                              Outcome& outcome) {
  MotionState& s = state_;
  BlockWords block{.words = words, .step = step};
  if (!changes_plainly(view(), block) || check_conflicts(view(), block)) return false;
  const LaidOut before(s);
  s.tool_at = machine_point(s);
  s.plain = false;  // from here on tool_at is kept
  Outside nothing;
  MotionContext context{*facts_, s, log_, {*facts_, s, moves}, outcome, nothing};
  // S changes how long a move takes where the feed counts on the spindle.
  const bool speeds = s.modal[at(Group::Feed)].meaning == Meaning::PerMinute;
  if (!take_frame(context, block) || !plain_modes(words, speeds, step, moves, outcome)) {
    before.put_back(s);
    s.plain = true;
    return false;
  }
  if (outcome.axis_word)
    s.plain = true;  // the move took the tool to where it is to be
  else
    prepare_fast_path(*facts_, s);
  return true;
}

}  // namespace cncsub
