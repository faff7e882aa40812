// The moves as columns: each column is written for some rows at a time, by the thread that has
// them.
#include <algorithm>
#include <limits>
#include <numeric>

#include "cncsub/trace/move_walk.hpp"
#include "cncsub/trace/parts.hpp"

namespace cncsub {

namespace {

int axis_of(char name) {
  const auto found = kAxisNames.find(static_cast<char>(name >= 'a' ? name - 'a' + 'A' : name));
  return found == std::string_view::npos ? -1 : static_cast<int>(found);
}

/// A column that follows from a row and the one before it.
struct Derived {
  double MoveRow::* value = nullptr;
  MoveBegin::Point MoveBegin::* point = nullptr;  // or a coordinate of this one
  std::size_t axis = 0;
  bool machine = false;  // or one of the tool, in machine coordinates
  bool centre = false;   // the point is the centre of an arc
  double* out = nullptr;

  bool known() const { return value != nullptr || point != nullptr || machine; }
  double of(const MoveRow& row, const MoveBegin& begin) const {
    if (value != nullptr) return row.*value;
    if (machine) return row.machine[axis];
    if (centre) return turned_by(begin.turned, begin.centre)[axis];
    return (begin.*point)[axis];
  }
};

Derived derived(std::string_view name) {
  if (name == "feed") return {&MoveRow::feed};
  if (name == "length") return {&MoveRow::length};
  if (name == "time") return {&MoveRow::time};
  const int axis = name.empty() ? -1 : axis_of(name.back());
  if (axis < 0 || axis >= 3) return {};
  const auto of = static_cast<std::size_t>(axis);
  name.remove_suffix(1);
  if (name == "s") return {nullptr, &MoveBegin::point, of};
  if (name == "ms") return {nullptr, &MoveBegin::machine, of};
  if (name == "mc") return {nullptr, &MoveBegin::centre, of, false, true};
  if (name == "m") return {nullptr, nullptr, of, true};
  return {};
}

/// Return whether the feed of every row is that of its state, whatever turns: a degree is one unit.
bool even_degrees(const Column<MoveState>& states) {
  bool even = true;
  states.for_each_run(0, states.size(), [&](const MoveState* some, std::size_t count) {
    even =
        even && std::all_of(some, some + count, [](const MoveState& s) { return s.degree == 1; });
  });
  return even;
}

}  // namespace

/// Rows [first, last) of the table, whose columns are written to their places.
class Moves::Part {
 public:
  Part(const Moves& of, std::size_t first, std::size_t last)
      : of_(of), first_(first), last_(last) {}

  /// Write a column for which no row needs the one before it. Return false where the name is that
  /// of another column.
  bool plain_column(std::string_view name, double* out) const;
  /// Write a column of whole numbers. Return false where the name is that of another column.
  template <class Whole>
  bool whole_column(std::string_view name, Whole* out) const;
  /// Write what holds for many rows: it is looked up where it changes.
  template <class Out, class Value>
  void by_state(Out* out, Value&& value) const;

 private:
  /// Call `use(chunk, place, index)` for these rows.
  template <class Use>
  void each_row(Use&& use) const;
  /// Write the programmed point. An axis without a column stands where it stood, in any
  /// coordinates.
  void point_column(int axis, double* out) const;
  void machine_column(int axis, double* out) const;
  void centre_column(std::size_t axis, double* out) const;
  void spindle_column(double* out) const;
  /// Write whether a radius offset stands at the end of the move, or at its beginning.
  template <class Whole>
  void compensated_column(Whole* out) const;

  const Moves& of_;
  std::size_t first_, last_;
};

template <class Use>
void Moves::Part::each_row(Use&& use) const {
  for (std::size_t i = first_; i < last_;) {
    const Chunk& chunk = of_.chunks_[i / Chunk::kRows];
    const std::size_t end = std::min(last_, (i / Chunk::kRows + 1) * Chunk::kRows);
    for (; i < end; ++i) use(chunk, i % Chunk::kRows, i);
  }
}

template <class Out, class Value>
void Moves::Part::by_state(Out* out, Value&& value) const {
  if (first_ == last_) return;
  std::uint32_t known = of_.chunks_[first_ / Chunk::kRows].state(first_ % Chunk::kRows);
  Out held = static_cast<Out>(value(of_.states_[known]));
  each_row([&](const Chunk& chunk, std::size_t place, std::size_t i) {
    if (chunk.state(place) != known) {
      known = chunk.state(place);
      held = static_cast<Out>(value(of_.states_[known]));
    }
    out[i] = held;
  });
}

void Moves::Part::point_column(int axis, double* out) const {
  const auto place = static_cast<std::size_t>(axis);
  if (axis >= 3) {
    by_state(out,
             [&](const MoveState& s) { return of_.start_[place] - of_.offsets_[s.offset][place]; });
    for (const Extra& extra : of_.extras_)
      for (std::size_t i = std::max(first_, extra.first); extra.axis == axis && i < last_; ++i)
        out[i] = extra.values[i - extra.first];
    return;
  }
  for (std::size_t i = first_; i < last_;) {
    const Chunk& chunk = of_.chunks_[i / Chunk::kRows];
    const std::size_t at = i % Chunk::kRows, count = std::min(Chunk::kRows - at, last_ - i);
    const double* const from = axis == 0 ? chunk.x : axis == 1 ? chunk.y : chunk.z;
    std::copy_n(from + at, count, out + i);
    i += count;
  }
}

void Moves::Part::machine_column(int axis, double* out) const {
  const auto place = static_cast<std::size_t>(axis);
  point_column(axis, out);
  std::uint32_t known = std::numeric_limits<std::uint32_t>::max();
  double offset = 0;
  each_row([&](const Chunk& chunk, std::size_t at, std::size_t i) {
    if (chunk.state(at) != known) {
      known = chunk.state(at);
      offset = of_.offsets_[of_.states_[known].offset][place];
    }
    out[i] += offset;
  });
  if (axis >= 3) return;
  for (std::size_t i = find_row(of_.vectors_, first_);
       i < of_.vectors_.size() && of_.vectors_[i].row < last_; ++i)
    out[of_.vectors_[i].row] += of_.vectors_[i].vector[place];
}

void Moves::Part::centre_column(std::size_t axis, double* out) const {
  std::fill(out + first_, out + last_, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = find_row(of_.arcs_, first_);
       i < of_.arcs_.size() && of_.arcs_[i].row < last_; ++i)
    out[of_.arcs_[i].row] = of_.arcs_[i].centre[axis];
}

void Moves::Part::spindle_column(double* out) const {
  if ((of_.diameters_ & 1) == 0) return by_state(out, [](const MoveState& s) { return s.spindle; });
  each_row([&](const Chunk& chunk, std::size_t place, std::size_t i) {
    out[i] = spindle_at(of_.states_[chunk.state(place)], chunk.x[place]);
  });
}

template <class Whole>
void Moves::Part::compensated_column(Whole* out) const {
  std::fill(out + first_, out + last_, Whole{0});
  for (std::size_t i = find_row(of_.vectors_, first_ == 0 ? 0 : first_ - 1);
       i < of_.vectors_.size() && of_.vectors_[i].row < last_; ++i) {
    const std::size_t row = of_.vectors_[i].row;
    if (row >= first_) out[row] = 1;
    if (row + 1 < last_) out[row + 1] = 1;
  }
}

bool Moves::Part::plain_column(std::string_view name, double* out) const {
  const int axis = name.empty() || name.size() > 2 ? -1 : axis_of(name.back());
  if (name == "spindle")
    spindle_column(out);
  else if (axis >= 0 && name.size() == 1)
    point_column(axis, out);
  else if (axis >= 0 && name[0] == 'm' && (axis > 1 || !of_.turned_))
    machine_column(axis, out);
  else if (axis >= 0 && axis < 3 && name[0] == 'c')
    centre_column(static_cast<std::size_t>(axis), out);
  else
    return false;
  return true;
}

template <class Whole>
bool Moves::Part::whole_column(std::string_view name, Whole* out) const {
  const auto state = [&](auto value) {
    by_state(out, value);
    return true;
  };
  const auto row = [&](auto value) {
    each_row([&](const Chunk& chunk, std::size_t place, std::size_t i) {
      out[i] = static_cast<Whole>(value(chunk, place));
    });
    return true;
  };
  if (name == "step") return row([](const Chunk& c, std::size_t p) { return c.step[p]; });
  if (name == "kind") return row([](const Chunk& c, std::size_t p) { return c.kind(p); });
  if (name == "plane") return state([](const MoveState& s) { return s.plane; });
  if (name == "tool") return state([](const MoveState& s) { return s.tool; });
  if (name == "h") return state([](const MoveState& s) { return s.h; });
  if (name == "d") return state([](const MoveState& s) { return s.d; });
  if (name == "feed_mode") return state([](const MoveState& s) { return s.feed_mode; });
  if (name == "cycle") return state([](const MoveState& s) { return s.cycle; });
  if (name == "compensated") {
    compensated_column(out);
    return true;
  }
  if (name == "move") {
    std::iota(out + first_, out + last_, static_cast<Whole>(first_));
    return true;
  }
  if (name != "skip") return false;
  std::fill(out + first_, out + last_, static_cast<Whole>(SkipMove::No));
  for (std::size_t i = find_row(of_.skips_, first_);
       i < of_.skips_.size() && of_.skips_[i].row < last_; ++i)
    out[of_.skips_[i].row] = static_cast<Whole>(of_.skips_[i].how);
  return true;
}

bool Moves::columns(const std::vector<std::string>& names, const std::vector<double*>& out,
                    InterruptCheck* interrupt) const {
  const bool even = even_degrees(states_);
  std::vector<Derived> follow;
  double* feed = nullptr;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (Part(*this, 0, 0).plain_column(names[i], out[i])) continue;
    if (even && names[i] == "feed") {
      feed = out[i];
      continue;
    }
    follow.push_back(derived(names[i]));
    if (!follow.back().known()) return false;
    follow.back().out = out[i];
  }
  in_parts(rows_, interrupt, [&](std::size_t first, std::size_t last) {
    const Part part(*this, first, last);
    for (std::size_t i = 0; i < names.size(); ++i) part.plain_column(names[i], out[i]);
    if (feed != nullptr) part.by_state(feed, [](const MoveState& s) { return s.feed; });
    if (follow.empty()) return;
    MoveReader(*this).each(first, last,
                           [&](std::size_t i, const MoveRow& row, const MoveBegin& begin) {
                             for (const Derived& column : follow)
                               column.out[i] = column.of(row, begin);
                           });
  });
  return true;
}

template <class Whole>
bool Moves::column(std::string_view name, Whole* out, InterruptCheck* interrupt) const {
  if (!Part(*this, 0, 0).whole_column(name, out)) return false;
  in_parts(rows_, interrupt, [&](std::size_t first, std::size_t last) {
    Part(*this, first, last).whole_column(name, out);
  });
  return true;
}

template bool Moves::column(std::string_view name, std::int32_t* out, InterruptCheck*) const;
template bool Moves::column(std::string_view name, std::int64_t* out, InterruptCheck*) const;

}  // namespace cncsub
