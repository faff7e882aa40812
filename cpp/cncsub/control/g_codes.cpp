#include "cncsub/control/g_codes.hpp"

#include <algorithm>

namespace cncsub {
namespace {

using G = Group;
using M = Meaning;

// [general knowledge: FANUC's names, which the others share where a control's rules do not say
// otherwise]
constexpr GCode kShared[] = {
    {40, G::OneShot, M::Dwell},
    {50, G::OneShot, M::Neutral},
    {51, G::OneShot, M::Ignored},
    {80, G::OneShot, M::Neutral},
    {90, G::OneShot, M::ExactStop},
    {100, G::OneShot, M::SetData},
    {110, G::OneShot, M::DataEnd},
    {270, G::OneShot, M::CheckReference},
    {280, G::OneShot, M::Reference},
    {290, G::OneShot, M::FromReference},
    {300, G::OneShot, M::SecondReference},
    {310, G::OneShot, M::Skip},
    {390, G::OneShot, M::Uncomputed},
    {520, G::OneShot, M::Local},
    {530, G::OneShot, M::Machine},
    {600, G::OneShot, M::OneWay},
    {650, G::OneShot, M::Ignored},
    {0, G::Motion, M::Rapid},
    {10, G::Motion, M::Line},
    {20, G::Motion, M::Cw},
    {30, G::Motion, M::Ccw},
    {170, G::Plane, M::PlaneXY},
    {180, G::Plane, M::PlaneZX},
    {190, G::Plane, M::PlaneYZ},
    {220, G::Stroke, M::StrokeOn},
    {230, G::Stroke, M::StrokeOff},
    {250, G::Fluctuation, M::Ignored},
    {260, G::Fluctuation, M::Ignored},
    {121, G::PolarMilling, M::Uncomputed},
    {131, G::PolarMilling, M::Ignored},
    {490, G::Length, M::LengthOff},
    {610, G::Path, M::PathExact},
    {620, G::Path, M::PathCorner},
    {630, G::Path, M::PathTap},
    {640, G::Path, M::PathCut},
    {150, G::Polar, M::PolarOff},
    {501, G::Mirror, M::MirrorOff},
    {400, G::Radius, M::RadiusOff},
    {410, G::Radius, M::RadiusLeft},
    {420, G::Radius, M::RadiusRight},
    {660, G::Macro, M::MacroOn},
    {661, G::Macro, M::MacroOn},
    {670, G::Macro, M::MacroOff},
    {960, G::Surface, M::SurfaceSpeed},
    {970, G::Surface, M::SpindleSpeed},
    {540, G::Work, M::Work1},
    {550, G::Work, M::Work2},
    {560, G::Work, M::Work3},
    {570, G::Work, M::Work4},
    {580, G::Work, M::Work5},
    {590, G::Work, M::Work6},
    {541, G::Work, M::WorkExtra},
    {800, G::Cycle, M::CycleOff},
    {200, G::Units, M::Inch},
    {210, G::Units, M::Metric},
};

constexpr GCode kMill[] = {
    {360, G::OneShot, M::Uncomputed},
    {370, G::OneShot, M::MeasureTool},
    {330, G::Motion, M::Thread},
    {900, G::Distance, M::Absolute},
    {910, G::Distance, M::Incremental},
    {930, G::Feed, M::InverseTime},
    {940, G::Feed, M::PerMinute},
    {950, G::Feed, M::PerRevolution},
    {430, G::Length, M::LengthPlus},
    {440, G::Length, M::LengthMinus},
    {730, G::Cycle, M::PeckFast},
    {740, G::Cycle, M::LeftTap},
    {760, G::Cycle, M::FineBore},
    {810, G::Cycle, M::Drill},
    {820, G::Cycle, M::DrillDwell},
    {830, G::Cycle, M::Peck},
    {840, G::Cycle, M::Tap},
    {850, G::Cycle, M::Bore},
    {860, G::Cycle, M::BoreStop},
    {870, G::Cycle, M::BackBore},
    {880, G::Cycle, M::BoreManual},
    {890, G::Cycle, M::BoreDwell},
    {980, G::Return, M::ReturnInitial},
    {990, G::Return, M::ReturnR},
    {500, G::Scaling, M::ScalingOff},
    {510, G::Scaling, M::ScalingOn},
    {680, G::Rotation, M::RotationOn},
    {690, G::Rotation, M::RotationOff},
    {160, G::Polar, M::PolarOn},
    {511, G::Mirror, M::MirrorOn},
    {920, G::OneShot, M::SetCoordinate},
    {921, G::OneShot, M::ClearCoordinate},
    {450, G::OneShot, M::Lengthen},
    {460, G::OneShot, M::Shorten},
    {470, G::OneShot, M::LengthenTwice},
    {480, G::OneShot, M::ShortenTwice},
};

constexpr GCode kLathe[] = {
    {360, G::OneShot, M::MeasureTool, 1},
    {370, G::OneShot, M::MeasureTool},
    {340, G::Motion, M::VariableThread},
    {700, G::OneShot, M::Finish},
    {710, G::OneShot, M::RoughTurn},
    {720, G::OneShot, M::RoughFace},
    {730, G::OneShot, M::RoughPattern},
    {740, G::OneShot, M::PeckFace},
    {750, G::OneShot, M::PeckTurn},
    {760, G::OneShot, M::MultipleThread},
    {830, G::Cycle, M::Peck},
    {840, G::Cycle, M::Tap},
    {850, G::Cycle, M::Bore},
    {870, G::Cycle, M::Peck, 1},
    {880, G::Cycle, M::Tap, 1},
    {890, G::Cycle, M::Bore, 1},
    {680, G::Turret, M::Uncomputed},
    {690, G::Turret, M::Ignored},
    {681, G::Rotation, M::RotationOn},
    {691, G::Rotation, M::RotationOff},
};

constexpr GCode kLatheA[] = {
    {320, G::Motion, M::Thread},         {900, G::Motion, M::TurnCycle},
    {920, G::Motion, M::ThreadCycle},    {940, G::Motion, M::FaceCycle},
    {500, G::OneShot, M::SetCoordinate}, {980, G::Feed, M::PerMinute},
    {990, G::Feed, M::PerRevolution},    {503, G::OneShot, M::ClearCoordinate},
};

constexpr GCode kLatheB[] = {
    {330, G::Motion, M::Thread},         {770, G::Motion, M::TurnCycle},
    {780, G::Motion, M::ThreadCycle},    {790, G::Motion, M::FaceCycle},
    {920, G::OneShot, M::SetCoordinate}, {921, G::OneShot, M::ClearCoordinate},
    {900, G::Distance, M::Absolute},     {910, G::Distance, M::Incremental},
    {940, G::Feed, M::PerMinute},        {950, G::Feed, M::PerRevolution},
    {980, G::Return, M::ReturnInitial},  {990, G::Return, M::ReturnR},
};

/// Codes of a control's list that no path depends on: servo and look-ahead modes, spindles, and the
/// ends of modes whose beginnings the engine does not compute. General knowledge of the makers'
/// lists. Every other code without an entry is not computed.
constexpr int kNeutral[] = {54,   401,  502,  504,  505,  506,  512,  611, 631,
                            632,  691,  804,  805,  961,  962,  963,  964, 1130,
                            1141, 1142, 1143, 1201, 1500, 1600, 2500, 2510};

}  // namespace

std::string code_name(int code) {
  if (const std::string_view word = word_of_code(code); !word.empty()) return std::string(word);
  std::string name = code < 100 ? "G0" : "G";
  name += std::to_string(code / 10);
  if (code % 10 != 0) name += "." + std::to_string(code % 10);
  return name;
}

GCodes::GCodes(const Control& control, MachineType machine) : places_(kCodes) {
  const auto add = [this](const auto& list) {
    for (const GCode& entry : list) set(entry);
  };
  if (!control.reading.g_codes.value.empty())
    for (const int code : kNeutral) set({static_cast<std::int16_t>(code), G::OneShot, M::Neutral});
  add(kShared);
  if (machine == MachineType::Mill)
    add(kMill);
  else
    add(kLathe);
  if (machine == MachineType::LatheA) add(kLatheA);
  if (machine == MachineType::LatheB) add(kLatheB);
  if (!control.reading.g_codes.value.empty())
    keep(control.reading.g_codes.value,
         control.reading.unlisted_codes.value == UnlistedCode::Refused);
  name_systems(control);
  const Roles& roles = control.calls.roles.value;
  if (!roles.has(Role::MacroCall))
    for (const std::int16_t code : {650, 660, 661, 670}) set({code, G::OneShot, M::None});
  if (!roles.has(Role::ModalCall))
    for (const std::int16_t code : {660, 661, 670}) set({code, G::OneShot, M::None});
  for (GCode entry : control.motion.g_meanings.value) {
    if (entry.meaning == M::Skip && entry.variant == 0)
      entry.variant = static_cast<std::int16_t>(entry.code % 10);
    if (const GCode own = find(entry.code); own.meaning == entry.meaning && entry.variant == 0)
      entry.variant = own.variant;
    set(entry);
  }
}

/// Let codes name the extra work systems, by the number from which they count.
void GCodes::name_systems(const Control& control) {
  const int first = control.motion.extra_system_codes.value;
  if (first <= 0) return;
  control.reading.g_codes.value.for_each([&](int code10) {
    const int system = code10 / 10 - first;
    if (code10 % 10 == 0 && system > 0 && system <= control.motion.max_extra_systems.value)
      set({static_cast<std::int16_t>(code10), Group::Work, Meaning::WorkExtra,
           static_cast<std::int16_t>(system)});
  });
}

/// Keep what the family's tables say of the control's own codes, and nothing about others. A code
/// of the control that no table of its kind of machine knows is not computed: it would not alarm
/// there.
void GCodes::keep(const Codes& list, bool complete) {
  std::vector<GCode> kept;
  list.for_each([&](int code10) {
    const GCode entry = find(code10);
    const auto code = static_cast<std::int16_t>(code10);
    kept.push_back(entry.code >= 0 ? entry : GCode{code, G::OneShot, M::Uncomputed});
  });
  codes_.clear();
  std::fill(places_.begin(), places_.end(), std::uint16_t{0});
  for (const GCode& entry : kept) set(entry);
  if (complete) unlisted_ = M::None;
}

void GCodes::set(GCode entry) {
  if (entry.code < 0 || entry.code >= kCodes) return;
  std::uint16_t& place = places_[static_cast<std::size_t>(entry.code)];
  if (place == 0) {
    codes_.push_back(entry);
    place = static_cast<std::uint16_t>(codes_.size());
  }
  codes_[place - 1U] = entry;
}

GCode GCodes::of(Meaning meaning) const {
  GCode lowest;
  for (const GCode& entry : codes_)
    if (entry.meaning == meaning && (lowest.code < 0 || entry.code < lowest.code)) lowest = entry;
  return lowest;
}

GCode GCodes::of(Meaning meaning, std::int16_t variant) const {
  const auto found = std::find_if(codes_.begin(), codes_.end(), [&](const GCode& entry) {
    return entry.meaning == meaning && entry.variant == variant;
  });
  return found == codes_.end() ? GCode{} : *found;
}

MachineType machine_of(const Control& control, const std::string& name) {
  const auto& names = options<MachineType>();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i].slug == name) return static_cast<MachineType>(i);
  return control.motion.machine.value;
}

}  // namespace cncsub
