// What a G code means on a machine: the tables of mills and lathes, and what a control changes in
// them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control/control.hpp"

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
  Count
};
constexpr std::size_t kGroups = static_cast<std::size_t>(Group::Count);

// clang-format off
#define CNCSUB_MEANINGS(M) \
  M(None) M(Unknown) M(Neutral) M(DataEnd) M(Uncomputed) M(Ignored) M(Dwell) M(ExactStop) M(SetData) M(CheckReference) M(Reference) \
  M(FromReference) M(SecondReference) M(Skip) M(MeasureTool) M(Local) M(Machine) M(SetCoordinate) \
  M(ClearCoordinate) M(Lengthen) M(Shorten) M(LengthenTwice) M(ShortenTwice) M(OneWay) M(Finish) M(RoughTurn) M(RoughFace) M(RoughPattern) M(PeckFace) \
  M(PeckTurn) M(MultipleThread) M(Rapid) M(Line) M(Cw) M(Ccw) M(Thread) M(VariableThread) \
  M(TurnCycle) M(ThreadCycle) M(FaceCycle) M(TapCycle) M(ThreePoints) M(ThreePointsAbsolute) M(PlaneXY) M(PlaneZX) M(PlaneYZ) \
  M(Absolute) M(Incremental) M(StrokeOn) M(StrokeOff) M(PerMinute) M(PerRevolution) \
  M(InverseTime) M(Inch) M(Metric) M(Pulses) M(RadiusOff) M(RadiusLeft) M(RadiusRight) \
  M(LengthPlus) M(LengthMinus) M(LengthOff) M(PeckFast) M(LeftTap) M(FineBore) M(CycleOff) \
  M(Drill) M(DrillDwell) M(Peck) M(Tap) M(Bore) M(BoreStop) M(BackBore) M(BoreManual) \
  M(BoreDwell) M(ReturnInitial) M(ReturnR) M(ScalingOn) M(ScalingOff) M(MacroOn) \
  M(MacroOff) M(SurfaceSpeed) M(SpindleSpeed) M(Work1) M(Work2) M(Work3) M(Work4) M(Work5) \
  M(Work6) M(WorkExtra) M(PathExact) M(PathCorner) M(PathTap) M(PathCut) M(RotationOn) \
  M(RotationOff) M(PolarOn) M(PolarOff) M(MirrorOn) M(MirrorOff)
// clang-format on

enum class Meaning : std::uint8_t {
#define CNCSUB_MEANING(name) name,
  CNCSUB_MEANINGS(CNCSUB_MEANING)
#undef CNCSUB_MEANING
};

struct GCode {
  std::int16_t code = -1;  // ten times the number
  Group group = Group::OneShot;
  Meaning meaning = Meaning::None;
  std::int16_t system = 0;  // the extra work system that the code itself names, 0 = P does
};

/// Whether no path depends on a code. G11 ends data, which alarms where none were begun.
inline bool is_neutral(Meaning meaning) {
  return meaning == Meaning::Neutral || meaning == Meaning::DataEnd;
}

/// "G54.1" of 541.
std::string code_name(int code);

class GCodes {
 public:
  GCodes(const Control& control, MachineType machine);
  /// The meaning of a code times ten: None where the machine does not have it, Neutral where no
  /// path depends on it, Uncomputed where the engine does not know its moves, Unknown where no
  /// source says whether the control has it.
  GCode find(int code) const {
    const std::size_t place =
        code >= 0 && code < kCodes ? places_[static_cast<std::size_t>(code)] : 0;
    return place == 0 ? GCode{-1, Group::OneShot, unlisted_} : codes_[place - 1];
  }
  /// The code of a meaning as this machine writes it; code -1 where it has none.
  GCode of(Meaning meaning) const;

 private:
  void set(GCode entry);
  void keep(const Codes& list, bool complete);
  void change(std::string_view text);

  static constexpr int kCodes = 10001;  // ten times the largest, and one

  std::vector<GCode> codes_;
  std::vector<std::uint16_t> places_;  // of a code there, from 1
  Meaning unlisted_ = Meaning::Unknown;
};

}  // namespace cncsub
