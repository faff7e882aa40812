// A walk along the moves row by row: what the table and its columns have in common.
#pragma once

#include <limits>

#include "cncsub/trace/moves.hpp"

namespace cncsub {

/// Return the first entry of a list by row that belongs to this row or one after it.
template <class List>
std::size_t find_row(const List& list, std::size_t row) {
  std::size_t low = 0, high = list.size();
  while (low < high) {
    const std::size_t middle = (low + high) / 2;
    (list[middle].row < row ? low : high) = list[middle].row < row ? middle + 1 : middle;
  }
  return low;
}

/// A walk along a list by row, which most rows are not in.
template <class Entry>
class Along {
 public:
  explicit Along(const Column<Entry>& list) : list_(list) {}
  void seek(std::size_t row) {
    next_ = find_row(list_, row);
    look();
  }
  /// Return the entry of this row, if there is one. Rows are asked for in order.
  const Entry* at(std::size_t row) {
    if (row != row_) return nullptr;
    const Entry* const entry = &list_[next_++];
    look();
    return entry;
  }

 private:
  void look() {
    row_ = next_ < list_.size() ? list_[next_].row : std::numeric_limits<std::size_t>::max();
  }

  const Column<Entry>& list_;
  std::size_t next_ = 0;
  std::size_t row_ = 0;  // of the next entry
};

/// A walk along rows in order, with everything that follows from them.
class Moves::Walk {
 public:
  explicit Walk(const Moves& moves)
      : moves_(moves),
        arcs_(moves.arcs_),
        vectors_(moves.vectors_),
        seconds_(moves.seconds_),
        leaps_(moves.leaps_) {}

  void seek(std::size_t row) {
    from_ = moves_.start_;
    programmed_ = {from_[0], from_[1], from_[2]};
    vector_ = false;
    if (row > 0) {
      stand_at(row - 1);
      next(row - 1);
    }
    stand_at(row);
  }

  // Widen a box by rows [first, last): by the ends of X, Y and Z, by other axes, by arcs between
  // their ends, as move_bounds.cpp does.
  void widen_by_ends(std::size_t first, std::size_t last, Bounds& box) const;
  void widen_by_extras(std::size_t first, std::size_t last, Bounds& box) const;
  void widen_by_arcs(std::size_t first, std::size_t last, Bounds& box);

  /// Return the next row. Without `timed` it lacks times and speeds, which take long to compute.
  template <bool timed = true>
  MoveRow next(std::size_t index) {
    leap(index);
    const std::size_t place = index % Chunk::kRows;
    if (place == 0 || chunk_ == nullptr) chunk_ = &moves_.chunks_[index / Chunk::kRows];
    if (state_ == nullptr || chunk_->state(place) != state_index_) take_state(chunk_->state(place));
    MoveRow row;
    row.step = chunk_->step[place];
    row.kind = chunk_->kind(place);
    row.state = state_;
    row.point = still_;
    row.point[0] = chunk_->x[place];
    row.point[1] = chunk_->y[place];
    row.point[2] = chunk_->z[place];
    for (const Extra& extra : moves_.extras_)
      if (index >= extra.first) row.point[extra.axis] = extra.values[index - extra.first];
    for (int i = 0; i < kAxes; ++i) row.machine[i] = row.point[i] + offset_[i];
    programmed_ =
        turned_by(state_->turned, MoveBegin::Point{row.machine[0], row.machine[1], row.machine[2]});
    const Vector* const vector = vectors_.at(index);
    vector_ = vector != nullptr;
    if (vector_)
      for (int i = 0; i < 3; ++i) row.machine[i] += vector->vector[i];
    if (state_->turned != 0) row.machine = turned_by(state_->turned, row.machine);
    const Seconds* const seconds = seconds_.at(index);
    follow<timed>(row, arcs_.at(index), seconds == nullptr ? 0 : seconds->time);
    from_ = row.machine;
    return row;
  }

  template <bool timed = true>
  MoveRow next(std::size_t index, MoveBegin& begin) {
    leap(index);
    const MoveBegin::Point before = programmed_;
    begin.machine = {from_[0], from_[1], from_[2]};
    const bool vector_before = vector_;
    const MoveRow row = next<timed>(index);
    const MoveBegin::Point programmed = turned_by(-state_->turned, before);
    begin.turned = state_->turned;
    begin.in_plane = in_plane_;
    begin.cycle = state_->cycle;
    begin.compensated = vector_before || vector_;
    const MoveBegin::Point none{};
    const MoveBegin::Point& tip = state_->tip == 0 ? none : moves_.tips_[state_->tip - 1];
    for (std::size_t i = 0; i < 3; ++i) {
      begin.offset[i] = offset_[i];
      begin.point[i] = programmed[i] - offset_[i];
      begin.centre[i] = row.centre[i] + offset_[i] + tip[i];
    }
    return row;
  }

 private:
  void stand_at(std::size_t row) {
    arcs_.seek(row);
    vectors_.seek(row);
    seconds_.seek(row);
    leaps_.seek(row);
    chunk_ = nullptr;
  }

  /// Stand where the row begins, if that is elsewhere than where the one before ended.
  void leap(std::size_t row) {
    const Leap* const to = leaps_.at(row);
    if (to == nullptr) return;
    from_ = to->from;
    programmed_ = {from_[0], from_[1], from_[2]};
    vector_ = false;
  }

  void take_state(std::uint32_t index) {
    state_index_ = index;
    state_ = &moves_.states_[index];
    offset_ = moves_.offsets_[state_->offset];
    still_ = moves_.start_;
    for (std::size_t i = 3; i < still_.size(); ++i) still_[i] -= offset_[i];
  }

  /// Compute what follows from where the move begins.
  template <bool timed>
  void follow(MoveRow& row, const Arc* arc, double dwell) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    row.centre = {kNone, kNone, kNone};
    double path = row.length = length_of(from_, row.machine, moves_.diameters_);
    if (arc != nullptr) {
      row.centre = arc->centre;
      path = arc->in_plane;
      row.length = arc_length(path, arc_axes(*state_), turned_by(-state_->turned, from_),
                              turned_by(-state_->turned, row.machine), moves_.diameters_);
    }
    in_plane_ = path;
    if constexpr (!timed) return;
    const bool lathe = (moves_.diameters_ & 1) != 0;
    row.spindle = lathe ? spindle_at(*state_, row.point[0]) : state_->spindle;
    row.feed = state_->feed / (row.length < kNoLength && turns(row) ? state_->degree : 1);
    row.time = seconds_of({row.kind, *state_, from_, row.machine, path, offset_[0], dwell},
                          moves_.rapid_, moves_.diameters_);
  }
  bool turns(const MoveRow& row) const {
    return row.machine[3] != from_[3] || row.machine[4] != from_[4] || row.machine[5] != from_[5];
  }

  const Moves& moves_;
  Along<Arc> arcs_;
  Along<Vector> vectors_;
  Along<Seconds> seconds_;
  Along<Leap> leaps_;
  Axes from_{};                    // machine position before the row
  MoveBegin::Point programmed_{};  // the same without a radius offset
  double in_plane_ = 0;            // of the row that was visited last
  bool vector_ = false;            // a radius offset holds at its end
  const Chunk* chunk_ = nullptr;
  std::uint32_t state_index_ = 0;
  const MoveState* state_ = nullptr;
  Axes offset_{};  // the offset of the state
  Axes still_{};   // where an axis without a column stands, in any coordinates
};

/// The moves with where they begin, for what is made of them.
class MoveReader {
 public:
  explicit MoveReader(const Moves& moves) : moves_(moves) {}

  /// Call `use(index, row, begin)` for rows [first, last).
  template <bool timed = true, class Use>
  void each(std::size_t first, std::size_t last, Use&& use) const {
    Moves::Walk walk(moves_);
    walk.seek(first);
    MoveBegin begin;
    for (std::size_t i = first; i < last; ++i) {
      const MoveRow row = walk.next<timed>(i, begin);
      use(i, row, begin);
    }
  }
  MoveBegin begin_of(std::size_t index) const {
    MoveBegin found;
    each(index, index + 1,
         [&](std::size_t, const MoveRow&, const MoveBegin& begin) { found = begin; });
    return found;
  }
  /// Return the diameter axes as bits: bit 0 is X.
  std::uint32_t diameters() const { return moves_.diameters_; }

 private:
  const Moves& moves_;
};

}  // namespace cncsub
