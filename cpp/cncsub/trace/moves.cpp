#include "cncsub/trace/moves.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cncsub {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kPi = 3.14159265358979323846;

int axis_of(char name) {
  const auto found = kAxisNames.find(static_cast<char>(name >= 'a' ? name - 'a' + 'A' : name));
  return found == std::string_view::npos ? -1 : static_cast<int>(found);
}

}  // namespace

void Moves::grow() {
  const std::size_t chunk = rows_ / Chunk::kRows;
  room_.chunk = chunk < chunks_.size() ? &chunks_.own(chunk) : &chunks_.add();
  room_.end = (chunk + 1) * Chunk::kRows;
}

Moves Moves::next_part() const {
  Moves next;
  next.used_ = used_;
  for (const Extra& extra : extras_) next.extras_.push_back({extra.axis, 0, {}});
  return next;
}

void Moves::begin(const Axes& machine, const Axes& rapid, std::uint32_t diameters) {
  start_ = machine;
  rapid_ = rapid;
  diameters_ = diameters;
}

std::uint32_t Moves::intern(MoveState state, const Axes& offset) {
  if (offsets_.empty() || offsets_.back() != offset) offsets_.push(offset);
  state.offset = static_cast<std::uint32_t>(offsets_.size() - 1);
  if (states_.empty() || !(states_.back() == state)) states_.push(state);
  return static_cast<std::uint32_t>(states_.size() - 1);
}

void Moves::use(std::uint32_t axes) {
  for (int axis = 3; axis < kAxes; ++axis) {
    if ((axes >> axis & 1) == 0 || (used_ >> axis & 1) != 0) continue;
    extras_.push_back({axis, rows_, {}});
  }
  used_ |= axes;
}

void Moves::push_extras(const Axes& point) {
  for (Extra& extra : extras_) extra.values.push(point[extra.axis]);
}

void Moves::arc(std::array<double, 3> centre, double in_plane) {
  arcs_.push({static_cast<std::uint32_t>(rows_ - 1), centre, in_plane});
}

void Moves::vector(const std::array<double, 3>& vector) {
  vectors_.push({static_cast<std::uint32_t>(rows_ - 1), vector});
}

void Moves::seconds(double time) { seconds_.push({static_cast<std::uint32_t>(rows_ - 1), time}); }

void Moves::skip(SkipMove how) { skips_.push({static_cast<std::uint32_t>(rows_ - 1), how}); }

namespace {

/// The first entry of a list by row that belongs to this row or one behind it.
template <class List>
std::size_t find_row(const List& list, std::size_t row) {
  std::size_t low = 0, high = list.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    (list[middle].row < row ? low : high) = list[middle].row < row ? middle + 1 : middle;
  }
  return low;
}

}  // namespace

void Moves::truncate(std::size_t rows) {
  if (rows >= rows_) return;
  arcs_.keep(find_row(arcs_, rows));
  vectors_.keep(find_row(vectors_, rows));
  seconds_.keep(find_row(seconds_, rows));
  skips_.keep(find_row(skips_, rows));
  for (Extra& extra : extras_) {
    extra.first = std::min(rows, extra.first);
    extra.values.keep(rows - extra.first);
  }
  rows_ = rows;
  chunks_.keep((rows + Chunk::kRows - 1) / Chunk::kRows);
  room_ = {};
}

Axes Moves::point(std::size_t row) const {
  const Chunk& chunk = chunks_[row / Chunk::kRows];
  const std::size_t place = row % Chunk::kRows;
  Axes point = start_;  // an axis without a column stands where it stood, in any coordinates
  const Axes& offset = offsets_[states_[chunk.state[place]].offset];
  for (std::size_t i = 3; i < point.size(); ++i) point[i] -= offset[i];
  point[0] = chunk.x[place];
  point[1] = chunk.y[place];
  point[2] = chunk.z[place];
  for (const Extra& extra : extras_)
    if (row >= extra.first) point[extra.axis] = extra.values[row - extra.first];
  return point;
}

/// Visits rows in order with everything that follows from them.
struct Moves::Walk {
  const Moves& moves;
  std::size_t arc = 0, vector = 0, second = 0;
  Axes from{};  // machine position before the row

  void seek(std::size_t row) {
    arc = find_row(moves.arcs_, row);
    vector = find_row(moves.vectors_, row);
    second = find_row(moves.seconds_, row);
    from = moves.start_;
    if (row > 0) {
      Walk before{moves};
      before.arc = find_row(moves.arcs_, row - 1);
      before.vector = find_row(moves.vectors_, row - 1);
      before.second = find_row(moves.seconds_, row - 1);
      from = before.next(row - 1).machine;
    }
  }

  MoveRow next(std::size_t index) {
    const Chunk& chunk = moves.chunks_[index / Chunk::kRows];
    const std::size_t place = index % Chunk::kRows;
    MoveRow row;
    row.step = chunk.step[place];
    row.kind = chunk.kind[place];
    row.state = &moves.states_[chunk.state[place]];
    row.point = row.machine = moves.point(index);
    const Axes& offset = moves.offsets_[row.state->offset];
    for (int i = 0; i < kAxes; ++i) row.machine[i] += offset[i];
    if (vector < moves.vectors_.size() && moves.vectors_[vector].row == index) {
      const auto& v = moves.vectors_[vector++].vector;
      for (int i = 0; i < 3; ++i) row.machine[i] += v[i];
    }
    row.centre = {kNone, kNone, kNone};
    double path = row.length = length_of(from, row.machine, moves.diameters_);
    if (arc < moves.arcs_.size() && moves.arcs_[arc].row == index) {
      row.centre = moves.arcs_[arc].centre;
      path = moves.arcs_[arc++].in_plane;
      row.length = arc_length(path, row.state->plane, from, row.machine, moves.diameters_);
    }
    const bool lathe = (moves.diameters_ & 1) != 0;
    row.spindle = lathe ? spindle_at(*row.state, row.point[0]) : row.state->spindle;
    row.feed = row.state->feed / (row.length < kNoWay && turns(row) ? row.state->degree : 1);
    double dwell = 0;
    if (second < moves.seconds_.size() && moves.seconds_[second].row == index)
      dwell = moves.seconds_[second++].time;
    row.time = seconds_of({row.kind, *row.state, from, row.machine, path, offset[0], dwell},
                          moves.rapid_, moves.diameters_);
    from = row.machine;
    return row;
  }

  bool turns(const MoveRow& row) const {
    return row.machine[3] != from[3] || row.machine[4] != from[4] || row.machine[5] != from[5];
  }
};

MoveRow Moves::row(std::size_t index) const {
  Walk walk{*this};
  walk.seek(index);
  MoveRow row = walk.next(index);
  const std::size_t skip = find_row(skips_, index);
  if (skip < skips_.size() && skips_[skip].row == index) row.skip = skips_[skip].how;
  return row;
}

template <class Use>
void Moves::each_row(InterruptCheck* interrupt, Use&& use) const {
  for (std::size_t i = 0; i < rows_;) {
    for (const std::size_t end = std::min(rows_, i + Chunk::kRows); i < end; ++i) use(i);
    if (interrupt != nullptr && interrupt->requested(sizeof(Chunk))) return;
  }
}

template <class Use>
void Moves::walk(InterruptCheck* interrupt, Use&& use) const {
  Walk walk{*this};
  walk.from = start_;
  each_row(interrupt, [&](std::size_t i) { use(i, walk.next(i)); });
}

std::string Moves::axes() const {
  std::string names;
  for (int i = 0; i < kAxes; ++i)
    if ((used_ >> i & 1) != 0) names += kAxisNames[static_cast<std::size_t>(i)];
  return names;
}

double Moves::length(InterruptCheck* interrupt) const {
  double sum = 0;
  walk(interrupt, [&](std::size_t, const MoveRow& row) { sum += row.length; });
  return sum;
}

double Moves::time(InterruptCheck* interrupt) const {
  double sum = 0;
  walk(interrupt, [&](std::size_t, const MoveRow& row) { sum += row.time; });
  return sum;
}

namespace {

/// Widens the bounds of a plane's two axes by the quadrant points that an arc passes. `from` is
/// where it starts, in its own work coordinates.
void widen_by_arc(const MoveRow& row, const Axes& from, std::uint32_t diameters, Axes& low,
                  Axes& high) {
  const PlaneAxes plane = plane_axes(row.state->plane);
  const auto a = static_cast<std::size_t>(plane.a), b = static_cast<std::size_t>(plane.b);
  const auto share = [&](std::size_t axis) { return (diameters >> axis & 1) != 0 ? 0.5 : 1.0; };
  const double ca = row.centre[a], cb = row.centre[b];
  const auto part = [&](const Axes& p) {
    return std::array{(p[a] - ca) * share(a), (p[b] - cb) * share(b)};
  };
  const auto first = part(from), last = part(row.point);
  const double start = std::hypot(first[0], first[1]), end = std::hypot(last[0], last[1]);
  const double angle = std::atan2(first[1], first[0]);
  double turn = std::atan2(last[1], last[0]) - angle;
  if (row.kind == MoveKind::Cw)
    turn = turn > -1e-9 ? turn - 2 * kPi : turn;
  else
    turn = turn < 1e-9 ? turn + 2 * kPi : turn;
  for (int quarter = -6; quarter <= 6; ++quarter) {
    const double t = quarter * kPi / 2, done = (t - angle) / turn;
    const bool passed = done >= 0 && done <= 1;
    if (!passed) continue;
    const double radius = start + (end - start) * done;
    const double pa = ca + radius * std::cos(t) / share(a),
                 pb = cb + radius * std::sin(t) / share(b);
    low[a] = std::min(low[a], pa), high[a] = std::max(high[a], pa);
    low[b] = std::min(low[b], pb), high[b] = std::max(high[b], pb);
  }
}

}  // namespace

Moves::Bounds Moves::bounds(InterruptCheck* interrupt) const {
  Bounds bounds;
  bounds.low.fill(kNone);
  bounds.high.fill(kNone);
  Axes low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  Axes base = start_;  // where the row starts, without a radius offset
  walk(interrupt, [&](std::size_t, const MoveRow& row) {
    const Axes& offset = offsets_[row.state->offset];
    for (int i = 0; i < kAxes; ++i) {
      low[i] = std::min(low[i], row.point[i]);
      high[i] = std::max(high[i], row.point[i]);
    }
    if (row.kind == MoveKind::Cw || row.kind == MoveKind::Ccw) {
      Axes from = base;
      for (std::size_t i = 0; i < from.size(); ++i) from[i] -= offset[i];
      widen_by_arc(row, from, diameters_, low, high);
    }
    for (std::size_t i = 0; i < base.size(); ++i) base[i] = row.point[i] + offset[i];
  });
  for (int i = 0; i < kAxes; ++i)
    if (rows_ > 0 && (used_ >> i & 1) != 0) bounds.low[i] = low[i], bounds.high[i] = high[i];
  return bounds;
}

/// A column that stands in the chunks: the programmed point.
bool Moves::plain_column(std::string_view name, double* out, InterruptCheck* interrupt) const {
  const int axis = name.size() == 1 ? axis_of(name[0]) : -1;
  if (axis < 0) return false;
  if (axis >= 3) {
    each_row(interrupt, [&](std::size_t i) { out[i] = point(i)[static_cast<std::size_t>(axis)]; });
    return true;
  }
  for (std::size_t done = 0; done < rows_; done += Chunk::kRows) {
    if (interrupt != nullptr && interrupt->requested(sizeof(Chunk))) break;
    const Chunk& chunk = chunks_[done / Chunk::kRows];
    const double* from = axis == 0 ? chunk.x : axis == 1 ? chunk.y : chunk.z;
    std::copy_n(from, std::min(Chunk::kRows, rows_ - done), out + done);
  }
  return true;
}

namespace {

/// A column that follows from the rows.
struct Derived {
  double (*value)(const MoveRow& row, std::size_t axis) = nullptr;
  std::size_t axis = 0;
  double* out = nullptr;
};

Derived derived(std::string_view name) {
  const int axis = name.size() == 2 ? axis_of(name[1]) : -1;
  const auto place = static_cast<std::size_t>(std::max(axis, 0));
  if (axis >= 0 && name[0] == 'm')
    return {[](const MoveRow& row, std::size_t i) { return row.machine[i]; }, place};
  if (axis >= 0 && axis < 3 && name[0] == 'c')
    return {[](const MoveRow& row, std::size_t i) { return row.centre[i]; }, place};
  if (name == "feed") return {[](const MoveRow& row, std::size_t) { return row.feed; }};
  if (name == "spindle") return {[](const MoveRow& row, std::size_t) { return row.spindle; }};
  if (name == "length") return {[](const MoveRow& row, std::size_t) { return row.length; }};
  if (name == "time") return {[](const MoveRow& row, std::size_t) { return row.time; }};
  return {};
}

}  // namespace

bool Moves::columns(const std::vector<std::string>& names, const std::vector<double*>& out,
                    InterruptCheck* interrupt) const {
  std::vector<Derived> follow;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (plain_column(names[i], out[i], interrupt)) continue;
    follow.push_back(derived(names[i]));
    if (follow.back().value == nullptr) return false;
    follow.back().out = out[i];
  }
  if (follow.empty()) return true;
  walk(interrupt, [&](std::size_t i, const MoveRow& row) {
    for (const Derived& column : follow) column.out[i] = column.value(row, column.axis);
  });
  return true;
}

template <class Whole>
bool Moves::column(std::string_view name, Whole* out, InterruptCheck* interrupt) const {
  const auto fill = [&](auto value) {
    each_row(interrupt, [&](std::size_t i) {
      out[i] = static_cast<Whole>(value(chunks_[i / Chunk::kRows], i % Chunk::kRows, i));
    });
    return true;
  };
  const auto state = [&](auto field) {
    return fill(
        [&](const Chunk& c, std::size_t p, std::size_t) { return field(states_[c.state[p]]); });
  };
  if (name == "move") return fill([](const Chunk&, std::size_t, std::size_t i) { return i; });
  if (name == "step")
    return fill([](const Chunk& c, std::size_t p, std::size_t) { return c.step[p]; });
  if (name == "kind")
    return fill([](const Chunk& c, std::size_t p, std::size_t) { return c.kind[p]; });
  if (name == "plane") return state([](const MoveState& s) { return s.plane; });
  if (name == "tool") return state([](const MoveState& s) { return s.tool; });
  if (name == "h") return state([](const MoveState& s) { return s.h; });
  if (name == "d") return state([](const MoveState& s) { return s.d; });
  if (name == "feed_mode") return state([](const MoveState& s) { return s.feed_mode; });
  if (name == "skip") {
    std::fill_n(out, rows_, static_cast<Whole>(SkipMove::No));
    for (std::size_t i = 0; i < skips_.size(); ++i)
      out[skips_[i].row] = static_cast<Whole>(skips_[i].how);
    return true;
  }
  return false;
}

template bool Moves::column(std::string_view name, std::int32_t* out, InterruptCheck*) const;
template bool Moves::column(std::string_view name, std::int64_t* out, InterruptCheck*) const;

std::size_t Moves::bytes() const {
  std::size_t sum = chunks_.size() * sizeof(Chunk) + states_.bytes() + offsets_.bytes() +
                    arcs_.bytes() + vectors_.bytes() + seconds_.bytes() + skips_.bytes();
  for (const Extra& extra : extras_) sum += extra.values.bytes();
  return sum;
}

}  // namespace cncsub
