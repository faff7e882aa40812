// The arithmetic of frames as values, and the frames of the work systems.
#pragma once

#include <optional>

#include "cncsub/motion/state/context.hpp"
#include "cncsub/motion/state/frames.hpp"

namespace cncsub {

Matrix product(const Matrix& a, const Matrix& b);
/// Return a point to which a matrix is applied.
Axes applied(const Matrix& of, Axes point);
Matrix inverse(const Matrix& of);
/// Return a rotation about an axis, counter-clockwise as seen against it. A quarter of a turn
/// leaves no rounding.
Matrix rotation(int axis, double degrees);

/// Return a frame that turns about Z, then the new Y, then the new X, by these angles of X, Y, Z.
FrameValue rotated(const std::array<double, 3>& angles);
/// Return a frame that scales by these factors, and mirrors these axes.
FrameValue scaled(const std::array<double, 3>& factors, std::uint64_t mirrored);
/// Return a frame that lies in another one.
FrameValue chained(const FrameValue& outer, const FrameValue& inner);
/// Return a part of a frame along or about an axis; nothing where the frame shears, so that no
/// rotation and no scale make it.
std::optional<double> part_of(const FrameValue& frame, FramePart part, int axis);
/// Put a value in place of a part of a frame; return false where it has no such part.
bool set_part(FrameValue& frame, const FrameEntry& entry);
bool in_range(const FrameValue& frame);

/// Return a frame that a work system holds. Number 0 is the system that no offset fills, from 1 on
/// they are the other systems in their order.
FrameValue stored_frame(const MotionState& state, int number);
int frame_number(const MotionState& state);
/// Return how many numbers there are.
int frame_numbers(const MotionState& state);
FrameValue frame_in_force(const MotionState& state, FrameInForce which);
/// Put the frame of the work system in force, and lay that of the program over it.
void take_stored_frame(MotionState& state);
void combine_frames(MotionState& state);
/// Write a frame of a work system, by its number among them.
void store_frame(MotionState& state, int number, const FrameValue& frame);
/// Write the frame of a work system, 0 the basic one.
void write_frame(MotionState& state, int system, const FrameValue& frame);

}  // namespace cncsub
