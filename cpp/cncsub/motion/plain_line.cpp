#include "cncsub/motion/plain_line.hpp"

#include <bit>

#include "cncsub/motion/emit.hpp"
#include "cncsub/motion/fast_path.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/words.hpp"

namespace cncsub {

void go_along(const MotionFacts& facts, MotionState& s, const PlainLine& line, MoveKind kind,
              std::uint32_t step, Moves* moves) {
  if (moves != nullptr && s.row_moves != moves) begin_row_state(facts, s, *moves);
  s.time += line.seconds;
  s.moved_before = true;
  s.named |= line.named;
  s.work = line.end;
  if (!s.plain) s.tool_at = machine_point(s);
  if (moves == nullptr) return;
  moves->use(line.named);
  moves->push(step, kind, s.work, s.row_state);
}

namespace {

/// The axes that a line names, and where it ends on them. `zero`: what the words of the block count
/// from.
void find_end(MotionView m, const NcWords& words, const Axes& zero, PlainLine& line) {
  std::uint32_t letters = words.mask & (kEndWords | m.facts.other_axes);
  for (; letters != 0; letters &= letters - 1) {
    const char letter = static_cast<char>('A' + std::countr_zero(letters));
    const auto axis = static_cast<std::size_t>(axis_of(letter));
    line.named |= axis_bit(static_cast<int>(axis));
    line.end[axis] = number(m, words, letter) + zero[axis];
  }
  letters = words.mask & m.facts.increments;
  for (; letters != 0; letters &= letters - 1) {
    const char letter = static_cast<char>('A' + std::countr_zero(letters));
    const std::size_t axis = letter == 'U' ? 0 : 2;
    line.named |= axis_bit(static_cast<int>(axis));
    line.end[axis] += number(m, words, letter);
  }
}

/// Where a line ends.
void plan_end(MotionView m, const NcWords& words, const Axes* zero, PlainLine& line) {
  const bool turns = turned(m.state);
  line.end = turns ? turned_back(m.state, m.state.work) : m.state.work;
  find_end(m, words, zero != nullptr ? *zero : Axes(line.end), line);
  if (turns) turn_point(m.state, line.end, line.named);
}

}  // namespace

bool plan_line(MotionView m, const NcWords& words, MoveKind kind, const Axes* zero, double feed,
               PlainLine& line) {
  const MotionState& s = m.state;
  plan_end(m, words, zero, line);
  for (std::size_t i = 0; i < line.end.size(); ++i)
    line.moved = line.moved || std::fabs(line.end[i] - s.work[i]) >= kStanding;
  const Axes from = s.plain ? machine_point(s) : s.tool_at;
  const Axes to = machine_point(s, line.end);
  const std::uint32_t diameters = m.facts.diameters;
  const double length = length_of(from, to, diameters), x_zero = s.offset[0] + s.length[0];
  MoveState row = move_state(s);
  row.feed = feed;
  if (kind == MoveKind::Thread) row.feed_mode = FeedMode::PerRevolution;
  line.seconds = seconds_of({kind, row, from, to, length, x_zero, 0}, m.facts.rapid, diameters);
  return in_range(to) && in_range(length, line.seconds, s.time + line.seconds);
}

}  // namespace cncsub
