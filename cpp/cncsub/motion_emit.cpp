// From a block's motion to the rows of the table: the pieces, their lengths and times.
#include <limits>

#include "cncsub/motion_facts.hpp"

namespace cncsub {

Axes Motion::machine_point() const { return s_.work + s_.offset + s_.length; }

MoveState Motion::move_state() const {
  MoveState state;
  state.feed = s_.feed;
  state.spindle = s_.surface ? s_.surface_speed : s_.speed;
  state.max_spindle = s_.max_speed;
  state.surface = s_.surface;
  state.tool = s_.tool;
  state.h = s_.h;
  state.d = s_.d;
  state.plane = static_cast<std::uint8_t>(s_.plane);
  const Meaning mode = s_.modal[at(Group::Feed)].meaning;
  state.feed_mode = mode == Meaning::PerRevolution ? FeedMode::PerRevolution
                    : mode == Meaning::InverseTime ? FeedMode::InverseTime
                                                   : FeedMode::PerMinute;
  state.degree = g20() && mode != Meaning::InverseTime ? kInch : 1;
  return state;
}

bool Motion::set_plain_feed(double value) {
  value *= s_.unit;
  if (value == s_.feed) return true;
  s_.feed = value;
  s_.row_moves = nullptr;
  set_seconds_per_mm();
  return true;
}

void Motion::new_row_state(Moves& moves) {
  if (moves.size() == 0) moves.begin(machine_point(), facts_->rapid, facts_->diameters);
  s_.row_state = moves.intern(move_state(), s_.offset + s_.length);
  s_.row_moves = &moves;
}

/// A motion of this block to a point in work coordinates.
Piece Motion::make_piece(const BlockWords& block, MoveKind kind, const Axes& work_end,
                         std::uint32_t named) const {
  Piece piece;
  piece.kind = kind;
  piece.step = block.step;
  piece.end = work_end + s_.offset;
  piece.named = named;
  piece.plane = s_.plane;
  piece.at = block.words.at;
  piece.offset = s_.offset;
  piece.length = s_.length;
  piece.state = move_state();
  const Meaning radius = s_.modal[at(Group::Radius)].meaning;
  if (s_.held.suspended) return piece;
  piece.side = radius == Meaning::RadiusLeft ? -1 : radius == Meaning::RadiusRight ? 1 : 0;
  piece.radius = piece.side != 0 ? radius_value() : 0;
  if (piece.side != 0) piece.tip = tip_vector();
  return piece;
}

Motion::Result Motion::move(BlockWords& block, Piece piece) {
  if (++block.outcome.moves > kMostMoves)
    return fault(Cause::ValueOutOfRange, block,
                 "the block would make more than " + std::to_string(kMostMoves) + " moves");
  if (block.outside.over(1)) return broken_off(block.words.at);
  if (!in_range(piece.end)) return out_of_range(piece.at);
  const Axes before = s_.work;
  s_.work = piece.end - piece.offset;
  s_.tool_pending = false;
  s_.named |= piece.named;
  block.outcome.axis_word = true;
  if (piece.turn != 0) block.outcome.moved = true;
  for (int i = 0; i < kAxes; ++i)
    if (std::fabs(s_.work[i] - before[i]) >= 1e-12) block.outcome.moved = true;
  block.submitted = true;
  return through_corner(piece, before + piece.offset, block.moves);
}

Motion::Result Motion::move(BlockWords& block, MoveKind kind, const Axes& work_end,
                            std::uint32_t named) {
  return move(block, make_piece(block, kind, work_end, named));
}

Motion::Result Motion::move_axis(BlockWords& block, MoveKind kind, int axis, double value) {
  Axes end = s_.work;
  end[static_cast<std::size_t>(axis)] = value;
  return move(block, kind, end, axis_bit(axis));
}

Motion::Result Motion::wait(BlockWords& block, double seconds) {
  Piece piece = make_piece(block, MoveKind::Dwell, s_.work, 0);
  piece.seconds = seconds;
  return through_radius(piece, s_.work + s_.offset, block.moves);
}

/// Writes the row of a piece whose tool path is known. `vector` leads from the programmed point to
/// the tool.
Motion::Result Motion::record(const Piece& piece, Moves* moves,
                              const std::array<double, 3>& vector) {
  Axes machine = piece.end + piece.length;
  for (std::size_t i = 0; i < 3; ++i) machine[i] += vector[i];
  if (!in_range(machine) || !in_range(piece.centre)) return out_of_range(piece.at);
  if (auto wrong = check_travel(piece, machine)) return wrong;
  if (auto wrong = check_area(piece, machine)) return wrong;
  const bool round = piece.kind == MoveKind::Cw || piece.kind == MoveKind::Ccw;
  const double path =
      round ? arc_in_plane(piece, machine) : length_of(s_.tool_at, machine, facts_->diameters);
  const double length =
      round ? arc_length(path, piece.plane, s_.tool_at, machine, facts_->diameters) : path;
  const double zero = piece.offset[0] + piece.length[0];
  const double seconds =
      seconds_of({piece.kind, piece.state, s_.tool_at, machine, path, zero, piece.seconds},
                 facts_->rapid, facts_->diameters);
  if (!in_range(std::array{length, seconds, s_.time + seconds})) return out_of_range(piece.at);
  if (captured_ != nullptr) captured_->push_back(piece);
  s_.time += seconds;
  if (moves != nullptr) {
    if (moves->size() == 0) moves->begin(s_.tool_at, facts_->rapid, facts_->diameters);
    const Axes point = piece.end - piece.offset;
    std::uint32_t axes = piece.named;  // and what a cycle moves beside them
    for (int i = 3; i < kAxes; ++i)
      if (machine[i] != s_.tool_at[i]) axes |= axis_bit(i);
    if (axes >> 3 != 0)
      moves->use(axes);
    else
      moves->mark(axes);
    moves->push(piece.step, piece.kind, point,
                moves->intern(piece.state, piece.offset + piece.length));
    if (round) moves->arc(centre_of(piece), path);
    if (vector[0] != 0 || vector[1] != 0 || vector[2] != 0) moves->vector(vector);
    if (piece.kind == MoveKind::Dwell) moves->seconds(piece.seconds);
    if (piece.skip != SkipMove::No) moves->skip(piece.skip);
  }
  s_.tool_at = machine;
  return std::nullopt;
}

std::array<double, 3> Motion::centre_of(const Piece& piece) const {
  const PlaneAxes plane = plane_axes(piece.plane);
  std::array<double, 3> centre;
  for (int i = 0; i < 3; ++i)
    centre[i] = i == plane.across ? std::numeric_limits<double>::quiet_NaN()
                                  : piece.centre[i] - piece.offset[i];
  return centre;
}

/// The tool's way on an arc, in the plane.
double Motion::arc_in_plane(const Piece& piece, const Axes& machine) const {
  const PlaneAxes plane = plane_axes(piece.plane);
  const auto polar = [&](const Axes& p) {
    const auto part = [&](int i) {
      return (p[i] - piece.length[i] - piece.tip[i] - piece.centre[i]) * facts_->share(i);
    };
    return std::array<double, 2>{std::hypot(part(plane.a), part(plane.b)),
                                 std::atan2(part(plane.b), part(plane.a))};
  };
  const auto from = polar(s_.tool_at), to = polar(machine);
  double turn = piece.turn + std::remainder(to[1] - from[1] - piece.turn, 2 * kPi);
  if (std::fabs(turn) > 2 * kPi + 1e-6) turn -= std::copysign(2 * kPi, turn);  // cut by half
  return spiral_length(from[0], to[0], turn);
}

}  // namespace cncsub
