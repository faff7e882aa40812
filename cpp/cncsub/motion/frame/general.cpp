// The frame of the program: a matrix with a shift, which shifts, rotations, scales and mirrors
// make.
#include <algorithm>
#include <cmath>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

using Matrix = std::array<double, 9>;
constexpr Matrix kUnit{1, 0, 0, 0, 1, 0, 0, 0, 1};

double& cell(Matrix& of, int row, int column) {
  return of[3 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column)];
}
double cell(const Matrix& of, int row, int column) {
  return of[3 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column)];
}

/// Return the product of two matrices.
Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) cell(result, i, j) += cell(a, i, k) * cell(b, k, j);
  return result;
}

/// Return a point to which a matrix is applied.
Axes applied(const Matrix& of, Axes point) {
  const std::array<double, 3> from{point[0], point[1], point[2]};
  for (int i = 0; i < 3; ++i)
    point[static_cast<std::size_t>(i)] =
        cell(of, i, 0) * from[0] + cell(of, i, 1) * from[1] + cell(of, i, 2) * from[2];
  return point;
}

/// Return the inverse of a matrix that has one.
Matrix inverse(const Matrix& of) {
  Matrix result{};
  const auto minor = [&](int i, int j) {
    const int a = (i + 1) % 3, b = (i + 2) % 3, c = (j + 1) % 3, d = (j + 2) % 3;
    return cell(of, a, c) * cell(of, b, d) - cell(of, a, d) * cell(of, b, c);
  };
  const double size =
      cell(of, 0, 0) * minor(0, 0) + cell(of, 0, 1) * minor(0, 1) + cell(of, 0, 2) * minor(0, 2);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) cell(result, j, i) = minor(i, j) / size;
  return result;
}

/// Return a rotation about an axis, counter-clockwise as seen against it. A quarter of a turn
/// leaves no rounding.
Matrix rotation(int axis, double degrees) {
  const double quarters = degrees / 90;
  const bool whole = quarters == std::floor(quarters) && std::fabs(quarters) < 1e9;
  const auto turns = whole ? static_cast<int>(std::fmod(std::fmod(quarters, 4) + 4, 4)) : 0;
  static constexpr std::array<int, 4> kSine{0, 1, 0, -1}, kCosine{1, 0, -1, 0};
  const double s = whole ? kSine[static_cast<std::size_t>(turns)] : std::sin(degrees * kPi / 180);
  const double c = whole ? kCosine[static_cast<std::size_t>(turns)] : std::cos(degrees * kPi / 180);
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  Matrix result = kUnit;
  cell(result, a, a) = cell(result, b, b) = c;
  cell(result, a, b) = -s;
  cell(result, b, a) = s;
  return result;
}

/// Read the shift of a frame, in mm.
GeneralFrame shift_of(MotionView m, const BlockWords& block) {
  GeneralFrame frame;
  for (std::size_t i = 0; i < frame.shift.size(); ++i)
    if (const char name = kAxisNames[i]; block.words.has(name))
      frame.shift[i] = number(m, block, name);
  return frame;
}

/// Read a rotation: in the plane, or about Z, then the new Y, then the new X.
GeneralFrame rotation_of(MotionView m, const BlockWords& block) {
  GeneralFrame frame;
  for (const char name : m.facts.control->motion.rotation_words.value)
    if (block.words.has(name))
      frame.matrix = rotation(plane_axes(m.state.plane).across, block.words[name]);
  for (const int axis : {2, 1, 0})
    if (const char name = kAxisNames[static_cast<std::size_t>(axis)]; block.words.has(name))
      frame.matrix = product(frame.matrix, rotation(axis, block.words[name]));
  return frame;
}

Result scale_of(const BlockWords& block, GeneralFrame& frame) {
  for (int i = 0; i < 3; ++i) {
    const char name = kAxisNames[static_cast<std::size_t>(i)];
    if (!block.words.has(name)) continue;
    if (block.words[name] == 0) return fault_at(name, Cause::ScaleZero, block);
    cell(frame.matrix, i, i) = block.words[name];
  }
  return std::nullopt;
}

GeneralFrame mirror_of(const BlockWords& block) {
  GeneralFrame frame;
  for (int i = 0; i < 3; ++i)
    if (block.words.has(kAxisNames[static_cast<std::size_t>(i)])) cell(frame.matrix, i, i) = -1;
  return frame;
}

/// Read what a block does to the frame.
Result read_frame(MotionView m, const BlockWords& block, Meaning meaning, GeneralFrame& frame) {
  switch (meaning) {
    case Meaning::FrameShift:
      frame = shift_of(m, block);
      return std::nullopt;
    case Meaning::FrameRotation:
      frame = rotation_of(m, block);
      return std::nullopt;
    case Meaning::FrameScale:
      return scale_of(block, frame);
    default:
      frame = mirror_of(block);
      return std::nullopt;
  }
}

/// Return a frame that lies in another one.
GeneralFrame chained(const GeneralFrame& outer, const GeneralFrame& inner) {
  GeneralFrame frame;
  frame.matrix = product(outer.matrix, inner.matrix);
  frame.shift = outer.shift + applied(outer.matrix, inner.shift);
  return frame;
}

}  // namespace

Result set_frame(MotionContext& m, BlockWords& block, Meaning meaning) {
  MotionState& s = m.state;
  block.consumed = true;
  if (moves_wait(s))
    return fault(Cause::CodeNotComputed, block,
                 "cncsub does not compute a frame while a radius is compensated or a corner waits");
  GeneralFrame frame;
  if (auto wrong = read_frame(m, block, meaning, frame)) return wrong;
  const Axes from = increments_from(s);
  const bool added = block.code(Group::OneShot).variant == 1;
  s.frame = added ? chained(s.frame, frame) : frame;
  s.frame.turned = s.frame.matrix != kUnit;
  if (!in_range(s.frame.matrix) || !in_range(s.frame.shift)) return out_of_range(block.words.at);
  refresh_offset(s);
  keep_increments(m.facts, s, from);
  return std::nullopt;
}

void turn_in_frame(const GeneralFrame& frame, Axes& point, std::uint32_t& named) {
  std::uint32_t moved = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if ((named >> j & 1) != 0 && frame(i, j) != 0) moved |= axis_bit(i);
  named |= moved;
  point = applied(frame.matrix, point);
}

Axes turned_back(const GeneralFrame& frame, Axes point) {
  return applied(inverse(frame.matrix), point);
}

double factor_in_plane(const GeneralFrame& frame, const PlaneAxes& plane) {
  const double area = frame(plane.a, plane.a) * frame(plane.b, plane.b) -
                      frame(plane.a, plane.b) * frame(plane.b, plane.a);
  return std::copysign(std::sqrt(std::fabs(area)), area);
}

bool keeps_arcs(const GeneralFrame& frame, const PlaneAxes& plane) {
  constexpr double kSlack = 1e-9;
  const double size = factor_in_plane(frame, plane);
  const auto is_small = [&](double value) { return std::fabs(value) <= kSlack * std::fabs(size); };
  const double side = size < 0 ? -1 : 1;
  return is_small(frame(plane.across, plane.a)) && is_small(frame(plane.across, plane.b)) &&
         is_small(frame(plane.a, plane.across)) && is_small(frame(plane.b, plane.across)) &&
         is_small(frame(plane.a, plane.a) - side * frame(plane.b, plane.b)) &&
         is_small(frame(plane.a, plane.b) + side * frame(plane.b, plane.a));
}

Axes increments_from(const MotionState& state) {
  return as_programmed(state, state.work) + state.unmoved;
}

void keep_increments(const MotionFacts& facts, MotionState& state, const Axes& from) {
  if (!facts.control->motion.shifts_move_increments.value) return;
  state.unmoved = {};
  state.unmoved = from - increments_from(state);
  for (double& left : state.unmoved)
    if (std::fabs(left) < kStanding) left = 0;
}

}  // namespace cncsub
