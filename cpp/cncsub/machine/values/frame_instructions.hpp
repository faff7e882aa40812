// The computations of the instructions of frames.
#pragma once

#include "cncsub/machine/values/frames.hpp"
#include "cncsub/machine/values/instructions.hpp"
#include "cncsub/motion/frame/frame_values.hpp"
#include "cncsub/motion/state/modes.hpp"

namespace cncsub::instruction {

/// Return the place of an axis; nothing where the value is none, or the frame has none of it.
inline std::optional<int> axis_of_frame_part(E e, I at, double axis, FramePart part) {
  const bool straight = part != FramePart::Shift && part != FramePart::Fine;
  const double last = straight ? 3 : kAxes;
  if (axis >= 1 && axis <= last) return to_whole<int>(axis) - 1;
  fails(e, at, Cause::ArrayElement, "a frame has no such value of this axis");
  return std::nullopt;
}
inline bool are_metric(E e, I at) {
  if (!g20(e.run.motion.state())) return true;
  fails(e, at, Cause::CodeNotComputed, "frames as values in inches");
  return false;
}

inline Fallible axis_of_frame(E e, I at, double a, double b) {
  const auto part = static_cast<FramePart>(to_whole<int>(at.value()));
  const auto axis = axis_of_frame_part(e, at, a, part);
  if (!axis || !are_metric(e, at)) return std::nullopt;
  if (part == FramePart::Scale && b == 0) return fails(e, at, Cause::ScaleZero);
  return keep_entry(e.run,
                    {static_cast<std::uint32_t>(part), static_cast<std::uint32_t>(*axis), b});
}
inline Fallible over_frame(E e, I at, double a, double b) {
  FrameValue frame = frame_of(e.run, a);
  if (!set_part(frame, entry_of(e.run, b)))
    return fails(e, at, Cause::CodeNotComputed,
                 "this part of a frame that shears or turns inside out");
  if (in_range(frame)) return keep_frame(e.run, frame);
  return fails(e, at, Cause::ValueOutOfRange, "the frame is out of range");
}
inline Fallible chain_frames(E e, I at, double a, double b) {
  const FrameValue frame = chained(frame_of(e.run, a), frame_of(e.run, b));
  if (in_range(frame)) return keep_frame(e.run, frame);
  return fails(e, at, Cause::ValueOutOfRange, "the frame is out of range");
}
inline Fallible frame_part(E e, I at, double a, double b) {
  const auto part = static_cast<FramePart>(to_whole<int>(at.value()));
  const auto axis = axis_of_frame_part(e, at, b, part);
  if (!axis || !are_metric(e, at)) return std::nullopt;
  const auto value = part_of(frame_of(e.run, a), part, *axis);
  if (value) return value;
  return fails(e, at, Cause::CodeNotComputed,
               "this part of a frame that shears or turns inside out");
}

}  // namespace cncsub::instruction
