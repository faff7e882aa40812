// A move that compensation leads beside its way, behind another of which all but the way is the
// same: what contours are made of. The one that waits is known to have been made under the modes
// that hold, so that nothing of them is asked again; and little changes, so that little is kept.
#include "cncsub/motion/emit.hpp"
#include "cncsub/motion/fast_path.hpp"
#include "cncsub/motion/frame/frame.hpp"
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

/// Whether a move has what the modes that hold give one, and nothing beside it.
bool is_made_under(MotionView m, const Piece& piece) {
  const MotionState& s = m.state;
  return piece.side == side_of(s) && piece.plane == s.plane && piece.corner == 0 &&
         !piece.corner_piece && piece.skip == SkipMove::No && piece.seconds == 0 &&
         same_bits(piece.offset, piece_offset(s)) && same_bits(piece.length, piece_length(s)) &&
         same_bits(piece.state, move_state(s)) && piece.radius == radius_value(m) &&
         piece.tip == tip_vector(m);
}

/// The way of such a block, base: all in which it differs from the move that waits.
struct Goal {
  MoveKind kind = MoveKind::Feed;
  std::uint32_t named = 0;
  double x = 0, y = 0, z = 0;  // its end
  std::array<double, 3> centre{};
  double turn = 0;

  /// Where it ends from here, each axis by itself: what is just written by parts is not read back
  /// in one piece.
  void set_end(Axes& end, const MotionState& s, const Axes& offset) const {
    for (std::size_t i = 3; i < end.size(); ++i) end[i] = s.work[i] + offset[i];
    end[0] = x, end[1] = y, end[2] = z;
  }
};

bool find_arc(MotionView m, const BlockWords& block, Goal& goal, MotionOutcome& outcome) {
  Piece piece = m.state.held.radius.front();
  piece.kind = goal.kind;
  piece.named = goal.named;
  goal.set_end(piece.end, m.state, piece.offset);
  piece.turn = 0;
  piece.centre = {};
  if (may_have_corner(m, block) && (corner_words(m, block, piece) || piece.corner != 0))
    return false;
  if (shape_arc(m, block, piece, outcome)) return false;
  goal.kind = piece.kind;
  goal.centre = piece.centre;
  goal.turn = piece.turn;
  return piece.turn != 0 || piece.kind == MoveKind::Feed;
}

/// False where the general path has something to say about it.
bool find_goal(MotionView m, const BlockWords& block, int path, Goal& goal,
               MotionOutcome& outcome) {
  const MotionState& s = m.state;
  constexpr std::array<MoveKind, 4> kKinds{MoveKind::Rapid, MoveKind::Feed, MoveKind::Cw,
                                           MoveKind::Ccw};
  goal.kind = kKinds[static_cast<std::size_t>(path)];
  goal.named = straight_axes(block.words.mask & kEndWords);
  const Axes& offset = s.held.radius.front().offset;
  const auto end = [&](std::size_t axis) {
    if ((goal.named >> axis & 1) == 0) return s.work[axis];
    return number(m, block, kAxisNames[axis]) + (s.incremental ? s.work[axis] : 0);
  };
  const double x = end(0) + offset[0], y = end(1) + offset[1], z = end(2) + offset[2];
  goal.x = x, goal.y = y, goal.z = z;
  return in_range(x, y, z, x - offset[0], y - offset[1], z - offset[2]) &&
         (path < 2 || find_arc(m, block, goal, outcome));
}

/// Records the move that waits up to the corner with this one, which waits in its place. When it
/// is false nothing has changed.
bool take_place(MoveSink& sink, const BlockWords& block, const Goal& goal) {
  MotionState& s = sink.state;
  Held& held = s.held;
  Piece& piece = held.radius.front();
  RadiusPath path(sink, piece.plane);
  const Axes from = s.work + piece.offset;
  const Point start = path.view.point(from), corner = path.view.point(held.radius_to);
  const std::array end{goal.x, goal.y, goal.z};
  const Curve curve(start, path.view.point(end), path.view.point(goal.centre), goal.turn);
  const bool moves = std::fabs(curve.turn) > kPi || !path.same(curve.from, curve.to);
  if (start.a != corner.a || start.b != corner.b || !moves) return false;
  const double side = offset_of(piece);
  if (path.is_low_step(side, curve)) return false;
  const Curve before = path.waiting_curve();
  Join way;
  if (path.find_way(side, block.words.at, before, curve, nullptr, way) || way.over != Join::None)
    return false;

  const BeforeRecord kept(s, *sink.table);
  if (path.record_waiting(before, way.leave, &way, curve.start_direction())) {
    kept.put_back();
    return false;
  }
  held.starting = false;
  held.engaged = true;
  held.radius_from = from;
  goal.set_end(piece.end, s, piece.offset);
  goal.set_end(held.radius_to, s, piece.offset);
  keep_curve(held, curve);
  piece.kind = goal.kind;
  piece.named = goal.named;
  piece.centre = goal.centre;
  piece.turn = goal.turn;
  piece.step = block.step;
  piece.at = block.words.at;
  return true;
}

}  // namespace

bool move_beside(MoveSink& sink, const BlockWords& block, int path, MotionOutcome& outcome) {
  MotionState& s = sink.state;
  if (!goes_on(sink, block.words, sink.table) || (path != 0 && !(s.feed > 0))) return false;
  Goal goal;
  outcome = {};
  if (!find_goal(sink, block, path, goal, outcome) || !take_place(sink, block, goal)) return false;

  take_code(sink.facts, s, path);
  outcome.moves = 1;
  outcome.axis_word = true;
  const Piece& piece = s.held.radius.front();
  const Axes& offset = piece.offset;
  outcome.moved = goal.turn != 0;
  const auto come = [&](std::size_t axis, double end) {
    outcome.moved = outcome.moved || std::fabs(end - s.work[axis]) >= kStanding;
    s.work[axis] = end;
  };
  come(0, goal.x - offset[0]);
  come(1, goal.y - offset[1]);
  come(2, goal.z - offset[2]);
  for (std::size_t i = 3; i < offset.size(); ++i) come(i, piece.end[i] - offset[i]);
  s.tool_pending = false;
  s.moved_before = true;
  s.named |= goal.named;
  s.held.moved = false;
  s.held.idle = 0;
  return true;
}

void know_waiting(MoveSink& sink, std::uint32_t step) {
  MotionState& s = sink.state;
  if (!s.beside || sink.table == nullptr || s.held.radius.size() != 1) return;
  Piece& piece = s.held.radius.front();
  if (piece.step != step || !is_made_under(sink, piece)) return;
  s.row_state = piece.row_state =
      sink.table->intern(piece.state, piece.offset + piece.length, piece.tip);
  s.row_moves = piece.row_moves = sink.table;
}

}  // namespace cncsub
