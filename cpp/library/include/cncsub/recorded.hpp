// What the record of a run consists of. A part of cncsub.hpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace cncsub::api {

/// Where something stands: a block of a program, and the line of its file.
struct Place {
  std::string program;  // "O1"
  std::optional<std::int64_t> n;
  std::uint32_t line = 0;  // from 1
  std::string file;
};

/// A block that was executed.
struct Step {
  Place at;
  std::string text;      // of the block
  int depth = 0;         // open calls
  bool skipped = false;  // it has a condition that did not hold
};

enum class Motion { Rapid, Feed, Clockwise, Counterclockwise, Thread, Dwell };

/// Columns of moves, each as long as `size` and written by the caller's wish alone: null is left
/// out.
struct MoveColumns {
  double *x = nullptr, *y = nullptr, *z = nullptr;     // ends, work coordinates
  double *mx = nullptr, *my = nullptr, *mz = nullptr;  // ends of the tool, machine coordinates
  double *cx = nullptr, *cy = nullptr, *cz = nullptr;  // centres of arcs; NaN elsewhere
  double *feed = nullptr, *length = nullptr, *time = nullptr;
  std::int32_t* kind = nullptr;  // a Motion
  std::int64_t* step = nullptr;  // the step that makes it
};

/// Points of a path; on a diameter axis they are radii. `begins`: no line leads to the point.
struct Path {
  std::vector<double> x, y, z;
  std::vector<std::uint32_t> move;
  std::vector<std::uint8_t> begins;
};

/// A call as it is recorded; `parent` is the call in which it was made, -1 the main program.
struct CallMade {
  std::string kind, called;
  std::int64_t parent = -1, start_n = -1, repeats = 1;
  std::int64_t caller_step = 0, first_step = 0, last_step = -1;  // -1: it did not end
};

/// A variable that has a value: by its number, or by its name, such as "SIDES[1]".
struct Variable {
  std::int64_t number = -1;
  std::string name;             // empty of one with a number
  std::optional<double> value;  // none of a text
  std::string text;             // as people read it
};

}  // namespace cncsub::api
