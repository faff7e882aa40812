// Frames as values: chains of them, their parts, and those of the work systems.
#include "cncsub/motion/frame/frame_values.hpp"

#include <algorithm>
#include <cmath>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

double& cell(Matrix& of, int row, int column) {
  return of[3 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column)];
}
double cell(const Matrix& of, int row, int column) {
  return of[3 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column)];
}

/// What a matrix is made of: angles about X, Y and Z, then factors along the turned axes.
struct Parts {
  std::array<double, 3> angles{}, factors{1, 1, 1};
};

/// Return the angles of a rotation about Z, then the new Y, then the new X.
std::array<double, 3> angles_of(const Matrix& rotation) {
  constexpr double kUpright = 1 - 1e-12, kDegrees = 180 / kPi;
  const auto angle = [](double y, double x) { return y == 0 && x > 0 ? 0.0 : std::atan2(y, x); };
  const double sine = std::clamp(-cell(rotation, 2, 0), -1.0, 1.0);
  // Upright, the angles about X and Z say the same, and all of it is given to Z.
  if (std::fabs(sine) > kUpright)
    return {0, std::copysign(90, sine),
            angle(-cell(rotation, 0, 1), cell(rotation, 1, 1)) * kDegrees};
  return {angle(cell(rotation, 2, 1), cell(rotation, 2, 2)) * kDegrees, std::asin(sine) * kDegrees,
          angle(cell(rotation, 1, 0), cell(rotation, 0, 0)) * kDegrees};
}

/// Return the parts of a matrix whose columns of these axes are mirrored; nothing where it shears.
std::optional<Parts> parts_of(Matrix of, std::uint64_t mirrored) {
  constexpr double kSlack = 1e-9;
  Parts parts;
  for (int j = 0; j < 3; ++j) {
    double& size = parts.factors[static_cast<std::size_t>(j)];
    size = std::hypot(cell(of, 0, j), cell(of, 1, j), cell(of, 2, j));
    const double sign = (mirrored >> j & 1) != 0 ? -1 : 1;
    for (int i = 0; i < 3; ++i) cell(of, i, j) /= sign * size;
  }
  const auto between = [&](int a, int b) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += cell(of, i, a) * cell(of, i, b);
    return sum;
  };
  double handed = 0;
  for (int i = 0; i < 3; ++i)
    handed += cell(of, 0, i) * (cell(of, 1, (i + 1) % 3) * cell(of, 2, (i + 2) % 3) -
                                cell(of, 1, (i + 2) % 3) * cell(of, 2, (i + 1) % 3));
  const bool square = std::fabs(between(0, 1)) < kSlack && std::fabs(between(0, 2)) < kSlack &&
                      std::fabs(between(1, 2)) < kSlack;
  if (!square || !(handed > 0)) return std::nullopt;
  parts.angles = angles_of(of);
  return parts;
}

Matrix matrix_of(const Parts& parts, std::uint64_t mirrored) {
  Matrix result = kUnitMatrix;
  for (const int axis : {2, 1, 0})
    result = product(result, rotation(axis, parts.angles[static_cast<std::size_t>(axis)]));
  for (int j = 0; j < 3; ++j) {
    const double sign = (mirrored >> j & 1) != 0 ? -1 : 1;
    for (int i = 0; i < 3; ++i)
      cell(result, i, j) *= sign * parts.factors[static_cast<std::size_t>(j)];
  }
  return result;
}

/// Return the work system of a number: the systems of four codes come first, then the extra ones by
/// their own numbers. [MD840, framevar.svar: 0 is G500, 1 to 4 G54 to G57, 5 to 99 G505 to G599]
int system_of_number(const MotionState& state, int number) {
  if (number == 0) return state.tables.last_system();
  return number <= 4 ? number : 6 + number;
}

}  // namespace

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix result{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) cell(result, i, j) += cell(a, i, k) * cell(b, k, j);
  return result;
}

Axes applied(const Matrix& of, Axes point) {
  const std::array<double, 3> from{point[0], point[1], point[2]};
  for (int i = 0; i < 3; ++i)
    point[static_cast<std::size_t>(i)] =
        cell(of, i, 0) * from[0] + cell(of, i, 1) * from[1] + cell(of, i, 2) * from[2];
  return point;
}

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

Matrix rotation(int axis, double degrees) {
  const double quarters = degrees / 90;
  const bool whole = quarters == std::floor(quarters) && std::fabs(quarters) < 1e9;
  const auto turns = whole ? static_cast<int>(std::fmod(std::fmod(quarters, 4) + 4, 4)) : 0;
  static constexpr std::array<int, 4> kSine{0, 1, 0, -1}, kCosine{1, 0, -1, 0};
  const double s = whole ? kSine[static_cast<std::size_t>(turns)] : std::sin(degrees * kPi / 180);
  const double c = whole ? kCosine[static_cast<std::size_t>(turns)] : std::cos(degrees * kPi / 180);
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  Matrix result = kUnitMatrix;
  cell(result, a, a) = cell(result, b, b) = c;
  cell(result, a, b) = -s;
  cell(result, b, a) = s;
  return result;
}

FrameValue chained(const FrameValue& outer, const FrameValue& inner) {
  FrameValue frame;
  frame.matrix = product(outer.matrix, inner.matrix);
  frame.shift = outer.shift + applied(outer.matrix, inner.shift);
  frame.fine = outer.fine + applied(outer.matrix, inner.fine);
  frame.mirrored = outer.mirrored ^ inner.mirrored;
  return frame;
}

std::optional<double> part_of(const FrameValue& frame, FramePart part, int axis) {
  const auto i = static_cast<std::size_t>(axis);
  if (part == FramePart::Shift) return frame.shift[i];
  if (part == FramePart::Fine) return frame.fine[i];
  if (part == FramePart::Mirror) return (frame.mirrored >> axis & 1) != 0 ? 1 : 0;
  if (axis > 2) return part == FramePart::Scale ? 1 : 0;
  const std::optional<Parts> parts = parts_of(frame.matrix, frame.mirrored);
  if (!parts) return std::nullopt;
  return part == FramePart::Scale ? parts->factors[i] : parts->angles[i];
}

bool set_part(FrameValue& frame, const FrameEntry& entry) {
  const auto part = static_cast<FramePart>(entry.part);
  const std::size_t i = entry.axis;
  if (part == FramePart::Shift) return frame.shift[i] = entry.value, true;
  if (part == FramePart::Fine) return frame.fine[i] = entry.value, true;
  if (i > 2) return false;
  std::optional<Parts> parts = parts_of(frame.matrix, frame.mirrored);
  if (!parts || (part == FramePart::Scale && !(entry.value > 0))) return false;
  if (part == FramePart::Scale) parts->factors[i] = entry.value;
  if (part == FramePart::Rotation) parts->angles[i] = entry.value;
  if (part == FramePart::Mirror) {
    const std::uint64_t axis = std::uint64_t{1} << i;
    frame.mirrored = entry.value != 0 ? frame.mirrored | axis : frame.mirrored & ~axis;
  }
  frame.matrix = matrix_of(*parts, frame.mirrored);
  return true;
}

bool in_range(const FrameValue& frame) {
  return in_range(frame.matrix) && in_range(frame.shift) && in_range(frame.fine) &&
         in_range(frame.whole_shift());
}

int frame_numbers(const MotionState& state) { return state.tables.last_system() - 6; }

int frame_number(const MotionState& state) {
  const int system = system_in_force(state);
  if (system == state.tables.last_system()) return 0;
  return system > 6 ? system - 6 : system;
}

FrameValue stored_frame(const MotionState& state, int number) {
  const int system = system_of_number(state, number);
  const auto found = state.frames->stored.find(system);
  FrameValue frame = found == state.frames->stored.end() ? FrameValue() : found->second;
  frame.shift = state.tables.zero(system) - frame.fine;
  return frame;
}

FrameValue frame_in_force(const MotionState& state, FrameInForce which) {
  FrameValue basic, settable = state.frames->settable;
  basic.shift = state.tables.zero(0);
  settable.shift =
      (state.zero_is_held ? state.zero : state.tables.zero(system_in_force(state))) - settable.fine;
  switch (which) {
    case FrameInForce::Settable:
      return settable;
    case FrameInForce::Program:
      return state.frames->program;
    case FrameInForce::Basic:
      return basic;
    case FrameInForce::Whole:
      return chained(chained(basic, settable), state.frames->program);
    case FrameInForce::Other:
      break;
  }
  return {};
}

void combine_frames(MotionState& state) {
  const FrameValue& program = state.frames->program;
  const Matrix& outer = state.frames->settable.matrix;
  state.frame.matrix = product(outer, program.matrix);
  state.frame.shift = applied(outer, program.whole_shift());
  state.frame.turned = state.frame.matrix != kUnitMatrix;
}

void take_stored_frame(MotionState& state) {
  const auto found = state.frames->stored.find(system_in_force(state));
  const FrameValue stored = found == state.frames->stored.end() ? FrameValue() : found->second;
  if (stored == state.frames->settable) return;
  state.frames.change().settable = stored;
  combine_frames(state);
}

void store_frame(MotionState& state, int number, const FrameValue& frame) {
  const int system = system_of_number(state, number);
  if (system == system_in_force(state)) hold_zero(state);
  state.tables.change_zero(system) = frame.whole_shift();
  FrameValue stored = frame;
  stored.shift = {};
  if (stored == FrameValue())
    state.frames.change().stored.erase(system);
  else
    state.frames.change().stored[system] = stored;
}

}  // namespace cncsub
