// The parameters that the FANUC controls share.
#include "controls/fanuc/family.hpp"

namespace cncsub::fanuc {
namespace {

// Calls, returns and macros. All are 0 as delivered as far as this table knows.
const Parameter kParameters[] = {
    {"0000#0", 0, "TVC: 1 = the number of characters of a block is checked (TV check)", kAlm,
     Secondary},
    {"3202#0", 0, "NE8: 1 = programs O8000 to O8999 are protected", kZap, Secondary},
    {"3202#4", 0, "NE9: 1 = programs O9000 to O9999 are protected", kZap, Secondary},
    {"3401#0",
     0,
     "DPI: a number without a point is 0 = increments, 1 = mm, inches, degrees or seconds",
     kKnown,
     Inferred,
     {bit(rule::whole_numbers, WholeNumbers::Increments, WholeNumbers::Millimetres)}},
    {"3403#6",
     0,
     "AD2: an address, or two codes of a G group, twice in a block: 0 = the later counts, 1 = "
     "alarm",
     kKnown,
     Inferred,
     {bit(rule::repeated_address, RepeatedAddress::LastWins, RepeatedAddress::Alarm)}},
    {"3404#2", 0, "SBP: P of M198 is 0 = a file number, 1 = a program number", kCwS, Secondary},
    {"3404#4", 0, "M30: 1 = M30 does not rewind", kKnown, Inferred},
    {"3404#5", 0, "M02: 1 = M02 does not rewind", kKnown, Inferred},
    {"3404#6",
     0,
     "EOR: the end of a program without M02, M30 or M99: 0 = alarm, 1 = the control resets",
     kKnown,
     Inferred,
     {bit(rule::missing_end, MissingEnd::Alarm, MissingEnd::Ends)}},
    {"3404#7",
     0,
     "M3B: 0 = one M code of a block counts, 1 = three",
     kKnown,
     Inferred,
     {bit(rule::m_codes_per_block, 1, 3)}},
    {"3451#2", 0, "1 = S may have one decimal (mills)", kSin, Secondary},
    {"6000#1", 0, "MGO: 1 = GOTO finds its block in a table of sequence numbers", kKnown, Inferred},
    {"6000#3", 0, "V15: 1 = the variables of tool offsets are numbered as on the Series 15", kCwG,
     Secondary},
    {"6000#4", 0, "HGO: 1 = GOTO looks first at the last 30 sequence numbers", kKnown, Inferred},
    {"6000#5", 0, "SBM: 1 = single block stops at macro statements too", kCwG, Secondary},
    {"6001#1", 0, "PRT: what DPRNT writes for leading zeros: 0 = blanks, 1 = nothing", kKnown,
     Inferred},
    {"6001#3", 0, "PV5: which range of common variables is put out", kKnown, Inferred},
    {"6001#4", 0, "CRO: DPRNT and BPRNT end with 0 = LF, 1 = CR LF", kKnown, Inferred},
    {"6001#5", 0, "TCS: 1 = every T code calls O9000, with the T value in #149", kSource002,
     SourceDocument},
    {"6001#6",
     0,
     "CCV: 1 = reset keeps #100 to #199",
     kCwG,
     Secondary,
     {entry_while_zero(rule::reset_clears, Cleared::Commons)}},
    {"6001#7",
     0,
     "CLV: 1 = reset keeps #1 to #33",
     kCwG,
     Secondary,
     {entry_while_zero(rule::reset_clears, Cleared::Locals)}},
    {"6003", 0, "interruption macro: bits MUS MCY MSB MPR TSE MIN", kKnown, Inferred},
    {"6004#0",
     0,
     "NAT: ATAN is 0 = 0 to 360, 1 = -180 to 180; ASIN is 0 = 270 to 90, 1 = -90 to 90",
     kAli,
     Secondary,
     {bit(rule::atan_range, AngleRange::FullTurn, AngleRange::Signed),
      bit(rule::asin_range, AngleRange::FullTurn, AngleRange::Signed)}},
    {"6007#1", 0,
     "SCS: 1 = every S code calls O9029, with the S value in #147 (the bit's number is from "
     "memory)",
     kKnown, Inferred},
    {"6007#2", 0, "BCS: 1 = every B code calls O9028, with the B value in #146", kKnown, Inferred},
    {"6007#3", 0, "MGE: 1 = G codes set as negative numbers call like G66.1, not like G66", kKnown,
     Inferred},
    {"6007#4", 0, "CVA: what ADP sees of an argument without a point", kCwA, Secondary},
    {"6008#1",
     0,
     "MCA: #3000=n raises 0 = 3000+n with n to 200, 1 = n to 4095",
     kKnown,
     Inferred,
     {bit(rule::user_alarm_offset, 3000, 0), bit(rule::user_alarm_last, 200, 4095)}},
    {"6008#2", 0, "ADD: what DPRNT does when a value has more digits than its format", kKnown,
     Inferred},
    {"6008#6",
     0,
     "GMP: 1 = in a program called by a G code M, T and S codes call, and the other way round",
     kKnown,
     Inferred,
     {bit(rule::code_cascade, CodeCascade::None, CodeCascade::OtherKind)}},
    {"6008#7",
     0,
     "IJK: 1 = argument specification I only",
     kSource002,
     SourceDocument,
     {bit(rule::argument_sets, ArgumentSets::ByOrder, ArgumentSets::First)}},
    {"6010", 0, "EIA code of *", kKnown, Inferred},
    {"6011", 0, "EIA code of =", kKnown, Inferred},
    {"6012", 0, "EIA code of #", kKnown, Inferred},
    {"6013", 0, "EIA code of [", kKnown, Inferred},
    {"6014", 0, "EIA code of ]", kKnown, Inferred},
    {"6030",
     0,
     "the M code that calls from the external device, 0 = M198",
     kKnown,
     Inferred,
     {code_of(Role::ExternalCall, 198)}},
    {"6032", 0, "the M code of a program-entry call", kKnown, Inferred},
    {"6033", 0, "the M code that permits macro interrupts, 0 = M96", kKnown, Inferred},
    {"6034", 0, "the M code that forbids macro interrupts, 0 = M97", kKnown, Inferred},
    {"6038", 0, "the first of a range of G codes that call macros", kKnown, Inferred},
    {"6039", 0, "the program that the first G code of the range calls", kKnown, Inferred},
    {"6040", 0, "how many G codes the range has", kKnown, Inferred},
    {"6041", 0, "the first of a range of G codes with one decimal that call macros", kKnown,
     Inferred},
    {"6042", 0, "the program that the first G code of that range calls", kKnown, Inferred},
    {"6043", 0, "how many G codes with one decimal the range has", kKnown, Inferred},
    {"6044", 0, "the first of a range of M codes that call subprograms", kKnown, Inferred},
    {"6045", 0, "the program that the first M code of the range calls", kKnown, Inferred},
    {"6046", 0, "how many M codes the range has", kKnown, Inferred},
    {"6047", 0, "the first of a range of M codes that call macros", kKnown, Inferred},
    {"6048", 0, "the program that the first M code of that range calls", kKnown, Inferred},
    {"6049", 0, "how many M codes that range has", kKnown, Inferred},
    {"6090", 0, "the letter (as its ASCII number) that calls O9004", kPmi39, Manual},
    {"6091", 0, "the letter (as its ASCII number) that calls O9005", kPmi39, Manual},
};

// Motion and modal state.
const Parameter kMotionParameters[] = {
    {"1201#2", 0, "ZCL: 1 = the reference point return ends the local coordinate system", kKnown,
     Inferred},
    {"1240", 0, "the first reference point, machine coordinates", kKnown, Inferred},
    {"1241", 0, "the second reference point, machine coordinates", kKnown, Inferred},
    {"1242", 0, "the third reference point, machine coordinates", kKnown, Inferred},
    {"1243", 0, "the fourth reference point, machine coordinates", kKnown, Inferred},
    {"3402#1", 0, "G18: 1 = G18 at power-on (mills)", kKnown, Inferred},
    {"3402#2", 0, "G19: 1 = G19 at power-on (mills)", kKnown, Inferred},
    {"3406", 0, "with CLR, the groups of G codes that reset does not change, first byte", kKnown,
     Inferred},
    {"3407", 0, "with CLR, the groups of G codes that reset does not change, second byte", kKnown,
     Inferred},
    {"5004#2", 0, "ODI: D is 0 = a radius, 1 = a diameter", kKnown, Inferred},
};

/// Parameters of the same meaning: one a code, or one a buffering stop.
void add_range(Control& c, int first, int last, const char* meaning, const char* source,
               Evidence evidence) {
  for (int number = first; number <= last; ++number)
    c.parameters.push_back({std::to_string(number), 0, meaning, source, evidence});
}

}  // namespace

void add_family_parameters(Control& c) {
  add_parameters(c, kParameters);
  add_range(c, 3411, 3420, "an M code that stops the reading ahead", kTb35, Manual);
  add_range(c, 3421, 3432, "a limit of a range of M codes that stop the reading ahead", kTb35,
            Manual);
  add_range(c, 6050, 6059,
            "a G code that calls a macro: 6050 O9010 to 6059 O9019; negative = modal like G66",
            kSource002, SourceDocument);
  add_range(c, 6071, 6079, "an M code that calls a subprogram: 6071 O9001 to 6079 O9009",
            kSource002, SourceDocument);
  add_range(c, 6080, 6089, "an M code that calls a macro: 6080 O9020 to 6089 O9029", kSource002,
            SourceDocument);
  add_parameters(c, kMotionParameters);
}

}  // namespace cncsub::fanuc
