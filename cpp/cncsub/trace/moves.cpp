#include "cncsub/trace/moves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cncsub/trace/move_walk.hpp"

namespace cncsub {
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

std::uint32_t Moves::find_state(const MoveState& state, const Axes& offset,
                                const std::array<double, 3>& tip) {
  last_reported_ ^= 1;
  ReportedOffset& reported = reported_[last_reported_];
  if (same_bits(reported.state.feed, state.feed) && reported.is(state, offset, tip))
    return reported.number;
  reported.state = state;
  reported.offset = offset;
  reported.tip = tip;
  MoveState row = state;
  if (offsets_.empty() || offsets_.back() != offset) offsets_.push(offset);
  if (tip != std::array<double, 3>{}) {
    if (tips_.empty() || tips_.back() != tip) tips_.push(tip);
    row.tip = static_cast<std::uint32_t>(tips_.size());
  }
  row.offset = static_cast<std::uint32_t>(offsets_.size() - 1);
  turned_ = turned_ || row.turned != 0;
  // More states than a row can number fill more memory than there is: further ones count as the
  // last.
  const bool full = states_.size() >> (32 - Chunk::kKindBits) != 0;
  if (states_.empty() || (!full && !(states_.back() == row))) states_.push(row);
  return reported.number = static_cast<std::uint32_t>(states_.size() - 1);
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

void Moves::arc(const std::array<double, 3>& centre, double in_plane) {
  arcs_.next() = {
      static_cast<std::uint32_t>(rows_ - 1), {centre[0], centre[1], centre[2]}, in_plane};
}

void Moves::vector(const std::array<double, 3>& vector) {
  vectors_.next() = {static_cast<std::uint32_t>(rows_ - 1), {vector[0], vector[1], vector[2]}};
}

void Moves::seconds(double time) { seconds_.push({static_cast<std::uint32_t>(rows_ - 1), time}); }

void Moves::skip(SkipMove how) { skips_.push({static_cast<std::uint32_t>(rows_ - 1), how}); }

void Moves::begin_next_at(const Axes& machine) {
  const auto row = static_cast<std::uint32_t>(rows_);
  leaps_.keep(find_row(leaps_, row));
  leaps_.push({row, machine});
}

void Moves::truncate(std::size_t rows) {
  if (rows >= rows_) return;
  arcs_.keep(find_row(arcs_, rows));
  vectors_.keep(find_row(vectors_, rows));
  seconds_.keep(find_row(seconds_, rows));
  skips_.keep(find_row(skips_, rows));
  leaps_.keep(find_row(leaps_, rows + 1));  // the next row still begins there
  for (Extra& extra : extras_) {
    extra.first = std::min(rows, extra.first);
    extra.values.keep(rows - extra.first);
  }
  rows_ = rows;
  chunks_.keep((rows + Chunk::kRows - 1) / Chunk::kRows);
  room_ = {};
}

void Moves::rewind(const Mark& mark) {
  truncate(mark.rows);
  leaps_.keep(std::min(leaps_.size(), mark.leaps));
  extras_.resize(std::min(extras_.size(), mark.extras));
  used_ = std::min(used_, mark.used);
}

MoveRow Moves::row(std::size_t index) const {
  Walk walk(*this);
  walk.seek(index);
  MoveRow row = walk.next(index);
  const std::size_t skip = find_row(skips_, index);
  if (skip < skips_.size() && skips_[skip].row == index) row.skip = skips_[skip].how;
  return row;
}

template <class Use>
void Moves::walk(InterruptCheck* interrupt, Use&& use) const {
  Walk walk(*this);
  walk.seek(0);
  for (std::size_t i = 0; i < rows_;) {
    for (const std::size_t end = std::min(rows_, i + Chunk::kRows); i < end; ++i)
      use(i, walk.next(i));
    if (interrupt != nullptr && interrupt->requested(sizeof(Chunk))) return;
  }
}

std::string Moves::axes() const {
  std::string names;
  for (int i = 0; i < kAxes; ++i)
    if ((used_ >> i & 1) != 0) names += kAxisNames[static_cast<std::size_t>(i)];
  return names;
}

double Moves::time(InterruptCheck* interrupt) const {
  double sum = 0;
  walk(interrupt, [&](std::size_t, const MoveRow& row) { sum += row.time; });
  return sum;
}

std::size_t Moves::bytes() const {
  std::size_t sum = chunks_.size() * sizeof(Chunk) + states_.bytes() + offsets_.bytes() +
                    tips_.bytes() + arcs_.bytes() + vectors_.bytes() + seconds_.bytes() +
                    skips_.bytes() + leaps_.bytes();
  for (const Extra& extra : extras_) sum += extra.values.bytes();
  return sum;
}

}  // namespace cncsub
