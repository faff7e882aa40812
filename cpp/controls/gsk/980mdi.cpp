// GSK 980MDi mill.
#include "controls/gsk/family.hpp"

namespace cncsub {

using namespace gsk;

namespace {

// G111 is a code of this control too, but it serves as the unknown code of the motion cases.
const std::string kMDiCodes =
    "0 1 2 3 4 7.1 9 10 11 15 16 17 18 19 20 21 28 29 30 31 37 40 41 42 43 44 49 "
    "50 50.1 51 51.1 52 53 54 54.1 55 56 57 58 59 61 62 63 64 65 66 67 68 69 "
    "73 74 76 80 81 82 83 84 85 86 87 88 89 90 91 92 94 95 96 97 98 99 107 "
    "110 112 113 114 115 116 117 126 127 132 133 134 135 136 137 138 139 140 141 142 143 144";

void alarms(Control& c) {
  AlarmEntry& travel = c.alarms[Cause::OverTravel];
  travel = {"", "", "MDia 3011 to 3020", Manual};
  int number = 3011;
  for (const char* direction : {"+", "-"})
    for (const char* axis : {"X", "Y", "Z", "A", "B"})  // the fourth is A, the fifth B [inferred]
      travel.directed.push_back(
          {std::string(axis) + direction, std::to_string(number++), "software travel limit"});
  add_alarms(
      c,
      {{Cause::ArcAxis, "0008", "axis outside the plane of the arc", "MDib 0008", Manual},
       {Cause::OneShotWithMotion, "0014", "codes of groups 00 and 01 in one block", "MDib 0014",
        Manual},
       {Cause::OffsetNumber, "0016", "H outside 0 to 32", "MDib 0016", Manual},
       {Cause::RadiusTolerance, "0018", "the radii of an arc differ", "MDib 0018", Manual},
       {Cause::RadiusTooSmall, "0018", "the radii of an arc differ", "MDib 0018", Manual},
       {Cause::RadiusOffsetNumber, "0020", "D outside its range", "MDib 0020", Manual},
       {Cause::NoRadius, "0021", "I, J, K of G02, G03", "MDib 0021", Manual},
       {Cause::NoFeed, "0023", "F wrong or over 027", "MDib 0023", Manual},
       {Cause::FeedOutOfRange, "0023", "F wrong or over 027", "MDib 0023", Manual},
       {Cause::CompensationPlane, "0030", "plane change in the compensation", "MDib 0030", Manual},
       {Cause::CornerPlane, "0031", "plane change behind a chamfer", "MDib 0031", Manual},
       {Cause::CompensationSkip, "0035", "G31 in the compensation", "MDib 0035", Manual},
       {Cause::MeasuringMissed, "3050", "G37: no signal in the measuring zone", "MDia 3050",
        Manual},
       {Cause::MeasuringEarly, "3051", "signal before the measuring zone", "MDia 3051", Manual},
       {Cause::MeasuringOffset, "3052", "G37 with the offset number 0", "MDia 3052", Manual},
       {Cause::MeasuringZone, "0282", "G37: 5043 is not above 5044", "MDib 0282", Manual},
       {Cause::MeasuringWithOffset, "0297", "G37 with H in one block", "MDib 0297", Manual},
       {Cause::MeasuringIncremental, "0298", "G37 in increments", "MDib 0298", Manual},
       {Cause::MeasuringAxis, "0299", "G37 with another axis than Z, or in another plane",
        "MDib 0299", Manual},
       {Cause::CornerNoMove, "0036", "the block behind a chamfer", "MDib 0036", Manual},
       {Cause::CornerNextMove, "0036", "the block behind a chamfer", "MDib 0036", Manual},
       {Cause::UnitChangeLate, "0038", "G20, G21 not alone at the head", "MDib 0038", Manual},
       {Cause::LengthWithMotion, "0042", "length offset with G02 G03 G04 G31 G92", "MDib 0042",
        Manual},
       {Cause::NoIntermediate, "0068", "G29 without G28", "MDib 0068", Manual},
       {Cause::ReferenceNotHomed, "0069", "G30 before the machine zero is known", "MDib 0069",
        Manual},
       {Cause::CornerFormat, "0093", "chamfer words combined", "MDib 0093", Manual},
       {Cause::CornerWithCall, "0093", "M98 with a chamfer", "MDib 0093", Manual},
       {Cause::ReturnInCompensation, "0099", "a jump in the compensation", "MDib 0099", Manual},
       {Cause::JumpInCompensation, "0100", "a jump in the compensation", "MDib 0100", Manual},
       {Cause::ReferenceInRotation, "0152", "G28 to G30 in rotation or mirror", "MDib 0152",
        Manual},
       {Cause::RotationPlane, "0154", "plane change in rotation", "MDib 0154", Manual},
       {Cause::TurnedInCompensation, "0155", "rotation or mirror in the compensation", "MDib 0155",
        Manual},
       {Cause::RotationAngle, "0156", "angle over 360", "MDib 0156", Manual},
       {Cause::ScaleZero, "0158", "scale 0", "MDib 0158", Manual},
       {Cause::MachineMoveInCycle, "0165", "G53 in a fixed cycle", "MDib 0165", Manual},
       {Cause::NotHomed, "0166", "G53 before the machine zero is known", "MDib 0166", Manual},
       {Cause::PolarCentre, "0176", "I, J, K in polar coordinates", "MDib 0176", Manual},
       {Cause::PolarPlane, "0186", "plane change in polar coordinates", "MDib 0186", Manual},
       {Cause::PolarWorkSystem, "0187", "G54 to G59 in polar coordinates", "MDib 0187", Manual},
       {Cause::CycleRepeats, "0203", "repeat count 0", "MDib 0203", Manual},
       {Cause::G10P, "0238", "P of G10", "MDib 0238", Manual},
       {Cause::G10System, "0239", "P of G10 L20 outside 1 to 48", "MDib 0239", Manual},
       {Cause::WorkSystem, "0240", "P of G54.1 outside 1 to 48", "MDib 0240", Manual},
       {Cause::G10Offset, "0242", "P of an offset outside 1 to 32", "MDib 0242", Manual},
       {Cause::TurnedData, "0243", "G10 of a work system in rotation", "MDib 0243", Manual},
       {Cause::G10Word, "0246", "P or L of G10 missing", "MDib 0246", Manual},
       {Cause::G10Axis, "0247", "axis of G10 missing", "MDib 0247", Manual},
       {Cause::G10Value, "0248", "R of G10 missing", "MDib 0248", Manual},
       {Cause::HelixAxis, "0022", "axes beyond X, Y, Z in a helix", "MDib 0022", Manual},
       {Cause::HelixTravel, "0032", "a helix without travel in its plane", "MDib 0032", Manual},
       {Cause::CornerOffset, "0039", "a chamfer at the start of compensation", "MDib 0039", Manual},
       {Cause::LocalWithLength, "0046", "G52 with a length offset", "MDib 0046", Manual},
       {Cause::ScaleNegative, "0140", "P of scaling negative", "MDib 0140", Manual},
       {Cause::TurnedLength, "0149", "H in mirror, scaling, rotation", "MDib 0149", Manual},
       {Cause::TurnedWithCodes, "0150", "other codes in the block of mirror, scaling, rotation",
        "MDib 0150", Manual},
       {Cause::TurnedCoordinate, "0151", "G92 in mirror, scaling, rotation", "MDib 0151", Manual},
       {Cause::TurnedWorkSystem, "0153", "G52 to G59 in mirror, scaling, rotation", "MDib 0153",
        Manual},
       {Cause::TurnedPlane, "0154", "plane change in mirror, scaling", "MDib 0154", Manual},
       {Cause::TurnedMirror, "0159", "mirror in scaling or rotation", "MDib 0159", Manual},
       {Cause::RotatedCycle, "0160", "rotation in a cycle outside G17", "MDib 0160", Manual},
       {Cause::TurnedUnits, "0161", "G20, G21 in polar, mirror, rotation, scaling", "MDib 0161",
        Manual},
       {Cause::TurnedCycle, "0162", "G110 to G144 in mirror, scaling, rotation", "MDib 0162",
        Manual},
       {Cause::PolarCycle, "0163", "G16 with a cycle outside G17", "MDib 0163", Manual},
       {Cause::PolarCorner, "0185", "a chamfer in polar coordinates", "MDib 0185", Manual},
       {Cause::PolarTool, "0188", "a tool change in polar coordinates", "MDib 0188", Manual},
       {Cause::CycleRepeatsTwice, "0204", "L and K in a cycle", "MDib 0204", Manual},
       {Cause::PatternWithoutCycle, "0216", "G140 to G144 without a drilling code", "MDib 0216",
        Manual},
       {Cause::TapLead, "0218", "no pitch in G74, G84", "MDib 0218", Manual},
       {Cause::NoSpeed, "0013", "no S with G95", "MDib 0013", Manual},
       {Cause::RigidMove, "0232", "a move between M29 and G74, G84", "MDib 0232", Manual},
       {Cause::DataEndFirst, "0029", "G11 before G10", "MDib 0029", Manual},
       {Cause::TapSpeed, "0230", "S is 0", "MDib 0230", Manual},
       {Cause::CornerHelix, "0278", "a chamfer in a helix", "MDib 0278", Manual},
       {Cause::G10L, "0244", "L of G10", "MDib 0244", Manual},
       {Cause::CompensationArcStart, "0254", "an arc starts on its centre", "MDib 0254", Manual},
       {Cause::CompensationArcEnd, "0255", "an arc ends on its centre", "MDib 0255", Manual},
       {Cause::CompensationArcTooSmall, "0256", "inner arc smaller than the radius", "MDib 0256",
        Manual},
       {Cause::CompensationNoIntersection, "0257", "no intersection", "MDib 0257", Manual},
       {Cause::CompensationArc, "0258", "start of the compensation in an arc", "MDib 0258", Manual},
       {Cause::CompensationEndArc, "0259", "end of the compensation in an arc", "MDib 0259",
        Manual},
       {Cause::CompensationInterference, "0260", "interference", "MDib 0260", Manual},
       {Cause::CompensationIdle, "0263", "too many blocks without a move", "MDib 0263", Manual},
       {Cause::CornerTooShort, "0271", "the move is shorter than the chamfer", "MDib 0271",
        Manual}});
}

}  // namespace

/// Like the 980TDi: no names, M-code calls at 6044, the length offsets of a mill, G codes of a
/// mill.
Control gsk_980mdi() {
  Control c = family_980();
  c.title = "GSK 980MDi mill";
  c.logic_of_bits = {true, kMDib + "0133", Manual};
  for (const int group : {3, 4, 8, 9, 10, 11, 13, 15})
    c.variables.push_back({4000 + group, 4000 + group, VariableKind::ModalCode, Access::ReadOnly, 0,
                           kGeneral, Inferred});
  modal_words(c, "BDH", kGeneral, Inferred);
  c.bracket_names = {false, kGeneral, Inferred};
  c.wide_names = {false, kGeneral, Inferred};
  c.count_and_l = {CountAndL::NoL, kGeneral, Inferred};
  c.g_codes = {kMDiCodes, kMDib + "names them; motion codes from general knowledge", Inferred};
  c.point_addresses = {
      "ABCDEFHIJKLQRUVWXYZ",
      kMDia + "093: L and U are lengths of a chamfer; the others from general knowledge", Inferred};
  c.atan_range = {AngleRange::FullTurn, kMDipar + "520#7 = 0", Manual};
  c.asin_range = {AngleRange::FullTurn, kMDipar + "520#7 = 0", Manual};
  c.parameters.push_back(
      {"520#7", 0, "ATAN and ASIN: 0 gives 0 to 360 and 90 to 270, 1 -180 to 180 and -90 to 90",
       kMDipar + "520#7", Manual, [](Control& k, double value) {
         const AngleRange range = value != 0 ? AngleRange::Signed : AngleRange::FullTurn;
         k.atan_range.value = range;
         k.asin_range.value = range;
       }});
  c.parameters.push_back(
      {"027", 0, "the largest cutting feed, 0 = any", kMDib + "0023", Manual, nullptr});
  c.parameters.push_back({"3410", 0,
                          "how far the radii of an arc's start and end may differ, 0 = any",
                          kMDipar + "3410", Manual, nullptr});
  c.parameters.push_back(
      {"6044", 0, "the first M code that calls a subprogram", kMDipar + "6044", Manual, nullptr});
  c.parameters.push_back(
      {"6045", 0, "the program that the first M code calls", kMDipar + "6045", Manual, nullptr});
  c.parameters.push_back({"6046", 0, "how many M codes call subprograms, 0 = none",
                          kMDipar + "6046", Manual, nullptr});
  CodeCall subprogram =
      code_call(CodeCall::Form::Range, 'M', CodeCallKind::Subprogram, 6044, 6045, 6046);
  subprogram.first_code = 3;
  subprogram.last_code = 8999;
  subprogram.source = kMDipar + "6044 to 6046";
  subprogram.evidence = Manual;
  c.code_calls.push_back(subprogram);

  c.machine = {MachineType::Mill, "MDib", Manual};
  c.g_meanings = {"", kKnown, Inferred};
  c.unit_change = {UnitChange::Alone, "MDib 0038", Manual};
  c.home_needed = {true, "MDib 0166, 0069", Manual};
  c.refuses = {
      "one-shot-with-motion length-with-motion local-with-length machine-move-in-cycle "
      "plane-change-in-polar work-system-change-in-polar polar-centre tool-in-polar "
      "corner-in-polar cycle-plane-in-polar units-in-rotation mirror-in-offset "
      "codes-with-rotation mirror-in-rotation reference-return-in-mirror rotation-plane "
      "plane-change-in-mirror coordinate-setting-in-rotation work-system-in-rotation "
      "length-in-rotation data-in-rotation cycle-in-rotation rotation-plane-in-cycle "
      "pattern-without-cycle corner-at-offset-start corner-in-helix corner-with-call "
      "cycle-repeats-twice "
      "tap-without-lead tap-without-speed g10-axis-missing scale-negative no-spindle-speed "
      "helix-without-travel helix-axis measuring-zone move-before-rigid-tap g11-before-g10",
      "MDib 0013, 0014, 0022, 0029, 0032, 0039, 0042, 0046, 0140, 0149 to 0165, 0176 to 0188, "
      "0204, "
      "0216, "
      "0218, 0230, "
      "0243, 0247, "
      "0278",
      Manual};
  c.set_coordinate_without_tool = {false, kKnown, Inferred};
  c.max_offset_number = {32, "MDib 0016", Manual};
  c.jumps_in_compensation = {false, "MDib 0099, 0100", Manual};
  c.max_rotation = {360, "MDib 0156", Manual};
  c.idle_blocks_alarm = {true, "MDib 0263", Manual};
  c.idle_blocks = {10, kKnown, Inferred};
  c.cycle_repeats = {"LK", "MDib 0203, 0204", Manual};
  c.zero_cycle_repeats = {ZeroCycleRepeats::Alarm, "MDib 0203", Manual};
  c.arc_centre_needed = {true, "MDib 0021", Manual};
  c.no_radius = {NoRadius::Alarm, "MDib 0021", Manual};
  c.chamfer_words = {",C L", "MDib 0039", Manual};
  c.round_words = {",R U", "MDib 0039", Manual};
  c.chamfer_length = {ChamferLength::Corner, kKnown, Inferred};
  c.helix = {true, "MDib 0032", Manual};
  c.measuring = {Measuring::Of5040, "MDipar 5040, 5043, 5044; TDi 17: the moves", Secondary};
  for (const auto& [name, meaning] :
       {std::pair{"5040", "the measuring feed of G37, mm/min"},
        {"5043", "G37: how far before the point the measuring feed begins, mm"},
        {"5044", "G37: within what distance of the point the tool arrives, mm"}})
    c.parameters.push_back({name, 0, meaning, "MDipar 5040, 5043, 5044", Manual, nullptr});
  c.skip_signals = {SkipSignals::Numbered, "MDipar 5431 to 5434: P1 to P4 have one each", Manual};
  c.max_skip_signals = {4, "MDipar 5431 to 5434", Manual};
  c.groove_p_diameter = {false, kKnown, Inferred};
  add_effect(c, "027", 0, "the largest cutting feed, mm/min, 0 = any", "MDib 0023", Manual,
             set_max_feed);
  add_effect(c, "3402#0", 0,
             "at power-on 0 = G00, 1 = G01; FANUC's number stands for the control's own", kKnown,
             Inferred, set_power_on_line);
  add_effect(c, "3410", 0, "how far the radii of an arc may differ, mm, 0 = not checked",
             "MDib 0018", Manual, set_tolerance);
  add_effect(c, "5114", 0, "the retract of G73, mm; FANUC's number stands for the control's own",
             kKnown, Inferred, set_peck_retract);
  add_effect(c, "5115", 0, "the clearance of G83, mm; FANUC's number stands for the control's own",
             kKnown, Inferred, set_peck_clearance);
  alarms(c);
  return c;
}

}  // namespace cncsub
