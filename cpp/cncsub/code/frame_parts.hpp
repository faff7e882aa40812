// What programs name of frames.
#pragma once

#include <cstdint>

namespace cncsub {

/// The parts of a frame: what Ins::AxisOfFrame and Ins::FramePart hold.
enum class FramePart : std::uint8_t { Shift, Fine, Rotation, Scale, Mirror };

/// What VariableKind::FrameInForce reads, by its index.
enum class FrameInForce : std::uint8_t { Settable, Program, Basic, Whole, Other };

}  // namespace cncsub
