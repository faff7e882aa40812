// FANUC Series 0i-F.
#include "controls/fanuc/family.hpp"

namespace cncsub {

using namespace fanuc;

namespace {

constexpr const char* kCodes0iF =
    "0 1 2 2.2 3 3.2 4 5 5.1 5.4 7.1 8 9 10 10.6 10.9 11 12.1 13.1 15 16 17 17.1 18 19 20 21 22 23 "
    "24 25 26 27 28 29 30 "
    "30.1 31 31.8 32 33 34 35 36 37 37.1 37.2 38 39 40 40.1 41 41.1 42 42.1 43 43.7 44 45 46 47 48 "
    "49 50 50.1 50.2 50.3 "
    "50.4 50.5 50.6 51 51.1 51.2 51.4 51.5 51.6 52 53 53.1 53.6 54 54.1 54.2 55 56 57 58 59 60 61 "
    "62 63 64 65 66 66.1 67 "
    "68 68.1 68.2 68.3 68.4 69 69.1 70 71 72 72.1 72.2 73 74 75 76 77 78 79 80 80.4 80.5 81 81.1 "
    "81.4 81.5 82 83 83.1 "
    "83.5 83.6 84 84.2 85 86 87 87.5 87.6 88 89 90 91 91.1 92 92.1 93 94 95 96 96.1 96.2 96.3 96.4 "
    "97 98 99 107 112 113 "
    "150 151 152 160 161 250 251";

}  // namespace

/// Like the 0i-D, with program names, eight-digit numbers and the functions of the 30i.
Control fanuc_0i_f() {
  Control c = fanuc_0i_d();
  c.title = "FANUC Series 0i-F";
  has(c.reading.program_heads, {ProgramHead::Name}, kKnown, Inferred);
  c.reading.max_program_number = {99999999, kKnown, Inferred};
  c.reading.max_sequence_number = {99999999, cite({kAlm, "PS1128; that the 0i-F has it is unsure"}),
                                   Inferred};
  c.calls.max_jump_number = {99999999, cite({kAlm, "PS1128; that the 0i-F has it is unsure"}),
                              Inferred};
  c.reading.max_digits = {9, kKnown, Inferred};
  c.reading.g_codes = {kCodes0iF, cite({k0iMd, kReg, kCncs, "the rest general knowledge"}),
                       Inferred};
  c.macros.functions = {
      "SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP POW BIN BCD ADP PRM MOD",
      cite({kAli, "POW, ADP, PRM and MOD general knowledge"}), Inferred};
  domain_alarms(c, Cause::ArgumentOutOfRange);

  // The embedded macro has commons of its own.
  c.variable_choices.push_back({"embedded-macro",
                                "common variables #98000 to #98499",
                                "100-199 500-999 98000-98499",
                                {},
                                kKnown,
                                Inferred});
  return c;
}

}  // namespace cncsub
