// The frame of the program: a matrix with a shift, which shifts, rotations, scales and mirrors
// make.
#include <algorithm>
#include <cmath>

#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/frame/frame_values.hpp"
#include "cncsub/motion/state/modes.hpp"
#include "cncsub/motion/state/values.hpp"

namespace cncsub {
namespace {

/// Read the shift of a frame, in mm.
FrameValue shift_of(MotionView m, const BlockWords& block) {
  FrameValue frame;
  for (std::size_t i = 0; i < frame.shift.size(); ++i)
    if (const char name = kAxisNames[i]; block.words.has(name))
      frame.shift[i] = number(m, block, name);
  return frame;
}

/// Read a rotation: in the plane, or about Z, then the new Y, then the new X.
Result rotation_of(MotionView m, const BlockWords& block, FrameValue& frame) {
  std::array<double, 3> angles{};
  bool any = false;
  for (std::size_t i = 0; i < angles.size(); ++i)
    if (const char name = kAxisNames[i]; block.words.has(name)) {
      angles[i] = block.words[name];
      any = true;
    }
  for (const char name : m.facts.control->motion.rotation_words.value) {
    if (!block.words.has(name)) continue;
    if (any)
      return fault_at(name, Cause::AddressNotUsable, block,
                      "an angle in the plane stands beside one about an axis");
    angles[static_cast<std::size_t>(plane_axes(m.state.plane).across)] = block.words[name];
  }
  frame = rotated(angles);
  return std::nullopt;
}

Result scale_of(const BlockWords& block, FrameValue& frame) {
  std::array<double, 3> factors{1, 1, 1};
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const char name = kAxisNames[i];
    if (!block.words.has(name)) continue;
    if (block.words[name] == 0) return fault_at(name, Cause::ScaleZero, block);
    factors[i] = block.words[name];
  }
  frame = scaled(factors, 0);
  return std::nullopt;
}

FrameValue mirror_of(const BlockWords& block) {
  std::uint64_t mirrored = 0;
  for (std::size_t i = 0; i < 3; ++i)
    if (block.words.has(kAxisNames[i])) mirrored |= std::uint64_t{1} << i;
  return scaled({1, 1, 1}, mirrored);
}

/// Read what a block does to the frame.
Result read_frame(MotionView m, const BlockWords& block, Meaning meaning, FrameValue& frame) {
  switch (meaning) {
    case Meaning::FrameShift:
      frame = shift_of(m, block);
      return std::nullopt;
    case Meaning::FrameRotation:
      return rotation_of(m, block, frame);
    case Meaning::FrameScale:
      return scale_of(block, frame);
    default:
      frame = mirror_of(block);
      return std::nullopt;
  }
}

}  // namespace

namespace {

/// Return the frame of the program after a shift that changes it. Where added shifts are fine ones,
/// an absolute shift leaves the fine one alone. [SONE p.315]
FrameValue shifted(const FrameValue& before, const FrameValue& shift, bool added, bool fine) {
  if (!fine) return added ? chained(before, shift) : shift;
  FrameValue frame = shift;
  if (!added) {
    frame.fine = before.fine;
    return frame;
  }
  frame.fine = frame.shift;
  frame.shift = {};
  return chained(before, frame);
}

/// Change one part of the shift of a frame, on the axes that the block names.
FrameValue shifted_by_axis(MotionView m, const BlockWords& block, FrameValue frame) {
  const bool fine = block.code(Group::OneShot).variant == 1;
  Axes& part = fine ? frame.fine : frame.shift;
  for (std::size_t i = 0; i < part.size(); ++i)
    if (const char name = kAxisNames[i]; block.words.has(name)) part[i] = number(m, block, name);
  return frame;
}

/// Return the frame of the program after a block that changes it.
Result change_frame(MotionView m, const BlockWords& block, Meaning meaning, FrameValue& program) {
  const bool fine = m.facts.control->motion.fine_shift.value;
  if (meaning == Meaning::FrameShiftByAxis) {
    if (!fine) return fault(Cause::FineShiftOff, block);
    program = shifted_by_axis(m, block, program);
    return std::nullopt;
  }
  FrameValue frame;
  if (auto wrong = read_frame(m, block, meaning, frame)) return wrong;
  const bool added = block.code(Group::OneShot).variant == 1;
  const bool any = (block.words.mask & kAxisWords) != 0;  // TRANS alone ends the whole frame
  if (meaning == Meaning::FrameShift && any)
    program = shifted(program, frame, added, fine);
  else
    program = added ? chained(program, frame) : frame;
  return std::nullopt;
}

}  // namespace

Result set_frame(MotionContext& m, BlockWords& block, Meaning meaning) {
  MotionState& s = m.state;
  block.consumed = true;
  if (moves_wait(s))
    return fault(Cause::CodeNotComputed, block,
                 "cncsub does not compute a frame while a radius is compensated or a corner waits");
  FrameValue program = s.frames->program;
  if (auto wrong = change_frame(m, block, meaning, program)) return wrong;
  const Axes from = increments_from(s);
  s.frames.change().program = program;
  combine_frames(s);
  if (!in_range(program) || !in_range(s.frame.matrix) || !in_range(s.frame.shift))
    return out_of_range(block.words.at);
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
