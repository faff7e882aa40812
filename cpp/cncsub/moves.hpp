// The moves of a run as columns: one row per motion. What is constant over many rows stands in a
// table of states, what only some rows have (arc centres, radius offsets, dwells) in lists by row,
// and what follows from these is computed when it is asked for.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/column.hpp"
#include "cncsub/patience.hpp"

namespace cncsub {

enum class MoveKind : std::uint8_t { Rapid, Feed, Cw, Ccw, Thread, Dwell };
std::string_view to_string(MoveKind kind);

/// Whether a move was one of G31, and whether its signal came.
enum class SkipMove : std::uint8_t { No, Touched, Missed };
std::string_view to_string(SkipMove skip);

constexpr int kAxes = 9;
constexpr std::string_view kAxisNames = "XYZABCUVW";
using Axes = std::array<double, kAxes>;

enum class FeedMode : std::uint8_t { PerMinute, PerRevolution, InverseTime };

/// What holds for a row besides its end point.
struct MoveState {
  double feed = 0;           // mm/min, mm/rev or 1/min
  double spindle = 0;        // r/min, or m/min where `surface`
  double max_spindle = 0;    // 0 = no limit
  std::uint32_t offset = 0;  // into the table of offsets
  std::int32_t tool = 0;
  std::int32_t h = 0;
  std::int32_t d = 0;
  std::uint8_t plane = 17;
  FeedMode feed_mode = FeedMode::PerMinute;
  bool surface = false;
  double degree = 1;  // mm that a degree counts in a path: F is degrees a minute where it is inches

  bool operator==(const MoveState&) const = default;
};

/// One row with everything that follows from it.
struct MoveRow {
  std::uint32_t step = 0;
  MoveKind kind = MoveKind::Rapid;
  Axes point{};                    // programmed end, work coordinates, diameter on a diameter axis
  Axes machine{};                  // machine position of the tool
  std::array<double, 3> centre{};  // NaN where none
  const MoveState* state = nullptr;
  double feed = 0;     // mm/min, mm/rev, 1/min; degrees where rotary axes alone move
  double spindle = 0;  // r/min at the end of the move
  double length = 0;   // mm
  double time = 0;     // s
  SkipMove skip = SkipMove::No;
};

class Moves {
 public:
  /// An empty table for the moves that follow the last one of this.
  Moves next_part() const;

  std::size_t size() const { return rows_; }
  MoveRow row(std::size_t index) const;
  /// The axes that moves named, X Y Z first.
  std::string axes() const;
  // What goes over all moves asks `patience` now and then; given up, it leaves the rest undone.
  double length(Patience* patience = nullptr) const;
  double time(Patience* patience = nullptr) const;
  struct Bounds {
    Axes low, high;  // work coordinates; NaN on an axis no move named
  };
  Bounds bounds(Patience* patience = nullptr) const;
  /// Writes whole columns, each to its place, in one pass over the moves: x y z a b c u v w, mx my
  /// mz ma ..., cx cy cz, feed, spindle, length, time. False where a name is another one.
  bool columns(const std::vector<std::string>& names, const std::vector<double*>& out,
               Patience* patience = nullptr) const;
  /// move, step, kind, plane, tool, h, d, feed_mode, skip.
  template <class Whole>
  bool column(std::string_view name, Whole* out, Patience* patience = nullptr) const;
  std::size_t bytes() const;

  // What the motion engine writes.

  /// The machine's facts that lengths and times need, before the first row: where the tool is,
  /// rapid rates, diameter axes.
  void begin(const Axes& machine, const Axes& rapid, std::uint32_t diameters);
  std::uint32_t intern(MoveState state, const Axes& offset);
  /// The axes that moves named; bit 0 is X.
  void mark(std::uint32_t axes) { used_ |= axes; }
  /// The same for axes beyond X, Y and Z, which get a column.
  void use(std::uint32_t axes);
  std::uint32_t used() const { return used_; }

  /// A row with nothing but X, Y and Z, which must be fast.
  void push(std::uint32_t step, MoveKind kind, const Axes& point, std::uint32_t state) {
    if (rows_ >= room_.end) grow();
    const std::size_t place = rows_ % Chunk::kRows;
    Chunk& chunk = *room_.chunk;
    chunk.step[place] = step;
    chunk.kind[place] = kind;
    chunk.state[place] = state;
    chunk.x[place] = point[0];
    chunk.y[place] = point[1];
    chunk.z[place] = point[2];
    ++rows_;
    if (!extras_.empty()) push_extras(point);
  }
  /// Facts about the row that was just pushed.
  void arc(std::array<double, 3> centre, double in_plane);
  void vector(const std::array<double, 3>& vector);
  void seconds(double time);
  void skip(SkipMove how);
  /// Forgets the rows from `rows` on.
  void truncate(std::size_t rows);

 private:
  struct Chunk {
#ifdef CNCSUB_FUZZ  // as in column.hpp
    static constexpr std::size_t kRows = 64;
#else
    static constexpr std::size_t kRows = 1 << 12;
#endif
    double x[kRows], y[kRows], z[kRows];
    std::uint32_t step[kRows], state[kRows];
    MoveKind kind[kRows];
  };
  struct Extra {
    int axis = 0;
    std::size_t first = 0;  // the first row with this axis
    Column<double> values;
  };
  struct Arc {
    std::uint32_t row;
    std::array<double, 3> centre;
    double in_plane;  // its way, without that of other axes
  };
  struct Vector {
    std::uint32_t row;
    std::array<double, 3> vector;
  };
  struct Seconds {
    std::uint32_t row;
    double time;
  };
  struct Skip {
    std::uint32_t row;
    SkipMove how;
  };
  struct Walk;
  /// Where rows may be written: the last chunk, and the first row that is not in it. A copy of the
  /// table has no room, because the chunk is not its own.
  struct Room {
    Chunk* chunk = nullptr;
    std::size_t end = 0;

    Room() = default;
    Room(const Room&) {}
    Room& operator=(const Room& other) {
      if (this != &other) *this = Room();
      return *this;
    }
    Room(Room&&) noexcept = default;
    Room& operator=(Room&&) noexcept = default;
    ~Room() = default;
  };

  void grow();
  bool plain_column(std::string_view name, double* out, Patience* patience) const;
  template <class Use>
  void each_row(Patience* patience, Use&& use) const;
  void push_extras(const Axes& point);
  Axes point(std::size_t row) const;
  template <class Use>
  void walk(Patience* patience, Use&& use) const;

  Chunks<Chunk> chunks_;
  Room room_;
  std::size_t rows_ = 0;
  std::vector<Extra> extras_;
  Column<MoveState> states_;
  Column<Axes> offsets_;
  Column<Arc> arcs_;
  Column<Vector> vectors_;
  Column<Seconds> seconds_;
  Column<Skip> skips_;
  std::uint32_t used_ = 0;
  Axes start_{};  // machine position before the first row
  Axes rapid_{};
  std::uint32_t diameters_ = 0;
};

/// The two axes of a plane, and the one across it. G18 is (Z, X).
struct PlaneAxes {
  int a, b, across;
};
inline PlaneAxes plane_axes(int plane) {
  if (plane == 18) return {2, 0, 1};
  if (plane == 19) return {1, 2, 0};
  return {0, 1, 2};
}

/// A move of the tool: from one machine position to another.
struct MoveWay {
  MoveKind kind = MoveKind::Rapid;
  const MoveState& state;
  const Axes &from, &to;
  double path = 0;   // mm; of an arc what lies in its plane
  double zero = 0;   // where X is 0, to which a diameter counts: a machine coordinate
  double dwell = 0;  // s
};
/// The speed that a feed per revolution counts on: a spindle that was never told to turn counts as
/// one that turns once a minute, so that the cut ends, late. [policy]
inline double turning(double spindle) { return spindle > 0 ? spindle : 1; }
/// How long a move takes, in seconds: told with each move, and summed up by the run.
double seconds_of(const MoveWay& way, const Axes& rapid, std::uint32_t diameters);
/// r/min at this diameter.
double spindle_at(const MoveState& state, double diameter);
/// Millimetres between two points, a diameter axis counting half; rotary axes do not count.
double length_of(const Axes& from, const Axes& to, std::uint32_t diameters);
/// The length of an arc of which the way in its plane is known, with that of the other axes.
double arc_length(double in_plane, int plane, const Axes& from, const Axes& to,
                  std::uint32_t diameters);
double rapid_time(const Axes& from, const Axes& to, const Axes& rapid, std::uint32_t diameters);
/// The length of an arc whose radius grows evenly from the first to the last over an angle: of one
/// that misses its end inside the tolerance, which the tool reaches on a spiral. [ALM 020][M7
/// p.194]
inline double spiral_length(double first, double last, double turn) {
  const double growth = last - first, mean = (first + last) / 2 * turn;
  if (growth == 0) return std::fabs(mean);
  if (std::fabs(growth) <= 1e-5 * (first + last)) return std::sqrt(mean * mean + growth * growth);
  const double k = std::fabs(growth / turn);  // of the radius, for each radian
  const auto upto = [k](double radius) {
    return radius * std::sqrt(radius * radius + k * k) + k * k * std::asinh(radius / k);
  };
  return std::fabs(turn / (2 * growth) * (upto(last) - upto(first)));
}

}  // namespace cncsub
