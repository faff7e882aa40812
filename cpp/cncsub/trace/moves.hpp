// The moves of a run as columns: one row per motion. What is constant over many rows stands in a
// table of states, what only some rows have (arc centres, radius offsets, dwells) in lists by row,
// and what follows from these is computed when it is asked for.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/text/interrupt_check.hpp"
#include "cncsub/trace/column.hpp"
#include "cncsub/trace/duration.hpp"

namespace cncsub {

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

/// The begin of a move, and what else leads from work to machine coordinates.
struct MoveBegin {
  using Point = std::array<double, 3>;

  Point point{};             // programmed, in the work coordinates of the move
  Point machine{};           // of the tool, machine coordinates
  double turned = 0;         // radians by which machine coordinates are rotated, last of all
  Point offset{};            // from work to machine coordinates, before the rotation
  Point centre{};            // of the tool's arc, likewise; NaN where none
  double in_plane = 0;       // of an arc: the length of the tool's path in its plane, mm
  bool cycle = false;        // a canned cycle makes the move
  bool compensated = false;  // a radius offset holds at its end, or here
};

class Moves {
 public:
  /// Return an empty table for the moves that follow the last one of this table.
  Moves next_part() const;

  std::size_t size() const { return rows_; }
  MoveRow row(std::size_t index) const;
  /// Return the axes that moves named, X Y Z first.
  std::string axes() const;
  // What goes over all moves asks `interrupt` now and then; interrupted, it leaves the rest undone.
  double length(InterruptCheck* interrupt = nullptr) const;
  double time(InterruptCheck* interrupt = nullptr) const;
  struct Bounds {
    Axes low, high;  // work coordinates; NaN on an axis no move named
  };
  Bounds bounds(InterruptCheck* interrupt = nullptr) const;
  /// Write whole columns, each to its place, in one pass over the moves: x y z a b c u v w, mx my
  /// mz ma ..., cx cy cz, feed, spindle, length, time, sx sy sz, msx msy msz, mcx mcy mcz. Return
  /// false where a name is another one. Many rows are shared out to threads.
  bool columns(const std::vector<std::string>& names, const std::vector<double*>& out,
               InterruptCheck* interrupt = nullptr) const;
  /// Write the column move, step, kind, plane, tool, h, d, feed_mode, skip, cycle or compensated.
  template <class Whole>
  bool column(std::string_view name, Whole* out, InterruptCheck* interrupt = nullptr) const;
  std::size_t bytes() const;

  // The functions by which the motion engine writes.

  /// Set what lengths and times need of the machine, before the first row: where the tool is, rapid
  /// rates, diameter axes.
  void begin(const Axes& machine, const Axes& rapid, std::uint32_t diameters);
  /// Return the number of a state. `tip` leads from the centre of a nose to the imaginary tip.
  std::uint32_t intern(const MoveState& state, const Axes& offset,
                       const std::array<double, 3>& tip = {}) {
    // The state is nearly always that of before, bit by bit.
    const ReportedOffset& last = reported_[last_reported_];
    return last.is(state, offset, tip) ? last.number : find_state(state, offset, tip);
  }
  /// Mark the axes that moves named; bit 0 is X.
  void mark(std::uint32_t axes) { used_ |= axes; }
  /// Mark axes beyond X, Y and Z too, which get a column.
  void use(std::uint32_t axes);
  std::uint32_t used() const { return used_; }

  /// Append a row with nothing but X, Y and Z. This must be fast.
  void push(std::uint32_t step, MoveKind kind, const Axes& point, std::uint32_t state) {
    if (rows_ >= room_.end) grow();
    const std::size_t place = rows_ % Chunk::kRows;
    Chunk& chunk = *room_.chunk;
    chunk.step[place] = step;
    chunk.how[place] = state << Chunk::kKindBits | static_cast<std::uint32_t>(kind);
    chunk.x[place] = point[0];
    chunk.y[place] = point[1];
    chunk.z[place] = point[2];
    ++rows_;
    if (!extras_.empty()) push_extras(point);
  }
  /// Add facts about the row that was just pushed.
  void arc(const std::array<double, 3>& centre, double in_plane);
  void vector(const std::array<double, 3>& vector);
  void seconds(double time);
  void skip(SkipMove how);
  /// Begin the next row elsewhere than where the last one has ended: machine coordinates.
  void begin_next_at(const Axes& machine);
  /// Forget the rows from `rows` on.
  void truncate(std::size_t rows);
  /// How much the table held when a run stood somewhere, to go back to.
  struct Mark {
    std::size_t rows = 0, extras = 0, leaps = 0;
    std::uint32_t used = 0;
  };
  Mark mark() const { return {rows_, extras_.size(), leaps_.size(), used_}; }
  void rewind(const Mark& mark);

 private:
  friend class MoveReader;

  struct Chunk {
#ifdef CNCSUB_FUZZ  // as in column.hpp
    static constexpr std::size_t kRows = 64;
#else
    static constexpr std::size_t kRows = 1 << 12;
#endif
    double x[kRows], y[kRows], z[kRows];
    std::uint32_t step[kRows], how[kRows];

    static constexpr std::uint32_t kKindBits = 3;  // of `how`, whose others number the state
    std::uint32_t state(std::size_t place) const { return how[place] >> kKindBits; }
    MoveKind kind(std::size_t place) const {
      return static_cast<MoveKind>(how[place] & ((1U << kKindBits) - 1));
    }
  };
  struct Extra {
    int axis = 0;
    std::size_t first = 0;  // the first row with this axis
    Column<double> values;
  };
  struct Arc {
    std::uint32_t row;
    std::array<double, 3> centre;
    double in_plane;  // the length of its path, without that of other axes
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
  struct Leap {
    std::uint32_t row;
    Axes from;  // where the row begins: machine coordinates
  };
  class Walk;
  class Part;
  /// The place where rows may be written: the last chunk, and the first row that is not in it. A
  /// copy of the table has no room, because the chunk is not its own.
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

  /// The values that a row was reported with, and the number of its state.
  struct ReportedOffset {
    MoveState state;
    Axes offset{};
    std::array<double, 3> tip{};
    std::uint32_t number = kNone;

    static constexpr std::uint32_t kNone = ~std::uint32_t{0};
    bool is(const MoveState& s, const Axes& o, const std::array<double, 3>& t) const {
      return same_bits(state, s) && same_bits(offset, o) && same_bits(tip, t) && number != kNone;
    }
  };
  std::uint32_t find_state(const MoveState& state, const Axes& offset,
                           const std::array<double, 3>& tip);
  void grow();
  void push_extras(const Axes& point);
  template <class Use>
  void walk(InterruptCheck* interrupt, Use&& use) const;

  Chunks<Chunk> chunks_;
  Room room_;
  std::size_t rows_ = 0;
  std::vector<Extra> extras_;
  Column<MoveState> states_;
  Column<Axes> offsets_;
  Column<std::array<double, 3>> tips_;
  Column<Arc> arcs_;
  Column<Vector> vectors_;
  Column<Seconds> seconds_;
  Column<Skip> skips_;
  Column<Leap> leaps_;
  // The last two: feeds or zero points that alternate are no new states every time.
  std::array<ReportedOffset, 2> reported_;
  std::uint32_t last_reported_ = 0;
  std::uint32_t used_ = 0;
  Axes start_{};  // machine position before the first row
  Axes rapid_{};
  std::uint32_t diameters_ = 0;
  bool turned_ = false;  // some rows are in rotated work coordinates
};

}  // namespace cncsub
