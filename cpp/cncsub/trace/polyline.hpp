// The path of the moves as points: the ends as they are, and between the ends of arcs, helices and
// spirals as many points as a tolerance asks for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cncsub/text/interrupt_check.hpp"
#include "cncsub/trace/moves.hpp"

namespace cncsub {

/// Whose path it is, and in which coordinates.
enum class PathFrame : std::uint8_t {
  Work,     // the programmed point, in the work coordinates in force: X10. of the program is here
  Tool,     // the tool with its radius offset, in the same coordinates
  Machine,  // the tool with all its offsets, in machine coordinates
};

/// The places for the points: coordinates in mm (those of a diameter axis halved), the row of the
/// move that each belongs to, and whether the path begins anew there, so that no line leads to the
/// point.
struct PolylinePlaces {
  double *x, *y, *z;
  std::int64_t* row;
  std::uint8_t* begins;
};

/// The points that a picture draws of a path: few where it goes straight on.
struct Outline {
  std::vector<double> x, y, z;
  std::vector<double> time;        // s from the first of the moves until the point is reached
  std::vector<std::uint32_t> row;  // the move that a point belongs to
  std::vector<std::int32_t> key;   // -1: the path begins anew here, and no line leads to the point
  std::size_t points = 0;          // before any was left out
  std::size_t begins = 0;          // of the points, those where the path begins anew
};

/// Samples the moves [first, last): `count` first, then `write`; or `outline`.
///
/// The chord between two points leaves the true curve by no more than `tolerance`, and a turn has
/// four points at least. A move that does not begin where the one before ended (other work
/// coordinates came into force) has its start as a point of its own.
class Sampler {
 public:
  Sampler(const Moves& moves, PathFrame frame, double tolerance, std::size_t first,
          std::size_t last);

  /// Return how many points there are; kMostPoints where there are more. Interrupted, the number
  /// may be anything.
  std::size_t count(InterruptCheck* interrupt);
  void write(const PolylinePlaces& places, InterruptCheck* interrupt) const;

  /// Return the points that are enough, as `simplify` chooses them; all of them where `thinner` is
  /// 0. `keys` has for each of the moves that of its line, from 0.
  Outline outline(const std::int32_t* keys, double thinner, InterruptCheck* interrupt) const;

  static constexpr std::size_t kMostPoints = std::size_t{1} << 31;

 private:
  template <bool timed = false, class Use>
  void each_curve(std::size_t first, std::size_t last, Use&& use) const;

  const Moves& moves_;
  PathFrame frame_;
  double tolerance_;
  std::size_t first_, last_;
  std::vector<std::size_t> begins_;  // the first point of each part
};

/// Mark which points of [first, last) are enough, in one thread, for `simplify` and `outline`.
void thin_piece(const double* x, const double* y, const double* z, const std::int32_t* key,
                std::size_t first, std::size_t last, double tolerance, std::uint8_t* keep);

/// Mark which points of a line are enough for it. What is left out lies within `tolerance` of the
/// chord that goes past it, and the chord as near to what was left out. A point is kept where
/// `key`, that of the line which leads to it, changes. Never more than a window of points goes into
/// one chord, so that a second pass may find fewer.
void simplify(const double* x, const double* y, const double* z, const std::int32_t* key,
              std::size_t count, double tolerance, std::uint8_t* keep, InterruptCheck* interrupt);

}  // namespace cncsub
