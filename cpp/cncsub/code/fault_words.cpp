// Which word of its block a fault of the motion is about.
#include "cncsub/code/fault_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "cncsub/text/scan.hpp"
#include "cncsub/text/words.hpp"

namespace cncsub {
namespace {

struct FaultWords {
  Cause cause;
  /// The first of these that the block has: an address, or the G code of a group. Where a word is
  /// missing it is the code that needs it, and where that is in force from before, an axis.
  std::string_view words;
};

constexpr FaultWords kFaultWords[] = {
    {Cause::NoFeed, "F oneshot motion cycle axis"},
    {Cause::FeedOutOfRange, "F"},
    {Cause::ArcFeedZero, "F"},
    {Cause::SpindleStands, "oneshot motion cycle axis"},
    {Cause::NoSpeed, "S oneshot motion cycle axis"},
    {Cause::ThreadLead, "F I oneshot motion cycle axis"},
    {Cause::RadiusTolerance, "axis I J K motion"},
    {Cause::RadiusAndCentre, "R"},
    {Cause::NoRadius, "I J K motion axis"},
    {Cause::RadiusTooSmall, "R CR"},
    {Cause::NegativeRadius, "R CR"},
    {Cause::HelixTravel, "motion axis"},
    {Cause::NoArcTravel, "R CR"},
    {Cause::OverTravel, "axis motion oneshot cycle"},
    {Cause::LongerInCompensation, "oneshot"},
    {Cause::StrokeArea, "axis I J K stroke"},
    {Cause::StrokeWithCodes, "stroke"},
    {Cause::LongerArc, "oneshot motion"},
    {Cause::ThreePoints, "I K J motion axis"},
    {Cause::OneShotWithMotion, "oneshot"},
    {Cause::UnitChangeLate, "units"},
    {Cause::NotHomed, "oneshot work motion"},
    {Cause::ReferenceNotHomed, "oneshot"},
    {Cause::NotAtReference, "axis oneshot"},
    {Cause::NoIntermediate, "oneshot"},
    {Cause::ReferenceNumber, "P oneshot"},
    {Cause::ReferenceInCycle, "oneshot"},
    {Cause::ReferenceInRotation, "oneshot"},
    {Cause::ReferenceWithEnd, "M oneshot"},
    {Cause::MachineMoveInCycle, "oneshot"},
    {Cause::CoordinateSettingRefused, "oneshot"},
    {Cause::G10L, "L oneshot"},
    {Cause::G10P, "P oneshot"},
    {Cause::G10System, "P oneshot"},
    {Cause::G10Offset, "P oneshot"},
    {Cause::G10Word, "oneshot"},
    {Cause::G10Axis, "oneshot"},
    {Cause::G10Value, "oneshot"},
    {Cause::WorkSystem, "P work"},
    {Cause::OffsetNumber, "H T length"},
    {Cause::RadiusOffsetNumber, "D radius"},
    {Cause::LengthAxis, "length"},
    {Cause::LengthWithMotion, "length"},
    {Cause::LocalWithLength, "oneshot"},
    {Cause::LocalInExtraSystem, "oneshot"},
    {Cause::ToolWithSetting, "T"},
    {Cause::ReferenceWithM, "M oneshot"},
    {Cause::PolarTool, "T"},
    {Cause::PolarCycle, "cycle axis"},
    {Cause::PolarCorner, ",C ,R L C R"},
    {Cause::TurnedUnits, "units"},
    {Cause::TurnedWithCodes, "turn"},
    {Cause::TurnedMirror, "mirror"},
    {Cause::TurnedPlane, "plane"},
    {Cause::TurnedCoordinate, "oneshot"},
    {Cause::TurnedWorkSystem, "work oneshot"},
    {Cause::TurnedLength, "length"},
    {Cause::TurnedData, "oneshot"},
    {Cause::RotatedCycle, "turn"},
    {Cause::RotationCode, "oneshot radius work units macro stroke motion"},
    {Cause::PolarPlane, "plane"},
    {Cause::PolarWorkSystem, "work"},
    {Cause::PolarCentre, "I J K"},
    {Cause::RotationAngle, "R"},
    {Cause::RotationPlane, "plane"},
    {Cause::ScaleNegative, "P I J K"},
    {Cause::ScaleZero, "P I J K"},
    {Cause::TurnedInCompensation, "turn"},
    {Cause::CompensationArc, "motion axis I J K"},
    {Cause::CompensationEndArc, "motion axis I J K"},
    {Cause::CompensationEndMode, "radius"},
    {Cause::CompensationNoMove, "radius"},
    {Cause::CompensationPlane, "plane"},
    {Cause::CompensationWrongPlane, "radius"},
    {Cause::CompensationNoIntersection, "axis motion"},
    {Cause::CompensationInterference, "axis motion"},
    {Cause::CompensationArcTooSmall, "R CR I J K axis"},
    {Cause::CompensationArcStart, "I J K motion"},
    {Cause::CompensationArcEnd, "I J K axis motion"},
    {Cause::CompensationSkip, "oneshot"},
    {Cause::SkipPerRevolution, "oneshot"},
    {Cause::NoSkipFeed, "F oneshot"},
    {Cause::MeasuringMissed, "oneshot"},
    {Cause::MeasuringEarly, "oneshot"},
    {Cause::MeasuringOffset, "oneshot"},
    {Cause::MeasuringWithOffset, "H T"},
    {Cause::MeasuringAxis, "oneshot"},
    {Cause::MeasuringIncremental, "axis oneshot"},
    {Cause::MeasuringZone, "oneshot"},
    {Cause::MeasuringInCompensation, "oneshot"},
    {Cause::NoMeasuringFeed, "F oneshot"},
    {Cause::CompensationCycle, "cycle axis"},
    {Cause::NoPeck, "Q cycle motion axis"},
    {Cause::CycleRepeats, "K L"},
    {Cause::CycleRepeatsTwice, "L K"},
    {Cause::TapLead, "F cycle motion axis"},
    {Cause::RigidMove, "axis motion oneshot"},
    {Cause::DataEndFirst, "G"},
    {Cause::RigidSpeed, "S cycle motion axis"},
    {Cause::RigidCodeInCycle, "M cycle"},
    {Cause::RigidWordTwice, "M S"},
    {Cause::TapInSurfaceSpeed, "cycle axis"},
    {Cause::CycleAxisChanged, "plane cycle"},
    {Cause::TapSpeed, "S cycle motion axis"},
    {Cause::Taper, "R axis"},
    {Cause::FaceTaper, "R axis"},
    {Cause::PqMissing, "oneshot"},
    {Cause::PqNotFound, "P oneshot"},
    {Cause::PqSame, "Q"},
    {Cause::ProfileCall, "M oneshot macro"},
    {Cause::ProfileFirstBlock, "motion axis"},
    {Cause::ProfileNotMonotone, "axis motion"},
    {Cause::CycleDepth, "D oneshot"},
    {Cause::CycleEscape, "R oneshot"},
    {Cause::PatternPasses, "R oneshot"},
    {Cause::PatternX, "U oneshot"},
    {Cause::PatternZ, "W oneshot"},
    {Cause::ProfileTooLong, "Q"},
    {Cause::ProfilePockets, "oneshot"},
    {Cause::ProfileInMdi, "oneshot"},
    {Cause::ProfileStart, "oneshot"},
    {Cause::ProfileFirstX, "motion axis"},
    {Cause::ProfileFirstZ, "motion axis"},
    {Cause::PatternFirstBlock, "motion axis"},
    {Cause::CyclePlane, "oneshot"},
    {Cause::CycleAxis, "Y V"},
    {Cause::TurningPlane, "motion axis"},
    {Cause::TurningAxis, "Y V"},
    {Cause::GrooveAxis, "oneshot"},
    {Cause::GrooveQ, "Q oneshot"},
    {Cause::GrooveP, "P oneshot"},
    {Cause::GrooveRetract, "R oneshot"},
    {Cause::GrooveEscape, "R oneshot"},
    {Cause::ThreadHeight, "oneshot"},
    {Cause::ThreadRunOut, "K J oneshot motion axis"},
    {Cause::ThreadRunOutAcross, "J K motion axis"},
    {Cause::ThreadRunOutSign, "J K"},
    {Cause::ThreadHeightValue, "P K oneshot"},
    {Cause::ThreadCut, "Q D oneshot"},
    {Cause::ThreadLeastCut, "Q oneshot"},
    {Cause::ThreadAllowance, "R oneshot"},
    {Cause::ThreadPasses, "P oneshot"},
    {Cause::ThreadTravel, "axis oneshot"},
    {Cause::ThreadTaper, "R I oneshot"},
    {Cause::ThreadSteep, "R I oneshot"},
    {Cause::CornerTooShort, ",C ,R L C R I K axis"},
    {Cause::CornerNextShort, "axis motion"},
    {Cause::CornerCodes, "length work oneshot H"},
    {Cause::CornerNextMove, "motion axis"},
    {Cause::CornerInRapid, ",C ,R L C R"},
    {Cause::CornerPlane, "plane"},
    {Cause::CornerTaper, "I K"},
    {Cause::CornerOffset, ",C ,R L C R"},
    {Cause::CornerHelix, ",C ,R L U C"},
    {Cause::AngleEnd, "axis ,A A"},
    {Cause::AngleParallel, ",A A Q axis"},
    {Cause::AngleNoEnd, ",A A Q"},
    {Cause::CornerFormat, ",R R U K"},
    {Cause::AddressNotUsable, ",A"},
};

constexpr std::pair<std::string_view, std::array<Group, 3>> kGroupNames[] = {
    {"oneshot", {Group::OneShot, Group::OneShot, Group::OneShot}},
    {"motion", {Group::Motion, Group::Motion, Group::Motion}},
    {"cycle", {Group::Cycle, Group::Cycle, Group::Cycle}},
    {"plane", {Group::Plane, Group::Plane, Group::Plane}},
    {"stroke", {Group::Stroke, Group::Stroke, Group::Stroke}},
    {"units", {Group::Units, Group::Units, Group::Units}},
    {"radius", {Group::Radius, Group::Radius, Group::Radius}},
    {"length", {Group::Length, Group::Length, Group::Length}},
    {"work", {Group::Work, Group::Work, Group::Work}},
    {"macro", {Group::Macro, Group::Macro, Group::Macro}},
    {"turn", {Group::Rotation, Group::Scaling, Group::Mirror}},
    {"mirror", {Group::Mirror, Group::Mirror, Group::Mirror}},
};

struct Finder {
  const std::vector<WrittenWord>& words;
  const GCodes& codes;

  const WrittenWord* address(std::string_view name) const {
    for (const WrittenWord& word : words)
      if (word.address == name) return &word;
    return nullptr;
  }
  const WrittenWord* axis() const {
    for (const WrittenWord& word : words)
      if (word.address.size() == 1 &&
          std::string_view("XYZUVWABCH").find(word.address[0]) != std::string_view::npos)
        return &word;
    return nullptr;
  }
  const WrittenWord* code(int tenfold) const {
    for (const WrittenWord& word : words)
      if (word.address == "G" && (!word.known || std::lround(word.value * 10) == tenfold))
        return &word;
    return nullptr;
  }
  const WrittenWord* group(const std::array<Group, 3>& groups) const {
    for (const WrittenWord& word : words) {
      if (word.address != "G" || !word.known || std::fabs(word.value) > 1000) continue;
      const GCode found = codes.find(static_cast<int>(std::lround(word.value * 10)));
      if (found.meaning <= Meaning::Uncomputed || found.meaning == Meaning::Unknown) continue;
      for (const Group of : groups)
        if (found.group == of) return &word;
    }
    return nullptr;
  }
  /// A name of kFaultWords.
  const WrittenWord* named(std::string_view name) const {
    if (name == "axis") return axis();
    for (const auto& [text, groups] : kGroupNames)
      if (text == name) return group(groups);
    return address(name);
  }
  /// The word of an address; a comma may stand before it, and increments have letters of their own.
  const WrittenWord* address_or_like(char name) const {
    if (const WrittenWord* word = address({&name, 1})) return word;
    if (const WrittenWord* word = address(std::string(",") + name)) return word;
    constexpr std::string_view kAxes = "XYZC", kIncrements = "UVWH";
    const std::size_t axis = kAxes.find(name);
    return axis == std::string_view::npos ? nullptr : address(kIncrements.substr(axis, 1));
  }
  /// A G code, or what stands first.
  const WrittenWord* first() const {
    if (const WrittenWord* g = address("G")) return g;
    for (const WrittenWord& word : words)
      if (word.address != "N" && word.address != "/" && word.address != "O") return &word;
    return nullptr;
  }
};

}  // namespace

void point_at_word(const GCodes& codes, const std::vector<WrittenWord>& words, std::uint32_t text,
                   Fault& fault) {
  const Finder find{words, codes};
  const WrittenWord* word = fault.code >= 0      ? find.code(fault.code)
                            : fault.address != 0 ? find.address_or_like(fault.address)
                                                 : nullptr;
  for (const FaultWords& entry : kFaultWords) {
    if (word != nullptr) break;
    if (entry.cause != fault.cause) continue;
    std::string_view rest = entry.words;
    while (!rest.empty() && word == nullptr) {
      const std::size_t blank = std::min(rest.find(' '), rest.size());
      word = find.named(rest.substr(0, blank));
      rest.remove_prefix(std::min(blank + 1, rest.size()));
    }
  }
  if (word == nullptr) word = find.first();
  fault.at = text + (word == nullptr ? 0 : word->at);
  const std::uint32_t all = words.empty() ? 1 : words.back().at + words.back().width;
  fault.width = word == nullptr ? all : word->width;
}

std::vector<std::string_view> causes_with_words() {
  std::vector<std::string_view> slugs;
  for (const FaultWords& entry : kFaultWords) slugs.push_back(info(entry.cause).slug);
  return slugs;
}

}  // namespace cncsub
