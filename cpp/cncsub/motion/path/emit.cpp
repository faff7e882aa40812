// From a block's motion to the rows of the table: the pieces, their lengths and times.
#include "cncsub/motion/path/emit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/path/path.hpp"
#include "cncsub/motion/state/modes.hpp"

namespace cncsub {
namespace {

std::array<double, 3> centre_of(const Piece& piece) {
  const PlaneAxes plane = arc_axes(piece.plane, piece.state.parallel);
  std::array<double, 3> centre;
  centre.fill(std::numeric_limits<double>::quiet_NaN());
  for (const int axis : {plane.a, plane.b})
    centre[centre_place(axis)] =
        piece.centre[centre_place(axis)] - piece.offset[static_cast<std::size_t>(axis)];
  return centre;
}

/// Return the length of the tool's path on an arc, in the plane.
double arc_in_plane(MotionView m, const Piece& piece, const Axes& machine) {
  const PlaneAxes plane = arc_axes(piece.plane, piece.state.parallel);
  const auto polar = [&](const Axes& p) {
    const auto part = [&](int i) {
      const std::size_t at = centre_place(i);
      return (p[i] - piece.length[i] - piece.tip[at] - piece.centre[at]) * m.facts.share(i);
    };
    return std::array<double, 2>{std::hypot(part(plane.a), part(plane.b)),
                                 std::atan2(part(plane.b), part(plane.a))};
  };
  const auto from = polar(m.state.tool_at), to = polar(machine);
  double turn = piece.turn + std::remainder(to[1] - from[1] - piece.turn, 2 * kPi);
  const double most = 2 * kPi * std::max(1.0, std::ceil(std::fabs(piece.turn) / (2 * kPi) - 1e-9));
  if (std::fabs(turn) > most + 1e-6) turn -= std::copysign(2 * kPi, turn);  // cut by half
  return spiral_length(from[0], to[0], turn);
}

/// Return how long a move takes whose coordinates are rotated as those of the work system.
double seconds_in_machine(const MotionState& state, const TimedMove& way,
                          const MotionFacts& facts) {
  if (state.frame_angle == 0) return seconds_of(way, facts.rapid, facts.diameters);
  const Axes from = in_machine(state, way.from), to = in_machine(state, way.to);
  return seconds_of({way.kind, way.state, from, to, way.path, way.zero, way.dwell}, facts.rapid,
                    facts.diameters);
}

/// The time of a piece, and the length of its path in the plane.
struct PieceLength {
  bool arc = false;
  double in_plane = 0, seconds = 0;
};

/// Mark the axes of a row: the named ones, and those that a cycle moves beside them.
void mark_axes(MoveSink& sink, const Axes& machine, std::uint32_t named) {
  Moves& moves = *sink.table;
  const Axes& from = sink.state.tool_at;
  if (moves.size() == 0)
    moves.begin(in_machine(sink.state, from), sink.facts.rapid, sink.facts.diameters);
  if (!others_stand(from, machine))
    for (int i = 3; i < kAxes; ++i)
      if (std::fabs(machine[i] - from[i]) >= kStanding) named |= axis_bit(i);
  if (named >> 3 != 0)
    moves.use(named);
  else
    moves.mark(named);
}

/// Write the row of a piece.
void write_row(MoveSink& sink, const Piece& piece, const Axes& machine,
               const std::array<double, 3>& vector, const PieceLength& way) {
  Moves& moves = *sink.table;
  mark_axes(sink, machine, piece.named);
  moves.push(piece.step, piece.kind, piece.end - piece.offset,
             moves.intern(piece.state, piece.offset + piece.length, piece.tip));
  if (way.arc) moves.arc(centre_of(piece), way.in_plane);
  if (vector[0] != 0 || vector[1] != 0 || vector[2] != 0) moves.vector(vector);
  if (piece.kind == MoveKind::Dwell) moves.seconds(piece.seconds);
  if (piece.skip != SkipMove::No) moves.skip(piece.skip);
}

}  // namespace

MoveState move_state(const MotionState& state) {
  MoveState row;
  row.feed = state.feed;
  row.spindle = state.surface ? state.surface_speed : state.speed;
  row.max_spindle = state.max_speed;
  row.surface = state.surface;
  row.tool = state.tool;
  row.h = state.h;
  row.d = state.d;
  row.plane = state.plane;
  row.turned = state.frame_angle;
  const Meaning mode = state.modal[at(Group::Feed)].meaning;
  row.feed_mode = mode == Meaning::PerRevolution ? FeedMode::PerRevolution
                  : mode == Meaning::InverseTime ? FeedMode::InverseTime
                                                 : FeedMode::PerMinute;
  row.degree = mode != Meaning::InverseTime ? degree_of_feed(state) : 1;
  return row;
}

Piece uncompensated(MotionView m, const BlockWords& block, MoveKind kind, const Axes& work_end,
                    std::uint32_t named) {
  const Axes offset = piece_offset(m.state);
  Piece piece{.kind = kind,
              .step = block.step,
              .end = work_end + offset,
              .named = named,
              .plane = m.state.plane,
              .at = block.words.at,
              .offset = offset,
              .length = piece_length(m.state),
              .state = move_state(m.state)};
  piece.state.cycle = block.cycle;
  return piece;
}

Piece make_piece(MotionView m, const BlockWords& block, MoveKind kind, const Axes& work_end,
                 std::uint32_t named) {
  Piece piece = uncompensated(m, block, kind, work_end, named);
  piece.side = mirrored_plane(m.state) ? -side_of(m.state) : side_of(m.state);
  piece.radius = piece.side != 0 ? radius_value(m) + m.state.contour_offset : 0;
  if (piece.side != 0) piece.tip = tip_vector(m);
  return piece;
}

namespace {

Fault too_many_moves(const BlockWords& block) {
  return fault(Cause::ValueOutOfRange, block,
               "the block would make more than " + std::to_string(kMostMoves) + " moves");
}

/// Count a move of a block, which may be one too many.
inline Result count_move(MotionContext& m, const BlockWords& block) {
  if (++m.outcome.moves > kMostMoves) return too_many_moves(block);
  if (m.inputs.over(1)) return broken_off(block.words.at);
  return std::nullopt;
}

/// Keep the direction in which a piece ends, as the frame of the program counts it.
void keep_heading(MotionState& state, const Piece& piece, const Axes& from) {
  std::array<double, 3> way{};
  if (piece.turn == 0) {
    for (std::size_t i = 0; i < way.size(); ++i) way[i] = piece.end[i] - from[i];
  } else {
    const PlaneAxes plane = plane_axes(piece.plane);
    const double side = piece.turn < 0 ? -1 : 1;
    const auto arm = [&](int axis) {
      return piece.end[static_cast<std::size_t>(axis)] - piece.centre[centre_place(axis)];
    };
    way[static_cast<std::size_t>(plane.a)] = -side * arm(plane.b);
    way[static_cast<std::size_t>(plane.b)] = side * arm(plane.a);
  }
  if (std::hypot(way[0], way[1], way[2]) < kStanding) return;
  Axes direction{};
  std::copy(way.begin(), way.end(), direction.begin());
  if (state.frame.turned) direction = turned_back(state.frame, direction);
  std::copy_n(direction.begin(), way.size(), state.heading.begin());
}

}  // namespace

Result move(MotionContext& m, BlockWords& block, const Piece& piece) {
  if (auto wrong = count_move(m, block)) return wrong;
  if (!in_range(piece.end)) return out_of_range(piece.at);
  const Axes from = m.state.work + piece.offset, end = piece.end - piece.offset;
  if (m.facts.keeps_heading) keep_heading(m.state, piece, from);
  m.outcome.moved = m.outcome.moved || piece.turn != 0 || comes_elsewhere(m.state.work, end);
  m.state.work = end;
  m.state.tool_pending = false;
  m.state.named |= piece.named;
  m.outcome.axis_word = true;
  block.submitted = true;
  return through_corner(m, piece, from);
}

Result move(MotionContext& m, BlockWords& block, MoveKind kind, const Axes& work_end,
            std::uint32_t named) {
  return move(m, block, make_piece(m, block, kind, work_end, named));
}

Result move_axis(MotionContext& m, BlockWords& block, MoveKind kind, int axis, double value) {
  Axes end = m.state.work;
  end[static_cast<std::size_t>(axis)] = value;
  return move(m, block, kind, end, axis_bit(axis));
}

Result add_dwell(MotionContext& m, BlockWords& block, double seconds) {
  Piece piece = make_piece(m, block, MoveKind::Dwell, m.state.work, 0);
  piece.seconds = seconds;
  return through_radius(m, piece, m.state.work + piece.offset);
}

Result record_move(MoveSink& sink, const Piece& piece, const std::array<double, 3>& vector) {
  Axes machine = piece.end + piece.length;
  for (std::size_t i = 0; i < 3; ++i) machine[i] += vector[i];
  if (!in_range(machine) || !in_range(piece.centre)) return out_of_range(piece.at);
  if (sink.state.frame_angle != 0 && (!sink.facts.limits.empty() || checks_area(sink.state)))
    return Fault{Cause::CodeNotComputed, piece.at, 1,
                 "cncsub does not check the limits of travel in a turned work system"};
  if (!sink.facts.limits.empty())
    if (auto wrong = check_travel(sink, piece, machine)) return wrong;
  if (checks_area(sink.state))
    if (auto wrong = check_area(sink, piece, machine)) return wrong;
  const Axes& from = sink.state.tool_at;
  const std::uint32_t diameters = sink.facts.diameters;
  PieceLength way;
  way.arc = piece.kind == MoveKind::Cw || piece.kind == MoveKind::Ccw;
  way.in_plane = way.arc ? arc_in_plane(sink, piece, machine) : length_of(from, machine, diameters);
  const double length = way.arc
                            ? arc_length(way.in_plane, arc_axes(piece.plane, piece.state.parallel),
                                         from, machine, diameters)
                            : way.in_plane;
  const double zero = piece.offset[0] + piece.length[0];
  way.seconds = seconds_in_machine(
      sink.state, {piece.kind, piece.state, from, machine, way.in_plane, zero, piece.seconds},
      sink.facts);
  if (!in_range(length, way.seconds, sink.state.time + way.seconds)) return out_of_range(piece.at);
  if (sink.captured != nullptr) sink.captured->push_back(piece);
  sink.state.time += way.seconds;
  if (sink.table != nullptr) write_row(sink, piece, machine, vector, way);
  sink.state.tool_at = machine;
  return std::nullopt;
}

}  // namespace cncsub
