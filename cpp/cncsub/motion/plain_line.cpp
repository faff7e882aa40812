#include "cncsub/motion/plain_line.hpp"

#include <bit>

#include "cncsub/motion/emit.hpp"
#include "cncsub/motion/fast_path.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/motion.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/words.hpp"

namespace cncsub {

void Motion::go_along(const PlainLine& line, bool rapid, std::uint32_t step, Moves* moves) {
  MotionState& s = state_;
  if (moves != nullptr && s.row_moves != moves) begin_row_state(*facts_, s, *moves);
  s.time += line.seconds;
  s.moved_before = true;
  s.named |= line.named;
  s.work = line.end;
  if (!s.plain) s.tool_at = machine_point(s);
  if (moves == nullptr) return;
  moves->use(line.named);
  moves->push(step, rapid ? MoveKind::Rapid : MoveKind::Feed, s.work, s.row_state);
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

/// Where a line ends, and whether that is another place.
void plan_end(MotionView m, const NcWords& words, const Axes* zero, PlainLine& line) {
  const MotionState& s = m.state;
  const bool turns = turned(s);
  line.end = turns ? turned_back(s, s.work) : s.work;
  find_end(m, words, zero != nullptr ? *zero : Axes(line.end), line);
  if (turns) turn_point(s, line.end, line.named);
  for (std::size_t i = 0; i < line.end.size(); ++i)
    line.moved = line.moved || std::fabs(line.end[i] - s.work[i]) >= 1e-12;
}

/// Whether a block says nothing but a line. `path`: the code of its motion, 0 for G00.
bool is_line(MotionView m, const NcWords& words, int path) {
  const std::uint32_t axes = kEndWords | m.facts.other_axes | m.facts.increments;
  return path <= 1 && words.codes->only_of_moves() && (words.mask & axes) != 0 &&
         (words.mask & ~(axes | bit('F'))) == 0 && has_plain_words(m.facts, words, false);
}

}  // namespace

bool plan_line(MotionView m, const NcWords& words, bool rapid, const Axes* zero, double feed,
               PlainLine& line) {
  const MotionState& s = m.state;
  plan_end(m, words, zero, line);
  const Axes from = machine_point(s), to = line.end + s.offset + s.length;
  const std::uint32_t diameters = m.facts.diameters;
  const double length = length_of(from, to, diameters), x_zero = s.offset[0] + s.length[0];
  MoveState row = move_state(s);
  row.feed = feed;
  const MoveKind kind = rapid ? MoveKind::Rapid : MoveKind::Feed;
  line.seconds = seconds_of({kind, row, from, to, length, x_zero, 0}, m.facts.rapid, diameters);
  return in_range(to) && in_range(std::array{length, line.seconds, s.time + line.seconds});
}

bool Motion::line_beside(const NcWords& words, std::uint32_t step, Moves* moves,
                         Outcome& outcome) {
  MotionState& s = state_;
  const BlockCodes& codes = *words.codes;
  const int path = codes.has(Group::Motion) ? path_of(codes.meaning(Group::Motion)) : s.motion_code;
  if (!is_line(view(), words, path)) return false;
  const BlockWords block{.words = words, .step = step};
  if (turned(s) && check_conflicts(view(), block)) return false;
  PlainLine line;
  plan_end(view(), words, s.incremental ? nullptr : &kOrigin, line);

  Undo undo(s, before_, log_, moves, true);
  take_code(*facts_, s, path);
  if (words.has('F')) take_feed(s, words['F']);
  const MoveKind kind = path == 0 ? MoveKind::Rapid : MoveKind::Feed;
  const Piece piece = make_piece(view(), block, kind, line.end, line.named);
  const Axes from = s.work + s.offset;
  MoveSink sink{*facts_, s, moves};
  s.named |= line.named;
  s.work = line.end;
  s.moved_before = true;
  const bool possible = (path == 0 || s.feed > 0) && in_range(piece.end) && in_range(s.work) &&
                        !through_radius(sink, piece, from) && !count_idle(sink, words.at);
  if (!possible) {  // the general path says why
    undo.put_back();
    return false;
  }
  if (!compensating(s)) prepare_fast_path(*facts_, s);  // this may have been the last
  outcome = {};
  outcome.moved = line.moved, outcome.axis_word = true, outcome.moves = 1;
  return true;
}

}  // namespace cncsub
