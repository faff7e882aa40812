// A block that says nothing but a move, where a move is not as plain as the fast path has it:
// radius compensation leads the tool beside its way, or a lathe goes along an arc.
#include "cncsub/motion/emit.hpp"
#include "cncsub/motion/fast_path.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/motion.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/words.hpp"

namespace cncsub {
namespace {

/// Whether a block says nothing but a move. `path`: its code, 0 for G00 to 3 for G03.
bool says_move(MotionView m, const NcWords& words, int path) {
  const std::uint32_t axes = kEndWords | m.facts.other_axes | m.facts.increments;
  const std::uint32_t known = axes | bit('F') | (path > 1 ? kCentreWords | bit('R') : 0);
  return words.codes->only_of_moves() && (words.mask & axes) != 0 && (words.mask & ~known) == 0 &&
         !words.stops && has_plain_values(m.facts, words);
}

Result go(MotionContext& m, BlockWords& block, int path) {
  if (path > 1) return arc(m, block, path == 2 ? Meaning::Cw : Meaning::Ccw);
  std::uint32_t named = 0;
  const Axes end = target(m, block, {m.state.incremental, false}, named);
  const MoveKind kind = path == 0 ? MoveKind::Rapid : MoveKind::Feed;
  Piece piece = make_piece(m, block, kind, end, named);
  if (Moves* table = m.sink.table; table != nullptr && m.state.beside) {
    if (m.state.row_moves != table)
      m.state.row_state = table->intern(piece.state, piece.offset + piece.length, piece.tip);
    m.state.row_moves = piece.row_moves = table;
    piece.row_state = m.state.row_state;
  }
  return move(m, block, piece);
}

}  // namespace

bool Motion::move_alone(const NcWords& words, std::uint32_t step, Moves* moves, Outcome& outcome) {
  MotionState& s = state_;
  const BlockCodes& codes = *words.codes;
  const int path = codes.has(Group::Motion) ? path_of(codes.meaning(Group::Motion)) : s.motion_code;
  BlockWords block{.words = words, .step = step};
  // The data of a turning cycle would be lost that is in force.
  if (s.motion_code == kOtherPath || !says_move(view(), words, path)) return false;
  MoveSink sink{*facts_, s, moves};
  if (move_beside(sink, block, path, outcome)) return true;
  if (turned(s) && check_conflicts(view(), block)) return false;

  if (s.plain) s.tool_at = machine_point(s);
  Undo undo(s, before_, log_, moves, Changes::Path);
  s.plain = false;  // from here on tool_at is kept
  take_code(*facts_, s, path);
  if (words.has('F')) take_feed(s, words['F']);
  s.moved_before = true;
  outcome = {};
  Outside nothing;
  MotionContext context{*facts_, s, log_, sink, outcome, nothing};
  if ((path != 0 && !(s.feed > 0)) || go(context, block, path) || !block.submitted ||
      !in_range(s.work) || count_idle(context.sink, words.at)) {
    undo.put_back();  // the general path says why
    return false;
  }
  if (!compensating(s)) prepare_fast_path(*facts_, s);
  return true;
}

}  // namespace cncsub
