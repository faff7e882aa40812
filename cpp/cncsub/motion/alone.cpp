// Blocks of one code that is more than a plain move, and stands alone: G04, G31, G32.
#include <array>

#include "cncsub/motion/emit.hpp"
#include "cncsub/motion/fast_path.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/motion.hpp"
#include "cncsub/motion/plain_line.hpp"
#include "cncsub/motion/words.hpp"

namespace cncsub {
namespace {

/// What such a block is carried out with.
struct Alone {
  const MotionFacts& facts;
  MotionState& state;
  const NcWords& words;
  std::uint32_t step;
  Moves* moves;
  MotionOutcome& outcome;

  operator MotionView() const { return {facts, state}; }  // NOLINT(misc-explicit-constructor)
};

bool dwell_alone(const Alone& m) {
  MotionState& s = m.state;
  if ((m.words.mask & (m.words.mask - 1)) != 0) return false;  // one word, or none: 0 seconds
  const double seconds = dwell_seconds(m, m.words);
  if (!(seconds > 0) || !in_range(seconds, s.time + seconds)) return false;

  m.outcome = {};
  s.time += seconds;
  if (m.moves == nullptr) return true;
  if (s.row_moves != m.moves) begin_row_state(m.facts, s, *m.moves);
  m.moves->push(m.step, MoveKind::Dwell, s.work, s.row_state);
  m.moves->seconds(seconds);
  return true;
}

/// Whether beside the code there are the axis words of a line and perhaps F, and nothing that the
/// general path has something to say about.
bool is_line(const Alone& m) {
  const std::uint32_t axes = kEndWords | m.facts.other_axes | m.facts.increments;
  return (m.words.mask & axes) != 0 && (m.words.mask & ~(axes | bit('F'))) == 0 &&
         has_plain_values(m.facts, m.words) &&
         !check_conflicts(m, {.words = m.words, .step = m.step});
}

bool plan(const Alone& m, MoveKind kind, double feed, PlainLine& line) {
  return feed > 0 &&
         plan_line(m, m.words, kind, m.state.incremental ? nullptr : &kOrigin, feed, line);
}

void go(const Alone& m, MoveKind kind, const PlainLine& line) {
  m.outcome = {};
  m.outcome.moved = line.moved;
  m.outcome.axis_word = true;
  m.outcome.moves = 1;
  if (m.words.has('F')) take_feed(m.state, m.words['F']);
  go_along(m.facts, m.state, line, kind, m.step, m.moves);
}

double feed_of(const Alone& m) {
  return m.words.has('F') ? plain_feed(m.state, m.words['F']) : m.state.feed;
}

/// G31 whose signal does not come.
bool skip_alone(const Alone& m) {
  const MotionRules& rules = m.facts.control->motion;
  MotionState& s = m.state;
  const bool per_turn = s.modal[at(Group::Feed)].meaning == Meaning::PerRevolution &&
                        m.facts.refuses(Cause::SkipPerRevolution);
  PlainLine line;
  if (per_turn || rules.skip_own_feed.value || rules.max_skip_feed.value > 0 || !is_line(m) ||
      !plan(m, MoveKind::Feed, feed_of(m), line))
    return false;
  const Axes skip = rules.length_type.value == LengthType::Shift ? line.end : line.end + s.length;
  if (!in_range(skip) || !in_range(line.end)) return false;

  go(m, MoveKind::Feed, line);
  if (m.moves != nullptr) m.moves->skip(SkipMove::Missed);
  m.outcome.skip = SkipMove::Missed;
  s.skip_touched = false;
  s.skip = skip;
  return true;
}

/// G32 without a run-out, where its lead is the feed.
bool thread_alone(const Alone& m) {
  MotionState& s = m.state;
  const GCode& code = m.words.codes->of[at(Group::Motion)];
  const bool other = s.modal[at(Group::Motion)].meaning != Meaning::Thread;
  const bool leads = !m.facts.control->turning.lead_apart.value &&
                     s.modal[at(Group::Feed)].meaning == Meaning::PerRevolution;
  const bool stands = m.facts.refuses(Cause::SpindleStands) && (!s.turns || s.speed <= 0);
  PlainLine line;
  if (code.which != 0 || !leads || stands || (!other && s.turn.has_j) || !is_line(m) ||
      !plan(m, MoveKind::Thread, feed_of(m), line))
    return false;

  s.modal[at(Group::Motion)] = code;
  s.motion_code = kOtherPath;
  if (other) s.turn = {};
  go(m, MoveKind::Thread, line);
  s.lead = s.feed;
  return true;
}

}  // namespace

bool Motion::alone(const NcWords& words, std::uint32_t step, Moves* moves, Outcome& outcome) {
  const BlockCodes& codes = *words.codes;
  if (!state_.plain || codes.g_count != 1 || codes.m_count != 0 || words.stops) return false;
  const Alone m{*facts_, state_, words, step, moves, outcome};
  switch (codes.meaning(Group::OneShot)) {
    case Meaning::Dwell:
      return dwell_alone(m);
    case Meaning::Skip:
      return skip_alone(m);
    default:
      return codes.meaning(Group::Motion) == Meaning::Thread && thread_alone(m);
  }
}

}  // namespace cncsub
