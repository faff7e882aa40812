// GSK 980MDi mill.
#include "controls/gsk/family.hpp"

namespace cncsub {

using namespace gsk;

namespace {

// G111 is a code of this control too, but it serves as the unknown code of the motion cases.
constexpr const char* kMDiCodes =
    "0 1 2 3 4 7.1 9 10 11 15 16 17 18 19 20 21 28 29 30 31 37 40 41 42 43 44 49 "
    "50 50.1 51 51.1 52 53 54 54.1 55 56 57 58 59 61 62 63 64 65 66 67 68 69 "
    "73 74 76 80 81 82 83 84 85 86 87 88 89 90 91 92 94 95 96 97 98 99 107 "
    "110 112 113 114 115 116 117 126 127 132 133 134 135 136 137 138 139 140 141 142 143 144";

/// The parameters that set rules, and those of codes that call.
const Parameter kParameters[] = {
    {"027",
     0,
     "the largest cutting feed, 0 = any",
     kMDib + "0023",
     Manual,
     {number(rule::max_feed)}},
    {"3410",
     0,
     "how far the radii of an arc's start and end may differ, 0 = any",
     kMDipar + "3410",
     Manual,
     {micrometres(rule::arc_tolerance)}},
    {"520#7",
     0,
     "ATAN and ASIN: 0 gives 0 to 360 and 90 to 270, 1 -180 to 180 and -90 to 90",
     kMDipar + "520#7",
     Manual,
     {bit(rule::atan_range, AngleRange::FullTurn, AngleRange::Signed),
      bit(rule::asin_range, AngleRange::FullTurn, AngleRange::Signed)}},
    {"6044", 0, "the first M code that calls a subprogram", kMDipar + "6044", Manual},
    {"6045", 0, "the program that the first M code calls", kMDipar + "6045", Manual},
    {"6046", 0, "how many M codes call subprograms, 0 = none", kMDipar + "6046", Manual},
};

void calls_by_code(Control& c) {
  CodeCall subprogram =
      code_call(CodeCall::Form::Range, 'M', CodeCallKind::Subprogram, 6044, 6045, 6046);
  subprogram.first_code = 3;
  subprogram.last_code = 8999;
  subprogram.source = kMDipar + "6044 to 6046";
  subprogram.evidence = Manual;
  c.code_calls.push_back(subprogram);
}

void measuring(Control& c) {
  c.motion.measuring = {Measuring::Of5040, "MDipar 5040, 5043, 5044; TDi 17: the moves", Secondary};
  for (const auto& [name, meaning] :
       {std::pair{"5040", "the measuring feed of G37, mm/min"},
        {"5043", "G37: how far before the point the measuring feed begins, mm"},
        {"5044", "G37: within what distance of the point the tool arrives, mm"}})
    c.parameters.push_back(
        read_by(rule::measuring, {name, 0, meaning, "MDipar 5040, 5043, 5044", Manual}));
  c.motion.skip_signals = {SkipSignals::Numbered, "MDipar 5431 to 5434: P1 to P4 have one each",
                           Manual};
  c.motion.max_skip_signals = {4, "MDipar 5431 to 5434", Manual};
}

void mill_motion(Control& c) {
  c.motion.machine = {MachineType::Mill, "MDib", Manual};
  leave_out(c, RuleGroup::TurningRules, "MDib", Manual);
  c.motion.g_meanings = {"", kKnown, Inferred};
  c.motion.unit_change = {UnitChange::Alone, "MDib 0038", Manual};
  c.motion.codes_not_turned = {
      "110 111 112 113 114 115 116 117 126 127 132 133 134 135 136 137 138 139 140 141 142 143 144",
      "MDib 0162", Manual};
  c.motion.pattern_codes = {"140 141 142 143 144", "MDib 0216", Manual};
  c.motion.max_offset_number = {32, "MDib 0016", Manual};
  c.motion.max_rotation = {360, "MDib 0156", Manual};
  c.motion.idle_blocks = {10, kKnown, Inferred};
  c.motion.cycle_repeats = {"LK", "MDib 0203, 0204", Manual};
  c.motion.zero_cycle_repeats = {ZeroCycleRepeats::Alarm, "MDib 0203", Manual};
  c.motion.no_radius = {NoRadius::Alarm, "MDib 0021", Manual};
  c.motion.small_radius = {SmallRadius::Alarm, kTDi + "4, note 3", Secondary};
  c.motion.chamfer_words = {",C L", "MDib 0039", Manual};
  c.motion.round_words = {",R U", "MDib 0039", Manual};
  c.motion.helix = {Helix::Everywhere, "MDib 0032", Manual};
  lacks(c.common.power_on, {PowerOn::G01}, kTDi + "2: G00", Secondary);
}

}  // namespace

/// Like the 980TDi, without names, with M-code calls at 6044, the length offsets of a mill and the
/// G codes of a mill.
Control gsk_980mdi() {
  Control c = family_980();
  c.title = "GSK 980MDi mill";
  has(c.common.refuses, {Cause::LogicOfBits}, kMDib + "0133", Manual);
  for (const int group : {3, 4, 8, 9, 10, 11, 13, 15})
    c.variables.push_back({4000 + group, 4000 + group, VariableKind::ModalCode, Access::ReadOnly, 0,
                           kGeneral, Inferred});
  modal_words(c, "BDH", kGeneral, Inferred);
  c.calls.bracket_names = {false, kGeneral, Inferred};
  c.calls.wide_names = {false, kGeneral, Inferred};
  c.calls.count_and_l = {CountAndL::NoL, kGeneral, Inferred};
  c.reading.g_codes = {kMDiCodes, kMDib + "names them; motion codes from general knowledge",
                       Inferred};
  c.reading.point_addresses = {
      "ABCDEFHIJKLQRUVWXYZ",
      kMDia + "093: L and U are lengths of a chamfer; the others from general knowledge", Inferred};
  c.macros.atan_range = {AngleRange::FullTurn, kMDipar + "520#7 = 0", Manual};
  c.macros.asin_range = {AngleRange::FullTurn, kMDipar + "520#7 = 0", Manual};
  calls_by_code(c);
  mill_motion(c);
  measuring(c);
  take_list(c, alarms_980mdi_b());
  // Other rules say which axes an arc takes; no feed alarms where axes move, as on its relatives.
  refuse_listed(c, alarms_980mdi_b(), {Cause::ArcAxis, Cause::NoFeed});
  add_parameters(c, kParameters);
  return c;
}

}  // namespace cncsub
