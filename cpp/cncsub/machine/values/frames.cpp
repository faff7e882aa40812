#include "cncsub/machine/values/frames.hpp"

#include <array>
#include <cstring>
#include <string_view>
#include <type_traits>

#include "cncsub/machine/state/limits.hpp"
#include "cncsub/motion/frame/frame_values.hpp"
#include "cncsub/system/decimal.hpp"
#include "cncsub/text/axis_names.hpp"

namespace cncsub {
namespace {

// What is kept is found again by its bytes.
static_assert(std::has_unique_object_representations_v<FrameEntry> || sizeof(FrameEntry) == 16);
static_assert(sizeof(FrameValue) ==
              sizeof(Matrix) + 2 * sizeof(Axes) + 6 * sizeof(double) + 2 * sizeof(std::uint64_t));

template <class Kept>
double keep(Run& run, const Kept& of) {
  constexpr std::size_t kMany = 4096;
  std::string bytes(sizeof of, '\0');
  std::memcpy(bytes.data(), &of, sizeof of);
  const std::uint32_t number = run.state.frame_values.number_of(bytes);
  if (run.state.frame_values.size() % kMany == 0) look_soon(run);
  return static_cast<double>(number) + 1;
}

const std::string* bytes_of(const Run& run, double value) {
  if (!(value >= 1) || !(value <= static_cast<double>(run.state.frame_values.size())))
    return nullptr;
  return &run.state.frame_values.at(to_whole<std::size_t>(value) - 1);
}

template <class Kept>
Kept kept(const Run& run, double value) {
  Kept of;
  const std::string* const bytes = bytes_of(run, value);
  if (bytes != nullptr && bytes->size() == sizeof of) std::memcpy(&of, bytes->data(), sizeof of);
  return of;
}

}  // namespace

FrameValue frame_of(const Run& run, double value) { return kept<FrameValue>(run, value); }
FrameEntry entry_of(const Run& run, double value) { return kept<FrameEntry>(run, value); }

/// Return the values of a part that differ from none, X,10,Y,5; nothing where the part has none.
static std::optional<std::string> written(const FrameValue& frame, FramePart part) {
  const int axes = part == FramePart::Shift || part == FramePart::Fine ? kAxes : 3;
  std::string values;
  for (int axis = 0; axis < axes; ++axis) {
    const auto value = part_of(frame, part, axis);
    if (!value) return std::nullopt;
    if (*value == part_of(FrameValue(), part, axis)) continue;
    values += (values.empty() ? "" : ",") + axis_letter(axis + 1);
    if (part != FramePart::Mirror) values += "," + system::shortest(*value);
  }
  return values;
}

std::optional<std::string> written(const FrameValue& frame) {
  static constexpr std::array<std::string_view, 5> kMakers{"CTRANS", "CFINE", "CROT", "CSCALE",
                                                           "CMIRROR"};
  std::string all;
  for (std::size_t part = 0; part < kMakers.size(); ++part) {
    const auto values = written(frame, static_cast<FramePart>(part));
    if (!values) return std::nullopt;
    if (values->empty()) continue;
    all += all.empty() ? "" : ":";
    all += std::string(kMakers[part]) + "(" + *values + ")";
  }
  return all.empty() ? "CTRANS()" : all;
}

double keep_frame(Run& run, const FrameValue& frame) {
  return frame == FrameValue() ? 0 : keep(run, frame);
}
double keep_entry(Run& run, const FrameEntry& entry) { return keep(run, entry); }

std::optional<FrameValue> control_frame(const MotionState& state, const VariablePlace& place) {
  if (place.range == nullptr) return std::nullopt;
  if (place.kind == VariableKind::StoredFrame) return stored_frame(state, place.index);
  if (place.kind != VariableKind::FrameInForce) return std::nullopt;
  return frame_in_force(state, static_cast<FrameInForce>(place.index));
}

std::optional<double> read_frame(Run& run, const VariablePlace& place) {
  if (place.range == nullptr) return std::nullopt;
  const MotionState& state = run.motion.state();
  if (place.kind == VariableKind::FrameNumber) return frame_number(state);
  const auto frame = control_frame(state, place);
  return frame ? std::optional(keep_frame(run, *frame)) : std::nullopt;
}

bool write_frame(Run& run, const VariablePlace& place, double value, std::optional<Fault>& wrong) {
  FrameValue frame = frame_of(run, value);
  const std::string* const bytes = bytes_of(run, value);
  if (bytes != nullptr && bytes->size() == sizeof(FrameEntry)) {
    const auto now = control_frame(run.motion.state(), place);
    if (!now) return false;
    frame = *now;
    if (!set_part(frame, entry_of(run, value))) {
      wrong = Fault{.cause = Cause::CodeNotComputed,
                    .detail = "this part of a frame that shears is not computed"};
      return true;
    }
  }
  if (place.kind == VariableKind::StoredFrame)
    wrong = run.motion.set_stored_frame(place.index, frame);
  else if (place.kind == VariableKind::FrameInForce)
    wrong = run.motion.set_frame_in_force(static_cast<FrameInForce>(place.index), frame);
  else
    return false;
  return true;
}

}  // namespace cncsub
