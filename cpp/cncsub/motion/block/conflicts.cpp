// Conflicts: a block's codes and words with each other, or with the state that they
// meet. Each conflict is a cause; a control refuses those that its rule `refuses` names.
#include <algorithm>
#include <bit>

#include "cncsub/motion/block/block.hpp"
#include "cncsub/motion/frame/frame.hpp"
#include "cncsub/motion/state/modes.hpp"

namespace cncsub {
namespace {

using State = MotionState;
using Block = BlockWords;

bool does(const Block& b, Meaning meaning) { return b.meaning(Group::OneShot) == meaning; }
bool turns(const Block& b) {
  return b.has(Group::Rotation) || b.has(Group::Scaling) || b.has(Group::Mirror);
}
bool begins_turn(const Block& b) {
  return b.meaning(Group::Rotation) == Meaning::RotationOn ||
         b.meaning(Group::Scaling) == Meaning::ScalingOn ||
         b.meaning(Group::Mirror) == Meaning::MirrorOn;
}
/// Return whether a canned cycle is active and neither a motion code nor G80 of the block ends it.
/// Either ends it first, wherever it stands. [15iM; M7 p.52]
bool in_cycle(const Block& b) {
  return b.was_cycle && !b.has(Group::Motion) && b.meaning(Group::Cycle) != Meaning::CycleOff;
}
bool cycles(const Block& b) {
  return b.has(Group::Cycle) && b.meaning(Group::Cycle) != Meaning::CycleOff;
}
bool returns(const Block& b) {
  return does(b, Meaning::Reference) || does(b, Meaning::SecondReference) ||
         does(b, Meaning::FromReference);
}
bool length(const Block& b) { return b.has(Group::Length) || b.words.has('H'); }
/// Return the motion code that holds for the block.
Meaning motion(const State& s, const Block& b) {
  return b.has(Group::Motion) ? b.meaning(Group::Motion) : s.modal[at(Group::Motion)].meaning;
}
Plane plane(const State& s, const Block& b) {
  return b.has(Group::Plane) ? plane_of(b.meaning(Group::Plane)) : s.plane;
}
/// Return whether a block has G70 to G76 of lathes.
bool repeats_cuts(const Block& b) {
  const Meaning once = b.meaning(Group::OneShot);
  return once >= Meaning::Finish && once <= Meaning::MultipleThread;
}
/// Return whether G90, G92 or G94 of lathes cuts, whatever they are called.
bool turning(const State& s, const Block& b) {
  const Meaning m = motion(s, b);
  return !b.has(Group::OneShot) &&
         (m == Meaning::TurnCycle || m == Meaning::ThreadCycle || m == Meaning::FaceCycle);
}
bool names_xz(const Block& b) {
  return b.words.has('X') || b.words.has('Z') || b.words.has('U') || b.words.has('W');
}
bool other_axis(const Block& b) { return b.words.has('Y') || b.words.has('V'); }
bool names_axis(const Block& b) {
  return (b.words.mask & kPolarWords) != 0 ||
         std::any_of(kAxisNames.begin(), kAxisNames.end(),
                     [&](char axis) { return b.words.has(axis); });
}
/// Return whether the axis words are lengths of the tool: no motion code of the block moves by
/// them.
bool gives_length(const Block& b) {
  return b.has(Group::Length) && b.code(Group::Length).variant == 1 && !b.has(Group::Motion) &&
         !b.has(Group::Cycle);
}
/// Return whether a block makes a straight move by its own code, or by its axes in the mode in
/// force.
bool makes_line(const State& s, const Block& b) {
  if (b.has(Group::Cycle)) return false;
  if (b.has(Group::Motion)) return b.meaning(Group::Motion) <= Meaning::Line;
  const Meaning mode = s.modal[at(Group::Motion)].meaning;
  return !b.was_cycle && !s.no_motion && mode <= Meaning::Line && names_axis(b) && !gives_length(b);
}
bool stops(const Block& b) {
  return b.words.ends || b.words.has(Role::Stop) || b.words.has(Role::OptionalStop) ||
         b.words.has(Role::End);
}
/// Return whether a block has codes that share none with rotation, scaling, mirror.
/// [MDib 0150; TA 5 note 2]
bool besides_turn(const Block& b) {
  constexpr std::uint32_t kApart = bit(Group::OneShot) | bit(Group::Motion) | bit(Group::Radius) |
                                   bit(Group::Length) | bit(Group::Macro) | bit(Group::Work);
  const std::uint32_t groups = b.words.codes->groups;
  return std::popcount(groups & kTurning) > 1 || (groups & kApart) != 0;
}
/// The codes that a rotated lathe does not take. [TA 5 note 3]
constexpr std::uint32_t kNotRotated = bit(Group::OneShot) | bit(Group::Radius) | bit(Group::Work) |
                                      bit(Group::Units) | bit(Group::Macro) | bit(Group::Stroke);
bool strange_in_rotation(const Block& b) {
  return (b.words.codes->groups & kNotRotated) != 0 || b.meaning(Group::Motion) > Meaning::Ccw;
}

/// Return whether the block names an axis of the compensated plane, absolute or by an increment.
bool moves_in_plane(const State& s, const Block& b) {
  const PlaneAxes axes = plane_axes(plane(s, b));
  const auto named = [&b](int axis) {
    const auto place = static_cast<std::size_t>(axis);
    return b.words.has(kAxisNames[place]) || (axis < 3 && b.words.has("UVW"[place]));
  };
  return named(axes.a) || named(axes.b);
}
/// Return whether a block has G41 or G42 where it is not in force.
bool begins_compensation(const State& s, const Block& b) {
  const Meaning asked = b.meaning(Group::Radius);
  return b.has(Group::Radius) && asked != Meaning::RadiusOff &&
         asked != s.modal[at(Group::Radius)].meaning;
}
bool is_arc(Meaning meaning) { return meaning == Meaning::Cw || meaning == Meaning::Ccw; }
bool taps(const Block& b) {
  const Meaning cycle = b.meaning(Group::Cycle);
  return cycle == Meaning::Tap || cycle == Meaning::LeftTap;
}

/// Return whether a block moves by its axis words, outside of a canned cycle.
bool moves_axes(const Block& b) {
  if (in_cycle(b) || b.has(Group::Cycle)) return false;
  for (const Meaning meaning : {Meaning::Dwell, Meaning::SetData, Meaning::SetCoordinate,
                                Meaning::ClearCoordinate, Meaning::Local})
    if (does(b, meaning)) return false;
  return std::any_of(kAxisNames.begin(), kAxisNames.end(),
                     [&](char axis) { return b.words.has(axis); });
}

/// The time at which a radius is compensated: before the block, or after its G40 to G42.
enum class Compensated : std::uint8_t { Either, Before, Behind };

}  // namespace

struct Conflict {
  Cause cause;
  WordName word;  // that may not stand there; a code of the lists is named where it is found
  bool (*applies)(const MotionState&, const BlockWords&);
  bool of_words = false;                         // a block without G codes may have it
  Rule<Codes> MotionRules::* codes = nullptr;    // and the block has one of these
  Rule<Codes> MotionRules::* m_codes = nullptr;  // or one of these
  Compensated compensated = Compensated::Either;

  /// Return the word of a block that may not stand there.
  std::optional<WordName> find(MotionView m, const BlockWords& block) const {
    if (!is_met(m, block) || !applies(m.state, block)) return std::nullopt;
    const MotionRules& rules = m.facts.control->motion;
    if (codes != nullptr)
      for (const int code : block.words.codes->g())
        if ((rules.*codes).value.has(code)) return WordName{.code = code};
    if (m_codes != nullptr)
      for (const int code : block.words.codes->m())
        if ((rules.*m_codes).value.has(code * 10)) return WordName{.addresses = bit('M')};
    return codes == nullptr && m_codes == nullptr ? std::optional(word) : std::nullopt;
  }

  bool is_met(MotionView m, const BlockWords& block) const {
    if (compensated == Compensated::Either) return true;
    return compensated == Compensated::Before ? compensating(m.state)
                                              : compensates_behind(m, block);
  }
};

namespace {

constexpr WordName kActing{};  // the code by which the block acts
constexpr WordName words(std::uint32_t addresses) { return {.addresses = addresses}; }
constexpr WordName codes(std::uint32_t groups) { return {.groups = groups}; }

constexpr Conflict kConflicts[] = {
    {Cause::RigidMove, words(kAxisWords),
     [](const State& s, const Block& b) { return s.rigid_waits && moves_axes(b); }, true},
    {Cause::RigidCodeInCycle, words(bit('M')),
     [](const State&, const Block& b) { return taps(b) && b.words.has(Role::RigidTapping); }},
    {Cause::RigidWordTwice, words(bit('M') | bit('S')),
     [](const State& s, const Block& b) {
       return s.rigid_waits && (b.words.has('S') || b.words.has(Role::RigidTapping));
     },
     true},
    {Cause::TapInSurfaceSpeed, kActing,
     [](const State& s, const Block& b) {
       return taps(b) && (b.has(Group::Surface) ? b.meaning(Group::Surface) == Meaning::SurfaceSpeed
                                                : s.surface);
     }},
    {Cause::CycleAxisChanged, codes(bit(Group::Plane)),
     [](const State& s, const Block& b) {
       return in_cycle(b) && ((b.has(Group::Plane) && plane(s, b) != s.plane) ||
                              (cycles(b) && b.code(Group::Cycle).variant != s.cycle.code.variant));
     }},
    {Cause::OneShotWithMotion, kActing,
     [](const State&, const Block& b) {
       return b.has(Group::OneShot) && !does(b, Meaning::ExactStop) && b.has(Group::Motion);
     }},
    {Cause::LengthWithMotion, codes(bit(Group::Length)),
     [](const State& s, const Block& b) {
       const Meaning m = motion(s, b);
       return b.has(Group::Length) && b.meaning(Group::Length) != Meaning::LengthOff &&
              (m == Meaning::Cw || m == Meaning::Ccw || does(b, Meaning::Dwell) ||
               does(b, Meaning::Skip) || does(b, Meaning::SetCoordinate));
     }},
    {Cause::LocalWithLength, kActing,
     [](const State&, const Block& b) { return does(b, Meaning::Local) && length(b); }},
    {Cause::LocalInExtraSystem, kActing,
     [](const State& s, const Block& b) { return does(b, Meaning::Local) && s.work_system == 0; }},
    {Cause::ToolWithSetting, words(bit('T')),
     [](const State&, const Block& b) {
       return b.words.has('T') && (does(b, Meaning::SetCoordinate) || does(b, Meaning::SetData) ||
                                   does(b, Meaning::Dwell));
     }},
    {Cause::StrokeWithCodes, codes(bit(Group::Stroke)),
     [](const State&, const Block& b) {
       return b.has(Group::Stroke) && (b.words.codes->g_count > 1 || b.words.codes->m_count > 0 ||
                                       b.words.ends || b.words.has('S') || b.words.has('T'));
     }},
    {Cause::ReferenceWithEnd, words(bit('M')),
     [](const State&, const Block& b) { return does(b, Meaning::CheckReference) && stops(b); }},
    {Cause::ReferenceWithM, words(bit('M')),
     [](const State&, const Block& b) {
       return does(b, Meaning::FromReference) && (b.words.codes->m_count > 0 || b.words.ends);
     }},
    {Cause::ReferenceInCycle, kActing,
     [](const State&, const Block& b) {
       return in_cycle(b) && (returns(b) || does(b, Meaning::CheckReference));
     }},
    {Cause::MachineMoveInCycle, kActing,
     [](const State&, const Block& b) { return in_cycle(b) && does(b, Meaning::Machine); }},
    {Cause::MachineMoveCode, kActing,
     [](const State& s, const Block& b) { return does(b, Meaning::Machine) && !makes_line(s, b); }},
    {Cause::PolarPlane, codes(bit(Group::Plane)),
     [](const State& s, const Block& b) { return polar(s) && b.has(Group::Plane); }},
    {Cause::PolarWorkSystem, codes(bit(Group::Work)),
     [](const State& s, const Block& b) { return polar(s) && b.has(Group::Work); }},
    {Cause::PolarTool, words(bit('T')),
     [](const State& s, const Block& b) { return polar(s) && b.words.has('T'); }, true},
    {Cause::PolarCycle, kActing,
     [](const State& s, const Block& b) { return polar(s) && cycles(b) && s.plane != Plane::XY; }},
    {Cause::TurnedUnits, codes(bit(Group::Units)),
     [](const State& s, const Block& b) {
       return (polar(s) || is_transformed(s)) && b.has(Group::Units);
     }},
    {Cause::TurnedInCompensation, codes(kTurning),
     [](const State& s, const Block& b) { return compensating(s) && begins_turn(b); }},
    {Cause::CompensationEndMode, codes(bit(Group::Radius)),
     [](const State& s, const Block& b) {
       return compensating(s) && b.meaning(Group::Radius) == Meaning::RadiusOff &&
              !b.has(Group::Motion) && is_arc(motion(s, b));
     }},
    {Cause::CompensationNoMove, codes(bit(Group::Radius)),
     [](const State& s, const Block& b) {
       return begins_compensation(s, b) && !moves_in_plane(s, b);
     }},
    {Cause::CornerCodes,
     {.addresses = bit('H'), .groups = bit(Group::Length) | bit(Group::Work) | bit(Group::OneShot)},
     [](const State& s, const Block& b) {
       return !s.lookahead.corner.empty() &&
              (length(b) || b.has(Group::Work) || does(b, Meaning::SetCoordinate) ||
               does(b, Meaning::Local));
     },
     true},
    {Cause::CompensationCycle, kActing, [](const State&, const Block& b) { return cycles(b); },
     false, nullptr, nullptr, Compensated::Behind},
    {Cause::CycleInverseTime, codes(bit(Group::Feed)),
     [](const State& s, const Block& b) {
       const Meaning feed =
           b.has(Group::Feed) ? b.meaning(Group::Feed) : s.modal[at(Group::Feed)].meaning;
       const bool drills = b.has(Group::Cycle) ? cycles(b) : b.was_cycle && !b.has(Group::Motion);
       return drills && feed == Meaning::InverseTime && names_axis(b);
     },
     true},
    {Cause::CompensationWrongPlane, codes(bit(Group::Radius)),
     [](const State& s, const Block& b) {
       return b.has(Group::Radius) && b.meaning(Group::Radius) != Meaning::RadiusOff &&
              plane(s, b) == Plane::YZ;
     }},
    {Cause::CompensationCode, kActing, [](const State&, const Block&) { return true; }, false,
     nullptr, &MotionRules::m_codes_not_compensated, Compensated::Before},
    {Cause::CompensationCode, kActing, [](const State&, const Block&) { return true; }, false,
     &MotionRules::codes_not_compensated, nullptr, Compensated::Behind},
    {Cause::TurnedWithCodes, codes(kTurning),
     [](const State&, const Block& b) { return turns(b) && besides_turn(b); }},
    {Cause::TurnedMirror, codes(bit(Group::Mirror)),
     [](const State& s, const Block& b) {
       return (s.transform.rotation || s.transform.scaling) && b.has(Group::Mirror);
     }},
    {Cause::ReferenceInRotation, kActing,
     [](const State& s, const Block& b) { return is_transformed(s) && returns(b); }},
    {Cause::RotationPlane, codes(bit(Group::Plane)),
     [](const State& s, const Block& b) { return s.transform.rotation && b.has(Group::Plane); }},
    {Cause::TurnedPlane, codes(bit(Group::Plane)),
     [](const State& s, const Block& b) { return is_transformed(s) && b.has(Group::Plane); }},
    {Cause::TurnedCoordinate, kActing,
     [](const State& s, const Block& b) {
       return is_transformed(s) && does(b, Meaning::SetCoordinate);
     }},
    {Cause::TurnedWorkSystem, codes(bit(Group::Work)),
     [](const State& s, const Block& b) {
       return is_transformed(s) &&
              (b.has(Group::Work) || does(b, Meaning::Local) || does(b, Meaning::Machine));
     }},
    {Cause::TurnedLength,
     {.addresses = bit('H'), .groups = bit(Group::Length)},
     [](const State& s, const Block& b) { return is_transformed(s) && length(b); },
     true},
    {Cause::TurnedData, kActing,
     [](const State& s, const Block& b) {
       return s.transform.rotation && does(b, Meaning::SetData) &&
              (b.words['L'] == 2 || b.words['L'] == 20);
     }},
    {Cause::TurnedCycle, kActing, [](const State& s, const Block&) { return is_transformed(s); },
     false, &MotionRules::codes_not_turned},
    {Cause::RotatedCycle, codes(bit(Group::Rotation)),
     [](const State& s, const Block& b) {
       return in_cycle(b) && s.plane != Plane::XY &&
              b.meaning(Group::Rotation) == Meaning::RotationOn;
     }},
    {Cause::RotationCode, codes(kNotRotated),
     [](const State& s, const Block& b) { return s.transform.rotation && strange_in_rotation(b); }},
    {Cause::CyclePlane, kActing,
     [](const State& s, const Block& b) { return repeats_cuts(b) && plane(s, b) != Plane::ZX; }},
    {Cause::CycleAxis, words(bit('Y') | bit('V')),
     [](const State&, const Block& b) { return repeats_cuts(b) && other_axis(b); }},
    {Cause::TurningPlane, kActing,
     [](const State& s, const Block& b) {
       return turning(s, b) && (names_xz(b) || b.has(Group::Motion)) && plane(s, b) != Plane::ZX;
     },
     true},
    {Cause::TurningAxis, words(bit('Y') | bit('V')),
     [](const State& s, const Block& b) { return turning(s, b) && other_axis(b); }, true},
    {Cause::PatternWithoutCycle, kActing,
     [](const State&, const Block& b) { return !in_cycle(b) && !cycles(b); }, false,
     &MotionRules::pattern_codes},
};

}  // namespace

void MotionFacts::list_conflicts() {
  for (const Conflict& conflict : kConflicts) {
    if (!refuses(conflict.cause)) continue;
    conflicts.push_back(&conflict);
    if (conflict.of_words) conflicts_of_words.push_back(&conflict);
    const bool of_moves = conflict.of_words || conflict.codes != nullptr;
    if (of_moves) conflicts_of_moves.push_back(&conflict);
  }
}

/// Return what may not stand together, before anything changes.
std::optional<Fault> check_conflicts(MotionView m, const BlockWords& block) {
  const BlockCodes& codes = *block.words.codes;
  const auto& list = codes.m_count > 0       ? m.facts.conflicts
                     : codes.g_count == 0    ? m.facts.conflicts_of_words
                     : codes.only_of_moves() ? m.facts.conflicts_of_moves
                                             : m.facts.conflicts;
  for (const Conflict* conflict : list)
    if (const auto word = conflict->find(m, block)) return fault_at(*word, conflict->cause, block);
  return std::nullopt;
}

namespace {

/// Return the code by which a block without one of its own moves: its axes go on in the mode, and a
/// centre goes on in an arc. Return null where its words are none of a move.
const GCode* mode_of(const State& s, const Block& b) {
  if (b.has(Group::Motion) || b.has(Group::Cycle) || s.no_motion) return nullptr;
  const bool own = does(b, Meaning::SetData) || returns(b) || does(b, Meaning::SetCoordinate) ||
                   does(b, Meaning::SetShift) || does(b, Meaning::Local);
  const GCode& mode = b.was_cycle ? s.cycle.code : s.modal[at(Group::Motion)];
  if (names_axis(b)) return own || gives_length(b) ? nullptr : &mode;
  return !own && !b.was_cycle && is_arc(mode.meaning) && (b.words.mask & kCentreWords) != 0
             ? &mode
             : nullptr;
}

}  // namespace

std::optional<Fault> unused_word(MotionView m, const NcWords& words) {
  const WordUses& uses = m.facts.meanings->uses;
  if ((words.mask & uses.checked() & ~words.codes->uses) == 0) return std::nullopt;
  const BlockWords block{.words = words, .step = 0, .was_cycle = in_cycle(m.state)};
  const GCode* mode = mode_of(m.state, block);
  const std::uint32_t used = words.codes->uses | (mode != nullptr ? uses.of_g(mode->code) : 0);
  std::uint32_t unused = words.mask & uses.checked() & ~used;
  for (std::uint32_t left = unused; left != 0; left &= left - 1) {
    const auto place = static_cast<std::size_t>(std::countr_zero(left));
    if (words.value[place] == uses.none(place)) unused &= ~(1u << place);
  }
  if (unused == 0) return std::nullopt;
  const auto letter = static_cast<char>('A' + std::countr_zero(unused));
  Fault wrong = fault_at(letter, Cause::AddressNotUsable, block, std::string(uses.text(unused)));
  wrong.text = uses.text(unused);
  return wrong;
}

}  // namespace cncsub
