// FANUC Series 0i-F.
#include "controls/fanuc/family.hpp"

namespace cncsub {

using namespace fanuc;

namespace {

/// The codes that the 0i-F has and the 0i-D does not.
constexpr const char* kMoreCodes =
    "2.2 3.2 10.6 10.9 17.1 35 38 43.7 53.1 53.6 54.2 68.1 68.2 68.3 68.4 69.1 72.1 72.2 80.5 "
    "81.5 83.1 83.5 83.6 87.5 87.6";

}  // namespace

/// Like the 0i-D, with program names, eight-digit numbers and the functions of the 30i.
Control fanuc_0i_f() {
  Control c = fanuc_0i_d();
  c.title = "FANUC Series 0i-F";
  has(c.reading.program_heads, {ProgramHead::Name}, cite({kAlm, "PS0310, PS0311: calls by name"}),
      Secondary);
  c.reading.max_program_number = {99999999, kKnown, Inferred};
  c.reading.max_sequence_number = {99999999, cite({kAlm, "PS1128; that the 0i-F has it is unsure"}),
                                   Inferred};
  c.calls.max_jump_number = {99999999, cite({kAlm, "PS1128; that the 0i-F has it is unsure"}),
                             Inferred};
  c.reading.max_digits = {9, kKnown, Inferred};
  c.reading.g_codes = {with(c.reading.g_codes.value, kMoreCodes),
                       cite({k0iMd, kReg, kCncs, "the rest general knowledge"}), Inferred};
  c.macros.functions = {
      "SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP POW BIN BCD ADP PRM MOD",
      cite({kAli, "CSH", "MOD, POW and ADP", kWup, "PRM"}), Secondary};
  c.macros.functions.tell("POW", cite({kAlm, "1120 names it"}), Secondary);
  domain_alarms(c, Cause::ArgumentOutOfRange);

  // The commons of the embedded macro are its own.
  c.variable_choices.push_back({"embedded-macro",
                                "common variables #98000 to #98499",
                                "100-199 500-999 98000-98499",
                                {},
                                kKnown,
                                Inferred});
  return c;
}

}  // namespace cncsub
