// The lists of a control's motion: what its G codes mean, the numbers of their groups, the words of
// corners.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "cncsub/control/codes.hpp"
#include "cncsub/control/list.hpp"

namespace cncsub {

enum class Group : std::uint8_t {
  OneShot,
  Motion,
  Plane,
  Distance,
  Stroke,
  Feed,
  Units,
  Radius,
  Length,
  Cycle,
  Return,
  Scaling,
  Macro,
  Surface,
  Work,
  Path,
  Rotation,
  Polar,
  Mirror,
  Turret,
  Fluctuation,
  PolarMilling,
  Centre,
  Diameter,
  Corner,
  Count
};
constexpr std::size_t kGroups = static_cast<std::size_t>(Group::Count);

enum class Meaning : std::uint8_t {
#define MEANING(name, does, words, causes) name,
#include "cncsub/control/meanings.def"
#undef MEANING
};

struct GCode {
  std::int16_t code = -1;  // ten times the number
  Group group = Group::OneShot;
  Meaning meaning = Meaning::None;
  std::int16_t variant = 0;  // of several codes of one meaning: the extra work system that the code
                             // names (0: P does), the form of G31 (1: G31.1), the axis of a lathe's
                             // cycle or of its measuring (1: X, 0: Z), units of lengths alone (1)

  bool operator==(const GCode&) const = default;
};

/// The variant of a skip that is a word beside the line that G01 makes.
inline constexpr std::int16_t kSkipOnLine = 4;
/// The variant of units of lengths alone: F counts in those that hold at power-on.
inline constexpr std::int16_t kLengthsAlone = 1;

/// The variant of a code whose H names the extra work system, not its P.
inline constexpr std::int16_t kNamedByH = -1;

/// A meaning that a control may give to another code: the words of the rule g_meanings.
struct MeaningWord {
  std::string_view word;
  Group group;
  Meaning meaning;
  std::int16_t variant = 0;
};
inline constexpr MeaningWord kMeaningWords[] = {
    {"ignored", Group::OneShot, Meaning::Ignored},
    {"inch", Group::Units, Meaning::Inch},
    {"metric", Group::Units, Meaning::Metric},
    {"inch-lengths", Group::Units, Meaning::Inch, kLengthsAlone},
    {"metric-lengths", Group::Units, Meaning::Metric, kLengthsAlone},
    {"pulses", Group::Units, Meaning::Pulses},
    {"mirror", Group::Mirror, Meaning::MirrorOn},
    {"mirror-off", Group::Mirror, Meaning::MirrorOff},
    {"radius-left-given", Group::Radius, Meaning::RadiusLeft, 1},
    {"radius-right-given", Group::Radius, Meaning::RadiusRight, 1},
    {"shift", Group::OneShot, Meaning::SetShift},
    {"clear-shift", Group::OneShot, Meaning::ClearShift},
    {"suspend-shift", Group::OneShot, Meaning::SuspendShift},
    {"restore-shift", Group::OneShot, Meaning::RestoreShift},
    {"reference-all", Group::OneShot, Meaning::Reference, 1},
    {"second-reference-all", Group::OneShot, Meaning::SecondReference, 1},
    {"length", Group::Length, Meaning::LengthPlus},
    {"length-off", Group::Length, Meaning::LengthOff},
    {"length-given", Group::Length, Meaning::LengthPlus, 1},
    {"length-added", Group::Length, Meaning::LengthPlus, 2},
    {"store-reference", Group::OneShot, Meaning::StoreReference, 1},
    {"store-reference-2", Group::OneShot, Meaning::StoreReference, 2},
    {"tap-cycle", Group::Motion, Meaning::TapCycle},
    {"thread", Group::Motion, Meaning::Thread},
    {"thread-by-k", Group::Motion, Meaning::Thread, 1},
    {"thread-by-axis", Group::Motion, Meaning::Thread, 3},
    {"thread-growing", Group::Motion, Meaning::Thread, 4},
    {"thread-shrinking", Group::Motion, Meaning::Thread, 5},
    {"rigid-tap", Group::Motion, Meaning::Thread, 2},
    {"rotation", Group::Rotation, Meaning::RotationOn},
    {"rotation-off", Group::Rotation, Meaning::RotationOff},
    {"dwell", Group::OneShot, Meaning::Dwell},
    {"skip", Group::OneShot, Meaning::Skip},
    {"skip-on-line", Group::OneShot, Meaning::Skip, kSkipOnLine},
    {"probe", Group::Motion, Meaning::Skip},
    {"spline", Group::Motion, Meaning::Spline},
    {"spline-by-one-point", Group::Motion, Meaning::Spline, 1},
    {"drive-line-thread", Group::Motion, Meaning::DriveLineThread},
    {"tapping", Group::OneShot, Meaning::Tapping},
    {"tangent-arc", Group::Motion, Meaning::TangentArc},
    {"position-axes", Group::OneShot, Meaning::PositionAxes},
    {"surface-speed", Group::Surface, Meaning::SurfaceSpeed},
    {"surface-speed-per-revolution", Group::Surface, Meaning::SurfaceSpeed, 1},
    {"surface-speed-per-minute", Group::Surface, Meaning::SurfaceSpeed, 2},
    {"spindle-speed", Group::Surface, Meaning::SpindleSpeed},
    {"spindle-speed-per-revolution", Group::Surface, Meaning::SpindleSpeed, 1},
    {"spindle-speed-per-minute", Group::Surface, Meaning::SpindleSpeed, 2},
    {"frame-shift", Group::OneShot, Meaning::FrameShift},
    {"frame-shift-added", Group::OneShot, Meaning::FrameShift, 1},
    {"frame-shift-by-axis", Group::OneShot, Meaning::FrameShiftByAxis},
    {"frame-fine-shift-by-axis", Group::OneShot, Meaning::FrameShiftByAxis, 1},
    {"frame-rotation", Group::OneShot, Meaning::FrameRotation},
    {"frame-rotation-added", Group::OneShot, Meaning::FrameRotation, 1},
    {"frame-scale", Group::OneShot, Meaning::FrameScale},
    {"frame-scale-added", Group::OneShot, Meaning::FrameScale, 1},
    {"frame-mirror", Group::OneShot, Meaning::FrameMirror},
    {"frame-mirror-added", Group::OneShot, Meaning::FrameMirror, 1},
    {"machine", Group::OneShot, Meaning::Machine},
    {"machine-all", Group::OneShot, Meaning::Machine, 1},
    {"pole-from-tool", Group::OneShot, Meaning::Pole, 1},
    {"pole", Group::OneShot, Meaning::Pole, 2},
    {"pole-from-pole", Group::OneShot, Meaning::Pole, 3},
    {"corner-arc", Group::Corner, Meaning::CornerArc},
    {"corner-meet", Group::Corner, Meaning::CornerMeet},
    {"reference-direct", Group::OneShot, Meaning::Reference, 2},
    {"second-reference-direct", Group::OneShot, Meaning::SecondReference, 2},
    {"bore-stop-after-dwell", Group::Cycle, Meaning::BoreManual},
    {"centre-absolute", Group::Centre, Meaning::CentreAbsolute},
    {"centre-from-start", Group::Centre, Meaning::CentreFromStart},
    {"diameter", Group::Diameter, Meaning::DiameterOn},
    {"diameter-off", Group::Diameter, Meaning::DiameterOff},
    {"measuring", Group::OneShot, Meaning::MeasureTool},
    {"per-minute", Group::Feed, Meaning::PerMinute},
    {"per-revolution", Group::Feed, Meaning::PerRevolution},
    {"neutral", Group::OneShot, Meaning::Neutral},
    {"look-ahead-limit", Group::OneShot, Meaning::LookAheadLimit},
    {"data-end", Group::OneShot, Meaning::DataEnd},
    {"not-computed", Group::OneShot, Meaning::Uncomputed},
    {"three-points", Group::Motion, Meaning::ThreePoints},
    {"three-points-absolute", Group::Motion, Meaning::ThreePointsAbsolute},
    {"three-points-by-mode", Group::Motion, Meaning::ThreePointsAbsolute, 1},
    {"extra-system", Group::Work, Meaning::WorkExtra},
    {"extra-system-by-h", Group::Work, Meaning::WorkExtra, kNamedByH},
    {"extra-system-1", Group::Work, Meaning::WorkExtra, 1},
    {"extra-system-2", Group::Work, Meaning::WorkExtra, 2},
    {"extra-system-3", Group::Work, Meaning::WorkExtra, 3},
    {"extra-system-4", Group::Work, Meaning::WorkExtra, 4},
    {"extra-system-5", Group::Work, Meaning::WorkExtra, 5},
    {"extra-system-6", Group::Work, Meaning::WorkExtra, 6},
    {"extra-system-7", Group::Work, Meaning::WorkExtra, 7},
    {"extra-system-8", Group::Work, Meaning::WorkExtra, 8},
    {"extra-system-9", Group::Work, Meaning::WorkExtra, 9},
    {"extra-system-10", Group::Work, Meaning::WorkExtra, 10},
    {"extra-system-11", Group::Work, Meaning::WorkExtra, 11},
    {"extra-system-12", Group::Work, Meaning::WorkExtra, 12},
    {"extra-system-13", Group::Work, Meaning::WorkExtra, 13},
    {"extra-system-14", Group::Work, Meaning::WorkExtra, 14},
    {"extra-system-15", Group::Work, Meaning::WorkExtra, 15},
    {"extra-system-16", Group::Work, Meaning::WorkExtra, 16},
    {"extra-system-17", Group::Work, Meaning::WorkExtra, 17},
    {"extra-system-18", Group::Work, Meaning::WorkExtra, 18},
    {"extra-system-19", Group::Work, Meaning::WorkExtra, 19},
    {"extra-system-20", Group::Work, Meaning::WorkExtra, 20},
    {"extra-system-100", Group::Work, Meaning::WorkExtra, 100},
    {"none", Group::OneShot, Meaning::None},
    {"unknown", Group::OneShot, Meaning::Unknown},
};

/// An entry as `68.2=neutral`.
struct MeaningEntry {
  using Entry = GCode;
  static constexpr std::size_t kMost = 128;
  static constexpr std::optional<GCode> read(std::string_view text) {
    const auto equals = std::min(text.find('='), text.size());
    const auto code = read_code(text.substr(0, equals));
    if (!code || equals == text.size()) return std::nullopt;
    for (const MeaningWord& known : kMeaningWords)
      if (known.word == text.substr(equals + 1))
        return GCode{static_cast<std::int16_t>(*code), known.group, known.meaning, known.variant};
    return std::nullopt;
  }
  static constexpr bool same(const GCode& a, const GCode& b) { return a.code == b.code; }
  static std::string text(const GCode& entry);
  static std::string wrong(std::string_view text);
};

/// The name of a group of G codes, and its number on mills and lathes.
struct GroupName {
  std::string_view name;
  Group group;
  int mill, lathe;  // #4000 + this
};

// [REG; general knowledge of lathes]
inline constexpr GroupName kGroupNames[] = {
    {"motion", Group::Motion, 1, 1},
    {"plane", Group::Plane, 2, 16},
    {"distance", Group::Distance, 3, 3},
    {"stroke", Group::Stroke, 4, 9},
    {"feed", Group::Feed, 5, 5},
    {"units", Group::Units, 6, 6},
    {"radius", Group::Radius, 7, 7},
    {"length", Group::Length, 8, 0},
    {"cycle", Group::Cycle, 9, 10},
    {"return", Group::Return, 10, 11},
    {"scaling", Group::Scaling, 11, 0},
    {"macro", Group::Macro, 12, 12},
    {"surface", Group::Surface, 13, 2},
    {"work", Group::Work, 14, 14},
    {"path", Group::Path, 15, 0},
    {"rotation", Group::Rotation, 16, 0},
    {"polar", Group::Polar, 17, 0},
    {"mirror", Group::Mirror, 22, 0},
    {"turret", Group::Turret, 0, 4},
    {"fluctuation", Group::Fluctuation, 0, 8},
    {"polar-milling", Group::PolarMilling, 0, 21},
    {"centre", Group::Centre, 0, 0},
    {"diameter", Group::Diameter, 0, 0},
    {"corner", Group::Corner, 0, 0},
};

/// An entry as `plane=2`.
struct GroupEntry {
  struct Entry {
    Group group{};
    std::uint8_t number = 0;  // #4000 + this
    bool operator==(const Entry&) const = default;
  };
  static constexpr std::size_t kMost = std::size(kGroupNames);
  static constexpr std::optional<Entry> read(std::string_view text) {
    const auto equals = std::min(text.find('='), text.size());
    const std::string_view digits = text.substr(std::min(equals + 1, text.size()));
    if (digits.empty() || digits.find_first_not_of("0123456789") != std::string_view::npos)
      return std::nullopt;
    int number = 0;
    for (const char digit : digits) number = std::min(number * 10 + (digit - '0'), 100);
    for (const GroupName& known : kGroupNames)
      if (known.name == text.substr(0, equals) && number < 100)
        return Entry{known.group, static_cast<std::uint8_t>(number)};
    return std::nullopt;
  }
  static constexpr bool same(const Entry& a, const Entry& b) { return a.group == b.group; }
  static std::string text(const Entry& entry);
  static std::string wrong(std::string_view text);
};

/// An entry as `C`, or `,C` with the comma in front of it.
struct CornerEntry {
  struct Entry {
    bool comma = false;
    char letter = 0;
    bool operator==(const Entry&) const = default;
  };
  static constexpr std::size_t kMost = 52;
  static constexpr std::optional<Entry> read(std::string_view text) {
    const bool comma = text.starts_with(',');
    if (comma) text.remove_prefix(1);
    if (text.size() != 1 || text[0] < 'A' || text[0] > 'Z') return std::nullopt;
    return Entry{comma, text[0]};
  }
  static constexpr bool same(const Entry& a, const Entry& b) { return a == b; }
  static std::string text(const Entry& entry) {
    return std::string(entry.comma ? "," : "") + entry.letter;
  }
  static std::string wrong(std::string_view text);
};

using Meanings = List<MeaningEntry>;
using GroupNumbers = List<GroupEntry>;
using CornerLetters = List<CornerEntry>;

}  // namespace cncsub
