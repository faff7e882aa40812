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

/// Find the angles and factors of a frame from its matrix; a matrix that shears has none.
void find_parts(FrameValue& frame) {
  constexpr double kSlack = 1e-9;
  Matrix of = frame.matrix;
  for (int j = 0; j < 3; ++j) {
    double& size = frame.factors[static_cast<std::size_t>(j)];
    size = std::hypot(cell(of, 0, j), cell(of, 1, j), cell(of, 2, j));
    const double sign = (frame.mirrored >> j & 1) != 0 ? -1 : 1;
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
  frame.sheared = !square || !(handed > 0) ? 1 : 0;
  frame.angles = {};
  if (frame.sheared == 0)
    frame.angles = angles_of(of);
  else
    frame.factors = {1, 1, 1};
}

/// Bring angles into the range in which they are read: half a turn about X and Z, less than a
/// quarter about Y, and none about X at that quarter. [840Dk p.2-44]
std::array<double, 3> in_reading_range(std::array<double, 3> angles) {
  auto& [x, y, z] = angles;
  if (std::fabs(x) <= 180 && std::fabs(y) < 90 && std::fabs(z) <= 180) return angles;
  y = std::remainder(y, 360);
  if (std::fabs(y) > 90) {
    y = std::copysign(180, y) - y;
    x += 180;
    z += 180;
  } else if (std::fabs(y) == 90) {
    z += y > 0 ? -x : x;
    x = 0;
  }
  if (std::fabs(x) > 180) x = std::remainder(x, 360);
  if (std::fabs(z) > 180) z = std::remainder(z, 360);
  return angles;
}

/// Return the axis about which alone angles turn; -1 where they turn about none or about several.
int only_axis(const std::array<double, 3>& angles) {
  int only = -1;
  for (int i = 0; i < 3; ++i) {
    if (angles[static_cast<std::size_t>(i)] == 0) continue;
    if (only >= 0) return -1;
    only = i;
  }
  return only;
}

/// Find the angles and factors of a frame that lies in another one, from theirs where that is
/// exact.
void chain_parts(const FrameValue& outer, const FrameValue& inner, FrameValue& frame) {
  const bool shifts = outer.matrix == kUnitMatrix;
  if (shifts || inner.matrix == kUnitMatrix) {
    const FrameValue& turns = shifts ? inner : outer;
    frame.angles = turns.angles;
    frame.factors = turns.factors;
    frame.sheared = turns.sheared;
    return;
  }
  find_parts(frame);
  const int axis = only_axis(outer.angles);
  const bool plain = outer.factors == std::array<double, 3>{1, 1, 1} && outer.mirrored == 0;
  if (!plain || axis < 0 || axis != only_axis(inner.angles) || inner.sheared + outer.sheared != 0)
    return;
  const auto i = static_cast<std::size_t>(axis);
  frame.angles = {};
  frame.angles[i] = outer.angles[i] + inner.angles[i];
  frame.factors = inner.factors;
}

/// Make the matrix of a frame from its angles and factors.
void make_matrix(FrameValue& frame) {
  Matrix& result = frame.matrix;
  result = kUnitMatrix;
  for (const int axis : {2, 1, 0})
    result = product(result, rotation(axis, frame.angles[static_cast<std::size_t>(axis)]));
  for (int j = 0; j < 3; ++j) {
    const double sign = (frame.mirrored >> j & 1) != 0 ? -1 : 1;
    for (int i = 0; i < 3; ++i)
      cell(result, i, j) *= sign * frame.factors[static_cast<std::size_t>(j)];
  }
}

/// Give a frame with a zero point its shift: the one that a program wrote, or what the zero point
/// leaves beside the fine shift where something else has changed it.
void take_zero(FrameValue& frame, const Axes& zero) {
  if (frame.whole_shift() != zero) frame.shift = zero - frame.fine;
}

/// Return what a program has written of the frame of a work system, 0 the basic one.
FrameValue written_frame(const MotionState& state, int system) {
  const auto found = state.frames->stored.find(system);
  return found == state.frames->stored.end() ? FrameValue() : found->second;
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
  chain_parts(outer, inner, frame);
  return frame;
}

std::optional<double> part_of(const FrameValue& frame, FramePart part, int axis) {
  const auto i = static_cast<std::size_t>(axis);
  if (part == FramePart::Shift) return frame.shift[i];
  if (part == FramePart::Fine) return frame.fine[i];
  if (part == FramePart::Mirror) return (frame.mirrored >> axis & 1) != 0 ? 1 : 0;
  if (axis > 2) return part == FramePart::Scale ? 1 : 0;
  if (frame.sheared != 0) return std::nullopt;
  return part == FramePart::Scale ? frame.factors[i] : in_reading_range(frame.angles)[i];
}

bool set_part(FrameValue& frame, const FrameEntry& entry) {
  const auto part = static_cast<FramePart>(entry.part);
  const std::size_t i = entry.axis;
  if (part == FramePart::Shift) return frame.shift[i] = entry.value, true;
  if (part == FramePart::Fine) return frame.fine[i] = entry.value, true;
  if (i > 2) return false;
  if (frame.sheared != 0 || (part == FramePart::Scale && !(entry.value > 0))) return false;
  if (part == FramePart::Scale) frame.factors[i] = entry.value;
  if (part == FramePart::Rotation) frame.angles[i] = entry.value;
  if (part == FramePart::Mirror) {
    const std::uint64_t axis = std::uint64_t{1} << i;
    frame.mirrored = entry.value != 0 ? frame.mirrored | axis : frame.mirrored & ~axis;
  }
  make_matrix(frame);
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
  FrameValue frame = written_frame(state, system);
  take_zero(frame, state.tables.zero(system));
  return frame;
}

FrameValue frame_in_force(const MotionState& state, FrameInForce which) {
  FrameValue basic = written_frame(state, 0), settable = state.frames->settable;
  take_zero(basic, state.tables.zero(0));
  take_zero(settable, state.zero_is_held ? state.zero : state.tables.zero(system_in_force(state)));
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
  const FrameValue stored = written_frame(state, system_in_force(state));
  if (stored == state.frames->settable) return;
  state.frames.change().settable = stored;
  combine_frames(state);
}

void store_frame(MotionState& state, int number, const FrameValue& frame) {
  const int system = system_of_number(state, number);
  if (system == system_in_force(state)) hold_zero(state);
  write_frame(state, system, frame);
}

void write_frame(MotionState& state, int system, const FrameValue& frame) {
  state.tables.change_zero(system) = frame.whole_shift();
  FrameValue stored = frame;
  stored.shift = {};
  if (stored == FrameValue())
    state.frames.change().stored.erase(system);
  else
    state.frames.change().stored[system] = frame;
}

FrameValue rotated(const std::array<double, 3>& angles) {
  FrameValue frame;
  frame.angles = angles;
  make_matrix(frame);
  return frame;
}

FrameValue scaled(const std::array<double, 3>& factors, std::uint64_t mirrored) {
  FrameValue frame;
  for (std::size_t i = 0; i < factors.size(); ++i) {
    frame.matrix[4 * i] = (mirrored >> i & 1) != 0 ? -factors[i] : factors[i];
    if (factors[i] < 0) frame.sheared = 1;
  }
  if (frame.sheared == 0) frame.factors = factors;
  frame.mirrored = mirrored;
  return frame;
}

}  // namespace cncsub
