// The parts that the OSP controls of machining centers share. Their alarms are those of the list of
// an OSP-P200L, a lathe, for which the same language is documented. The keys of the sources stand
// in sources.def.
#include "controls/okuma/family.hpp"

#include "controls/alarm_list.hpp"
#include "controls/facts.hpp"

namespace cncsub::okuma {
namespace {

using enum Evidence;
using enum Cause;

constexpr const char* kOsp = "general knowledge of the Okuma OSP";
constexpr const char* kTable = "OKG, the table of G codes";
constexpr const char* kPost = "OKP, the codes that it writes";

void language(Control& c) {
  c.reading.g_codes = {
      "0 1 2 3 4 9 10 11 14 15 16 17 18 19 20 21 22 23 30 31 40 41 42 43 44 50 51 53 54 55 56 57 "
      "58 59 60 61 62 64 71 73 74 76 80 81 82 83 84 85 86 87 89 90 91 92 94 95 101 102 103 104 105 "
      "106 107 108 109 110 111 116 130 131 132 169 170 273 274 283 284",
      kOsp, Inferred};
  for (const char* code : {"0", "1", "2", "3", "4", "9", "10", "11", "14", "15", "16", "17", "18",
                           "19", "20", "21", "22", "23", "30"})
    c.reading.g_codes.tell(code, kTable, Secondary);
  for (const char* code : {"56", "71", "73", "74", "76", "81", "82", "83", "84", "85", "86", "87",
                           "89", "90", "94", "95", "111"})
    c.reading.g_codes.tell(code, kPost, Secondary);
  c.reading.unlisted_codes = {UnlistedCode::NotKnown, kOsp, Inferred};
  c.reading.missing_end = {MissingEnd::Alarm, "OKA 2236", Secondary};
}

void calls(Control& c) {
  c.calls.max_nesting = {8, "OKA 2279", Secondary};
  c.calls.max_repeats = {9999, "OKA 2278", Secondary};
  c.calls.zero_repeats = {ZeroRepeats::Alarm, "OKA 2278: 1 to 9999", Secondary};
  c.calls.too_many_repeats = {TooManyRepeats::Alarm, "OKA 2278", Secondary};
  c.calls.main_return = {MainReturn::Alarm, "OKA 2279: more RTS than CALL", Secondary};
  c.calls.end_in_subprogram = {EndInSubprogram::EndsRun, kOsp, Inferred};
  no_role(c.calls.roles, {"M98", "M99", "M198", "G65", "G66", "G67", "M29"},
          "OKA 2280: programs are called by CALL", Secondary);
  c.macros.max_modal_calls = {8, "OKA 2279: eight levels after axis movement", Secondary};
  c.macros.cancel_alone = {CancelAlone::Alarm, "OKA 2279: more MODOUT than MODIN", Secondary};
  c.macros.second_modal_call = {SecondModal::Stacks, "OKA 2279: eight levels after axis movement",
                                Secondary};
  c.macros.modal_locals = {ModalLocals::Rewritten, kOsp, Inferred};
}

void motion(Control& c) {
  leave_out(c, RuleGroup::TurningRules, "of machining centers", Inferred);
  c.motion.g_meanings = {
      "10=neutral 11=not-computed 15=extra-system-by-h 16=not-computed 20=not-computed "
      "22=not-computed 30=not-computed 31=not-computed 43=not-computed 44=not-computed "
      "51=not-computed 53=length-off 54=not-computed 55=not-computed 56=length 57=not-computed "
      "58=not-computed 59=not-computed 60=not-computed 62=not-computed 73=not-computed "
      "74=not-computed 76=not-computed 81=not-computed 82=not-computed 83=not-computed "
      "84=not-computed 85=not-computed 86=not-computed 87=not-computed 89=not-computed "
      "92=not-computed",
      kOsp, Inferred};
  for (const char* entry : {"10=neutral", "11=not-computed", "15=extra-system-by-h",
                            "16=not-computed", "20=not-computed", "22=not-computed"})
    c.motion.g_meanings.tell(entry, kTable, Secondary);
  for (const char* entry :
       {"56=length", "73=not-computed", "74=not-computed", "76=not-computed", "81=not-computed",
        "82=not-computed", "83=not-computed", "84=not-computed", "85=not-computed",
        "86=not-computed", "87=not-computed", "89=not-computed"})
    c.motion.g_meanings.tell(entry, kPost, Secondary);
  c.motion.max_extra_systems = {200, kOsp, Inferred};
  c.motion.max_offset_number = {300, "OKP: length offsets up to 300", Secondary};
  c.motion.dwell_words = {"FP", "OKM, G4 F4. and G4 P2.; OKP, G04 F", Secondary};
  c.motion.dwell_unit = {DwellUnit::PSeconds, "OKM, G4 P2.", Secondary};
  c.motion.arc_tolerance = {20, "OKA 2252: 20 um", Secondary};
  has(c.common.refuses, {Cause::NoRadius}, "OKA 2252 4: I and K are zero", Secondary);
}

using Kind = VariableKind;

void add(Control& c, std::int32_t first, std::int32_t count, Kind kind, Access access,
         const char* source, Evidence evidence) {
  c.variables.push_back({first, first + count - 1, kind, access, 0, source, evidence});
}

/// Add the variables, at the numbers by which the language has them (okuma/system_variables.cpp).
void variables(Control& c) {
  c.variables.clear();
  add(c, 1, 32, Kind::Kept, Access::ReadWrite, "OKA 2220: V1 to V32", Secondary);
  add(c, 1001, 1000, Kind::Kept, Access::ReadWrite, kOsp, Inferred);
  add(c, 1'000'001, 1024, Kind::Input, Access::ReadOnly, "OKA 2237, VDIN[34]", Secondary);
  add(c, 1'100'001, 1024, Kind::Output, Access::WriteOnly, "OKA 2217, VDOUT[9]", Secondary);
  add(c, 2'000'000, 4000, Kind::ExtraWorkOffset, Access::ReadWrite, "OKM, VZOFX[PH]", Secondary);
  add(c, 3'000'001, 300, Kind::LengthGeometry, Access::ReadWrite, kOsp, Inferred);
  add(c, 3'100'001, 300, Kind::RadiusGeometry, Access::ReadWrite, kOsp, Inferred);
  add(c, 4'000'000, 1, Kind::ToolLength, Access::ReadOnly, "OKM, TLAC=VTLCN", Secondary);
  c.variables.back().address = 'T';
  c.variables.back().from = -1;
}

void alarms(Control& c) {
  static const AlarmList list = {"OKA",
                                 Secondary,
                                 true,
                                 "",
                                 {
#include "controls/okuma/alarms_p200.def"
                                 }};
  take_list(c, list);
}

}  // namespace

Control family() {
  Control c;
  c.dialect = "okuma";
  language(c);
  calls(c);
  motion(c);
  variables(c);
  alarms(c);
  return c;
}

}  // namespace cncsub::okuma
