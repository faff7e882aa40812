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
  add_parameters(
      c,
      {
          {"520#7", 0, "ATAN and ASIN: 0 gives 0 to 360 and 90 to 270, 1 -180 to 180 and -90 to 90",
           kMDipar + "520#7", Manual,
           [](Control& k, double value) {
             const AngleRange range = value != 0 ? AngleRange::Signed : AngleRange::FullTurn;
             k.atan_range.value = range;
             k.asin_range.value = range;
           }},
          {"6044", 0, "the first M code that calls a subprogram", kMDipar + "6044", Manual,
           nullptr},
          {"6045", 0, "the program that the first M code calls", kMDipar + "6045", Manual, nullptr},
          {"6046", 0, "how many M codes call subprograms, 0 = none", kMDipar + "6046", Manual,
           nullptr},
          {"3403#4", 1, "radius too small for the end point: 0 a half circle, 1 an alarm",
           kTDi + "4, note 3; " + kStands, Inferred, nullptr},
          {"3403#5", 1, "an arc without R, I, K: 0 a straight line, 1 an alarm",
           kTDi + "4, note 1; " + kStands, Inferred, nullptr},
      });
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
  add_parameter(
      c, {"027", 0, "the largest cutting feed, 0 = any", kMDib + "0023", Manual, set_max_feed});
  add_parameter(c, {"3402#0", 0, "power-on: 0 in G00, 1 in G01", kTDi + "2: G00; " + kStands,
                    Inferred, set_power_on_line});
  add_parameter(c, {"3410", 0, "how far the radii of an arc's start and end may differ, 0 = any",
                    kMDipar + "3410", Manual, set_tolerance});
  add_parameter(c,
                {"5114", 0, "return of the fast peck cycle", kStands, Inferred, set_peck_retract});
  add_parameter(c,
                {"5115", 0, "clearance of the peck cycle", kStands, Inferred, set_peck_clearance});
  take_list(c, alarms_980mdi_b());
  return c;
}

}  // namespace cncsub
