// A move that compensation leads beside its way, behind another of which all but the way is the
// same: what contours are made of. The one that waits is known to have been made under the modes
// that hold, so that nothing of them is asked again; and little changes, so that little is kept.
#include "cncsub/motion/emit.hpp"
#include "cncsub/motion/fast_path.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/motion.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/path/radius.hpp"
#include "cncsub/motion/words.hpp"

namespace cncsub {
namespace {

/// What the recording of the waiting move changes, as it was before.
class BeforeRecord {
 public:
  BeforeRecord(MotionState& state, Moves& moves)
      : state_(state),
        moves_(moves),
        rows_(moves.size()),
        tool_at_(state.tool_at),
        time_(state.time),
        vector_(state.held.vector),
        entered_(state.held.entered),
        turn_(state.held.radius.front().turn),
        kind_(state.held.radius.front().kind),
        starting_(state.held.starting) {}

  void put_back() const {
    Held& held = state_.held;
    state_.tool_at = tool_at_;
    state_.time = time_;
    held.vector = vector_;
    held.entered = entered_;
    held.starting = starting_;
    held.radius.front().turn = turn_;
    held.radius.front().kind = kind_;
    moves_.truncate(rows_);
  }

 private:
  MotionState& state_;
  Moves& moves_;
  std::size_t rows_;
  Axes tool_at_;
  double time_;
  std::array<double, 2> vector_, entered_;
  double turn_;
  MoveKind kind_;
  bool starting_;
};

/// Whether the only move that waits was made under the modes that hold, and the block is a move of
/// X, Y and Z under them.
bool goes_on(MotionView m, const NcWords& words, const Moves* moves) {
  const MotionState& s = m.state;
  const Held& held = s.held;
  return moves != nullptr && s.row_moves == moves && held.radius.size() == 1 && held.step == 0 &&
         held.radius.front().row_moves == moves && !is_by_own_normal(m.facts) && !turned(s) &&
         (words.mask & (m.facts.other_axes | m.facts.increments)) == 0 &&
         (!words.has('F') || plain_feed(s, words['F']) == s.feed);
}

/// The piece of such a block: the one that waits, with another way. False where the general path
/// has something to say about it.
bool shape(MotionContext& m, const BlockWords& block, int path, Piece& piece) {
  const MotionState& s = m.state;
  Axes end = s.work;
  piece.named = straight_axes(block.words.mask & kEndWords);
  for (std::size_t i = 0; i < 3; ++i)
    if ((piece.named >> i & 1) != 0)
      end[i] = number(m, block, kAxisNames[i]) + (s.incremental ? end[i] : 0);
  piece.end = end + piece.offset;
  piece.step = block.step;
  piece.at = block.words.at;
  piece.turn = 0;
  piece.centre = {};
  if (path < 2) {
    piece.kind = path == 0 ? MoveKind::Rapid : MoveKind::Feed;
    return true;
  }
  piece.kind = path == 2 ? MoveKind::Cw : MoveKind::Ccw;
  if (may_have_corner(m, block) && (corner_words(m, block, piece) || piece.corner != 0))
    return false;
  return !shape_arc(m, block, piece) && (piece.turn != 0 || piece.kind == MoveKind::Feed);
}

/// Records the waiting move up to the corner with this one. When it is false nothing has changed.
bool record_waiting(MoveSink& sink, const Piece& piece) {
  MotionState& s = sink.state;
  Held& held = s.held;
  RadiusPath path(sink, piece.plane);
  const Axes from = s.work + piece.offset;
  const Point start = path.view.point(from), corner = path.view.point(held.radius_to);
  if (start.a != corner.a || start.b != corner.b || !path.moves_in_plane(piece, from)) return false;
  const Curve curve = curve_of(path.view, from, piece);
  if (path.is_low_step(piece, curve)) return false;
  const Curve before = path.waiting_curve();
  Join way;
  if (path.find_way(piece, before, curve, nullptr, way) || way.over != Join::None) return false;

  const BeforeRecord kept(s, *sink.table);
  if (path.leave(before, way.leave, &way, curve.start_direction())) {
    kept.put_back();
    return false;
  }
  held.radius_from = from;
  path.wait(piece, curve);
  return true;
}

}  // namespace

bool Motion::move_beside(const NcWords& words, int path, std::uint32_t step, Moves* moves,
                         Outcome& outcome) {
  MotionState& s = state_;
  if (!goes_on(view(), words, moves) || (path != 0 && !(s.feed > 0))) return false;
  Outside nothing;
  MotionOutcome made;
  MotionContext context{*facts_, s, log_, {*facts_, s, moves}, made, nothing};
  Piece piece = s.held.radius.front();
  if (!shape(context, {.words = words, .step = step}, path, piece)) return false;
  const Axes end = piece.end - piece.offset;
  if (!in_range(piece.end) || !in_range(end) || !record_waiting(context.sink, piece)) return false;

  take_code(*facts_, s, path);
  made.moves = 1;
  made.axis_word = true;
  made.moved = piece.turn != 0 || comes_elsewhere(s.work, end);
  s.work = end;
  s.tool_pending = false;
  s.moved_before = true;
  s.named |= piece.named;
  s.held.moved = false;
  s.held.idle = 0;
  outcome = made;
  return true;
}

void Motion::know_waiting(const NcWords& words, std::uint32_t step, Moves* moves) {
  MotionState& s = state_;
  if (!s.beside || moves == nullptr || s.held.radius.size() != 1) return;
  Piece& piece = s.held.radius.front();
  if (piece.step != step) return;
  Piece now = make_piece(view(), {.words = words, .step = step}, piece.kind, s.work, piece.named);
  now.end = piece.end;
  now.centre = piece.centre;
  now.turn = piece.turn;
  if (now != piece) return;
  s.row_state = piece.row_state =
      moves->intern(piece.state, piece.offset + piece.length, piece.tip);
  s.row_moves = piece.row_moves = moves;
}

}  // namespace cncsub
