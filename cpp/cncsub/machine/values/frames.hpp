// Frames of a run: the number of each, and what they are.
#pragma once

#include <optional>
#include <string>

#include "cncsub/machine/state/context.hpp"
#include "cncsub/motion/state/frames.hpp"

namespace cncsub {

/// Return the frame that a value stands for. 0, and a value that is none, change nothing.
FrameValue frame_of(const Run& run, double value);
/// Return a frame as the functions write it that make it: CTRANS(X,10):CROT(Z,30). Nothing where
/// none of them make it: it shears or turns inside out.
std::optional<std::string> written(const FrameValue& frame);
/// Return the value that stands for a frame.
double keep_frame(Run& run, const FrameValue& frame);
/// Return the value that stands for one entry of a frame, and the entry.
double keep_entry(Run& run, const FrameEntry& entry);
FrameEntry entry_of(const Run& run, double value);

/// Return a frame of the work systems or in force; nothing where the variable is none.
std::optional<FrameValue> control_frame(const MotionState& state, const VariablePlace& place);
/// Read one as a value, or the number of the work system in force.
std::optional<double> read_frame(Run& run, const VariablePlace& place);
/// Write one, or put an entry in it; return whether the variable is one, with the fault where it is
/// refused.
bool write_frame(Run& run, const VariablePlace& place, double value, std::optional<Fault>& wrong);

}  // namespace cncsub
