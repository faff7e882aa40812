// From a block's motion to the rows of the table: the pieces, their lengths and times.
#include "cncsub/motion/emit.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/motion.hpp"
#include "cncsub/motion/path/path.hpp"

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

/// The tool's way on an arc, in the plane.
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

/// How long a piece takes, and how long its way is in the plane.
struct Way {
  bool arc = false;
  double in_plane = 0, seconds = 0;
};

/// The axes of a row: those that are named, and what a cycle moves beside them.
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

/// The row of a piece.
void write_row(MoveSink& sink, const Piece& piece, const Axes& machine,
               const std::array<double, 3>& vector, const Way& way) {
  Moves& moves = *sink.table;
  mark_axes(sink, machine, piece.named);
  moves.push(piece.step, piece.kind, piece.end - piece.offset,
             piece.row_moves == &moves
                 ? piece.row_state
                 : moves.intern(piece.state, piece.offset + piece.length, piece.tip));
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
  row.degree = g20(state) && mode != Meaning::InverseTime ? kInch : 1;
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
  piece.side = side_of(m.state);
  piece.radius = piece.side != 0 ? radius_value(m) : 0;
  if (piece.side != 0) piece.tip = tip_vector(m);
  return piece;
}

namespace {

Fault too_many_moves(const BlockWords& block) {
  return fault(Cause::ValueOutOfRange, block,
               "the block would make more than " + std::to_string(kMostMoves) + " moves");
}

/// Counts a move of a block, which may be one too many.
inline Result count_move(MotionContext& m, const BlockWords& block) {
  if (++m.outcome.moves > kMostMoves) return too_many_moves(block);
  if (m.outside.over(1)) return broken_off(block.words.at);
  return std::nullopt;
}

}  // namespace

Result move(MotionContext& m, BlockWords& block, const Piece& piece) {
  if (auto wrong = count_move(m, block)) return wrong;
  if (!in_range(piece.end)) return out_of_range(piece.at);
  const Axes from = m.state.work + piece.offset, end = piece.end - piece.offset;
  m.outcome.moved = m.outcome.moved || piece.turn != 0 || comes_elsewhere(m.state.work, end);
  m.state.work = end;
  m.state.tool_pending = false;
  m.state.named |= piece.named;
  m.outcome.axis_word = true;
  block.submitted = true;
  return through_corner(m.sink, piece, from);
}

namespace {

/// Whether a straight move goes to the table as it is: nothing waits for it, nothing turns it
/// aside, and there is no place where it may not go.
bool is_direct(const MotionContext& m) {
  const MotionState& s = m.state;
  return s.modal[at(Group::Radius)].meaning == Meaning::RadiusOff && !s.held.engaged &&
         s.held.radius.empty() && s.held.corner.empty() && m.facts.limits.empty() &&
         !checks_area(s) && m.sink.captured == nullptr;
}

/// How long a move takes that is told in coordinates as turned as those of the work system.
double seconds_in_machine(const MotionState& state, const MoveWay& way, const MotionFacts& facts) {
  if (state.frame_angle == 0) return seconds_of(way, facts.rapid, facts.diameters);
  const Axes from = in_machine(state, way.from), to = in_machine(state, way.to);
  return seconds_of({way.kind, way.state, from, to, way.path, way.zero, way.dwell}, facts.rapid,
                    facts.diameters);
}

/// How long a line is that goes directly, and how long it takes.
struct DirectWay {
  double length = 0, seconds = 0;
};

/// How many mm a minute a line goes, where that is the same all along it; else 0.
double even_rate(const MotionState& s) {
  const Meaning mode = s.modal[at(Group::Feed)].meaning;
  if (mode == Meaning::PerMinute) return s.feed;
  return mode == Meaning::PerRevolution && !s.surface ? s.feed * turning(s.speed) : 0;
}

/// The same of a cut, whose spindle may follow the diameter in the middle of its way.
double rate_of_cut(const MotionState& s, MoveKind kind, double from, double to) {
  if (kind != MoveKind::Feed || !s.surface ||
      s.modal[at(Group::Feed)].meaning != Meaning::PerRevolution)
    return even_rate(s);
  const double diameter = middle_diameter(from, to, s.offset[0] + s.length[0]);
  return s.feed * turning(spindle_at(s.surface_speed, s.max_speed, diameter));
}

DirectWay direct_way(MotionView m, MoveKind kind, const Axes& machine) {
  const MotionState& s = m.state;
  const Axes& from = s.tool_at;
  if (others_stand(from, machine) && s.frame_angle == 0) {
    const double dx = machine[0] - from[0], dy = machine[1] - from[1], dz = machine[2] - from[2];
    const double length = std::sqrt(dx * dx * s.half[0] + dy * dy + dz * dz);
    if (kind == MoveKind::Rapid) return {length, rapid_seconds(s, dx, dy, dz)};
    if (const double rate = rate_of_cut(s, kind, from[0], machine[0]); rate > 0)
      return {length, length / rate * 60};
  }
  const double length = length_of(from, machine, m.facts.diameters);
  const MoveState row = move_state(s);
  return {length,
          seconds_in_machine(s, {kind, row, from, machine, length, s.offset[0] + s.length[0], 0},
                             m.facts)};
}

/// The state of the rows of a block that go directly, which is the same for all of them.
std::uint32_t direct_state(MotionState& s, const BlockWords& block, Moves& table) {
  if (s.row_moves == &table) return s.row_state;
  MoveState row = move_state(s);
  row.cycle = block.cycle;
  s.row_moves = &table;
  return s.row_state = table.intern(row, s.offset + s.length);
}

/// What `move` does with a piece, without one.
Result move_directly(MotionContext& m, BlockWords& block, MoveKind kind, const Axes& end,
                     std::uint32_t named) {
  MotionState& s = m.state;
  const Axes machine = machine_point(s, end);
  const auto [length, seconds] = direct_way(m, kind, machine);
  if (!in_range(machine) || !in_range(length, seconds, s.time + seconds))
    return out_of_range(block.words.at);
  m.outcome.axis_word = block.submitted = true;
  m.outcome.moved = m.outcome.moved || comes_elsewhere(s.work, end);
  s.tool_pending = false;
  s.named |= named;
  s.work = end;
  s.time += seconds;
  if (Moves* table = m.sink.table; table != nullptr) {
    mark_axes(m.sink, machine, named);
    table->push(block.step, kind, end, direct_state(s, block, *table));
  }
  s.tool_at = machine;
  return std::nullopt;
}

}  // namespace

Result move(MotionContext& m, BlockWords& block, MoveKind kind, const Axes& work_end,
            std::uint32_t named) {
  if (!is_direct(m)) return move(m, block, make_piece(m, block, kind, work_end, named));
  if (auto wrong = count_move(m, block)) return wrong;
  return move_directly(m, block, kind, work_end, named);
}

namespace {

/// Whether a move of X, Y or Z alone is one behind a direct move of the same block: where the other
/// axes are, and what holds for the rows, is as it was there.
bool goes_on_directly(const MotionContext& m, MoveKind kind, int axis) {
  const MotionState& s = m.state;
  return axis < 3 && m.sink.table != nullptr && s.row_moves == m.sink.table && s.frame_angle == 0 &&
         (kind == MoveKind::Rapid || even_rate(s) > 0) && is_direct(m);
}

/// What `move_directly` does on one axis.
Result move_axis_directly(MotionContext& m, const BlockWords& block, MoveKind kind,
                          std::size_t axis, double value) {
  MotionState& s = m.state;
  const double machine = value + (s.offset[axis] + s.length[axis]);
  const double way = std::fabs(machine - s.tool_at[axis]);
  const double length = way * m.facts.share(static_cast<int>(axis));
  const double seconds =
      kind == MoveKind::Rapid ? way * s.rapid_seconds[axis] : length / even_rate(s) * 60;
  if (!in_range(machine, length, seconds, s.time + seconds)) return out_of_range(block.words.at);
  m.outcome.moved = m.outcome.moved || std::fabs(value - s.work[axis]) >= kStanding;
  s.named |= axis_bit(static_cast<int>(axis));
  s.work[axis] = value;
  s.tool_at[axis] = machine;
  s.time += seconds;
  m.sink.table->mark(axis_bit(static_cast<int>(axis)));
  m.sink.table->push(block.step, kind, s.work, s.row_state);
  return std::nullopt;
}

}  // namespace

Result move_axis(MotionContext& m, BlockWords& block, MoveKind kind, int axis, double value) {
  if (goes_on_directly(m, kind, axis)) {
    if (auto wrong = count_move(m, block)) return wrong;
    return move_axis_directly(m, block, kind, static_cast<std::size_t>(axis), value);
  }
  Axes end = m.state.work;
  end[static_cast<std::size_t>(axis)] = value;
  return move(m, block, kind, end, axis_bit(axis));
}

Result add_dwell(MotionContext& m, BlockWords& block, double seconds) {
  Piece piece = make_piece(m, block, MoveKind::Dwell, m.state.work, 0);
  piece.seconds = seconds;
  return through_radius(m.sink, piece, m.state.work + piece.offset);
}

namespace {

/// How fast a line goes that no limit and no turned coordinates concern: the same all along it. 0
/// where it is another move.
double rate_of_line(const MoveSink& sink, const Piece& piece) {
  const MoveState& row = piece.state;
  if (piece.kind != MoveKind::Feed || sink.table == nullptr || piece.row_moves != sink.table ||
      sink.captured != nullptr || sink.state.frame_angle != 0 || !sink.facts.limits.empty() ||
      piece.skip != SkipMove::No || sink.table->size() == 0 || checks_area(sink.state))
    return 0;
  if (row.feed_mode == FeedMode::PerMinute) return row.feed;
  const bool even = row.feed_mode == FeedMode::PerRevolution && !row.surface;
  return even ? row.feed * turning(row.spindle) : 0;
}

/// Whether only X, Y and Z of the tool come to another place at the end of a piece.
bool others_stand_at(const Axes& tool, const Piece& piece) {
  std::uint64_t different = 0;
  for (std::size_t i = 3; i < tool.size(); ++i)
    different |= std::bit_cast<std::uint64_t>(tool[i]) ^
                 std::bit_cast<std::uint64_t>(piece.end[i] + piece.length[i]);
  return different == 0;
}

/// What `record_move` does with a line of X, Y and Z. Nothing but these is looked at, each by
/// itself: what is just written by parts is not read back in one piece.
Result record_line(MoveSink& sink, const Piece& piece, const std::array<double, 3>& vector,
                   double rate) {
  MotionState& s = sink.state;
  const double x = piece.end[0] + piece.length[0] + vector[0],
               y = piece.end[1] + piece.length[1] + vector[1],
               z = piece.end[2] + piece.length[2] + vector[2];
  const double dx = x - s.tool_at[0], dy = y - s.tool_at[1], dz = z - s.tool_at[2];
  const double length = std::sqrt(dx * dx * s.half[0] + dy * dy * s.half[1] + dz * dz * s.half[2]);
  const double seconds = length / rate * 60;
  if (!in_range(x, y, z, length, seconds, s.time + seconds)) return out_of_range(piece.at);
  s.time += seconds;
  s.tool_at[0] = x;
  s.tool_at[1] = y;
  s.tool_at[2] = z;
  Moves& moves = *sink.table;
  if (piece.named >> 3 != 0)
    moves.use(piece.named);
  else
    moves.mark(piece.named);
  moves.push(piece.step, piece.kind, piece.end - piece.offset, piece.row_state);
  if (vector[0] != 0 || vector[1] != 0 || vector[2] != 0) moves.vector(vector);
  return std::nullopt;
}

}  // namespace

Result record_move(MoveSink& sink, const Piece& piece, const std::array<double, 3>& vector) {
  if (const double rate = rate_of_line(sink, piece);
      rate > 0 && others_stand_at(sink.state.tool_at, piece))
    return record_line(sink, piece, vector, rate);
  Axes machine = piece.end + piece.length;
  for (std::size_t i = 0; i < 3; ++i) machine[i] += vector[i];
  if (!in_range(machine) || !in_range(piece.centre)) return out_of_range(piece.at);
  if (sink.state.frame_angle != 0 && (!sink.facts.limits.empty() || checks_area(sink.state)))
    return Fault{Cause::CodeNotComputed, piece.at, 1, "limits of travel in a turned work system"};
  if (!sink.facts.limits.empty())
    if (auto wrong = check_travel(sink, piece, machine)) return wrong;
  if (checks_area(sink.state))
    if (auto wrong = check_area(sink, piece, machine)) return wrong;
  const Axes& from = sink.state.tool_at;
  const std::uint32_t diameters = sink.facts.diameters;
  Way way;
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
