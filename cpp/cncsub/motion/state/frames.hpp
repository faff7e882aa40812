// Frames as values: what programs keep, write and read of them.
#pragma once

#include <array>
#include <cstdint>
#include <map>

#include "cncsub/code/frame_parts.hpp"
#include "cncsub/trace/moves.hpp"

namespace cncsub {

/// A matrix of X, Y and Z, row by row.
using Matrix = std::array<double, 9>;
constexpr Matrix kUnitMatrix{1, 0, 0, 0, 1, 0, 0, 0, 1};

/// A frame with the parts that a program can name: points are turned, scaled and mirrored by a
/// matrix, then shifted. It has no padding: frames of the same bytes are the same.
struct FrameValue {
  Matrix matrix = kUnitMatrix;
  Axes shift{}, fine{};  // mm and degrees
  // What the matrix is made of: angles about Z, then the new Y, then the new X, and factors along
  // the turned axes. They stand beside it, so that a program reads the numbers that it wrote.
  std::array<double, 3> angles{}, factors{1, 1, 1};
  std::uint64_t mirrored = 0;  // axes that count as mirrored, where the matrix mirrors
  std::uint64_t sheared = 0;   // 1 where no angles and factors make the matrix

  Axes whole_shift() const {
    Axes sum = shift;
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += fine[i];
    return sum;
  }
  bool operator==(const FrameValue&) const = default;
};

/// One value of an axis in a frame. It has no padding either.
struct FrameEntry {
  std::uint32_t part = 0;  // a FramePart
  std::uint32_t axis = 0;
  double value = 0;
};

/// The frames that lie in each other, the work system's first.
struct Frames {
  // Of work systems that are more than an offset, 0 the basic one. Their shifts are those that a
  // program wrote; the zero points count.
  std::map<int, FrameValue> stored;
  FrameValue settable;  // of the work system in force; its zero point counts
  FrameValue program;   // what the program lays over it

  bool operator==(const Frames&) const = default;
};

}  // namespace cncsub
