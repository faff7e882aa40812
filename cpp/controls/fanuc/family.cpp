// FANUC: Series 16i/18i/21i with the 0i-A/B/C, 0i-D, 0i-F and 30i/31i/32i.
// The keys of the sources stand in sources.def.
#include <initializer_list>

#include "controls/facts.hpp"

namespace cncsub {
namespace {

using enum Evidence;

constexpr const char* kSource002 = "source 002";
constexpr const char* kSource003 = "source 003";
constexpr const char* kPb304 = "PB304";
constexpr const char* kPb155 = "PB155";
constexpr const char* kTb35 = "TB35";
constexpr const char* kPmi39 = "PMI39";
constexpr const char* kCex487 = "CEX487";
constexpr const char* k16Mc = "16MC p.293";
constexpr const char* k16Tc = "16TC p.67";
constexpr const char* k30i = "30i p.82";
constexpr const char* k30iM = "30iM p.73";
constexpr const char* k15iM = "15iM p.564";
constexpr const char* kAlm = "ALM";
constexpr const char* kReg = "REG";
constexpr const char* kGed = "GED";
constexpr const char* kRob = "ROB";
constexpr const char* kSin = "SIN";
constexpr const char* kZap = "ZAP";
constexpr const char* kCwS = "CW-S";
constexpr const char* kCwA = "CW-A";
constexpr const char* kCwG = "CW-G";
constexpr const char* kCl198 = "CL198";
constexpr const char* kX65 = "X-65";
constexpr const char* kXGo = "X-GO";
constexpr const char* kXNul = "X-NUL";
constexpr const char* kJix = "JIX";
constexpr const char* kXia = "XIA";
constexpr const char* kAli = "ALI";
constexpr const char* kFin = "FIN";
constexpr const char* kIso = "ISO";
constexpr const char* kA51 = "A51";
constexpr const char* k0iMd = "0iMD";
constexpr const char* kCncs = "CNCS";
constexpr const char* kRw = "RW";
constexpr const char* kNct = "NCT";
constexpr const char* kM7v = "M7V";
constexpr const char* kKnown = "general knowledge";
constexpr const char* kPolicy = "policy, nobody says";

/// Several sources of one rule.
std::string cite(std::initializer_list<const char*> sources) {
  std::string text;
  for (const char* source : sources) {
    if (!text.empty()) text += "; ";
    text += source;
  }
  return text;
}

// ---- parameters ----

struct ParameterRow {
  const char* name;
  double value;
  const char* meaning;
  const char* source;
  Evidence evidence;
  void (*effect)(Control&, double);
};

// Calls, returns and macros. All are 0 as delivered as far as this table knows.
constexpr ParameterRow kParameters[] = {
    {"0000#0", 0, "TVC: 1 = the number of characters of a block is checked (TV check)", kAlm,
     Secondary, nullptr},
    {"3202#0", 0, "NE8: 1 = programs O8000 to O8999 are protected", kZap, Secondary, nullptr},
    {"3202#4", 0, "NE9: 1 = programs O9000 to O9999 are protected", kZap, Secondary, nullptr},
    {"3401#0", 0,
     "DPI: a number without a point is 0 = increments, 1 = mm, inches, degrees or seconds", kKnown,
     Inferred,
     [](Control& c, double v) {
       c.whole_numbers.value = v != 0 ? WholeNumbers::Millimetres : WholeNumbers::Increments;
     }},
    {"3403#6", 0,
     "AD2: an address, or two codes of a G group, twice in a block: 0 = the later counts, 1 = "
     "alarm",
     kKnown, Inferred,
     [](Control& c, double v) {
       c.repeated_address.value = v != 0 ? RepeatedAddress::Alarm : RepeatedAddress::LastWins;
     }},
    {"3404#2", 0, "SBP: P of M198 is 0 = a file number, 1 = a program number", kCwS, Secondary,
     nullptr},
    {"3404#4", 0, "M30: 1 = M30 does not rewind", kKnown, Inferred, nullptr},
    {"3404#5", 0, "M02: 1 = M02 does not rewind", kKnown, Inferred, nullptr},
    {"3404#6", 0,
     "EOR: the end of a program without M02, M30 or M99: 0 = alarm, 1 = the control resets", kKnown,
     Inferred,
     [](Control& c, double v) {
       c.missing_end.value = v != 0 ? MissingEnd::Ends : MissingEnd::Alarm;
     }},
    {"3404#7", 0, "M3B: 0 = one M code of a block counts, 1 = three", kKnown, Inferred,
     [](Control& c, double v) { c.m_codes_per_block.value = v != 0 ? 3 : 1; }},
    {"3451#2", 0, "1 = S may have one decimal (mills)", kSin, Secondary, nullptr},
    {"6000#1", 0, "MGO: 1 = GOTO finds its block in a table of sequence numbers", kKnown, Inferred,
     nullptr},
    {"6000#3", 0, "V15: 1 = the variables of tool offsets are numbered as on the Series 15", kCwG,
     Secondary, nullptr},
    {"6000#4", 0, "HGO: 1 = GOTO looks first at the last 30 sequence numbers", kKnown, Inferred,
     nullptr},
    {"6000#5", 0, "SBM: 1 = single block stops at macro statements too", kCwG, Secondary, nullptr},
    {"6001#1", 0, "PRT: what DPRNT writes for leading zeros: 0 = blanks, 1 = nothing", kKnown,
     Inferred, nullptr},
    {"6001#3", 0, "PV5: which range of common variables is put out", kKnown, Inferred, nullptr},
    {"6001#4", 0, "CRO: DPRNT and BPRNT end with 0 = LF, 1 = CR LF", kKnown, Inferred, nullptr},
    {"6001#5", 0, "TCS: 1 = every T code calls O9000, with the T value in #149", kSource002,
     SourceDocument, nullptr},
    {"6001#6", 0, "CCV: 1 = reset keeps #100 to #199", kCwG, Secondary,
     [](Control& c, double v) { c.reset_clears_commons.value = v == 0; }},
    {"6001#7", 0, "CLV: 1 = reset keeps #1 to #33", kCwG, Secondary,
     [](Control& c, double v) { c.reset_clears_locals.value = v == 0; }},
    {"6003", 0, "interruption macro: bits MUS MCY MSB MPR TSE MIN", kKnown, Inferred, nullptr},
    {"6004#0", 0,
     "NAT: ATAN is 0 = 0 to 360, 1 = -180 to 180; ASIN is 0 = 270 to 90, 1 = -90 to 90", kAli,
     Secondary,
     [](Control& c, double v) {
       c.atan_range.value = v != 0 ? AngleRange::Signed : AngleRange::FullTurn;
       c.asin_range.value = v != 0 ? AngleRange::Signed : AngleRange::FullTurn;
     }},
    {"6007#1", 0,
     "SCS: 1 = every S code calls O9029, with the S value in #147 (the bit's number is from "
     "memory)",
     kKnown, Inferred, nullptr},
    {"6007#2", 0, "BCS: 1 = every B code calls O9028, with the B value in #146", kKnown, Inferred,
     nullptr},
    {"6007#3", 0, "MGE: 1 = G codes set as negative numbers call like G66.1, not like G66", kKnown,
     Inferred, nullptr},
    {"6007#4", 0, "CVA: what ADP sees of an argument without a point", kCwA, Secondary, nullptr},
    {"6008#1", 0, "MCA: #3000=n raises 0 = 3000+n with n to 200, 1 = n to 4095", kKnown, Inferred,
     [](Control& c, double v) {
       c.user_alarm_offset.value = v != 0 ? 0 : 3000;
       c.user_alarm_last.value = v != 0 ? 4095 : 200;
     }},
    {"6008#2", 0, "ADD: what DPRNT does when a value has more digits than its format", kKnown,
     Inferred, nullptr},
    {"6008#6", 0,
     "GMP: 1 = in a program called by a G code M, T and S codes call, and the other way round",
     kKnown, Inferred,
     [](Control& c, double v) {
       c.code_cascade.value = v != 0 ? CodeCascade::OtherKind : CodeCascade::None;
     }},
    {"6008#7", 0, "IJK: 1 = argument specification I only", kSource002, SourceDocument,
     [](Control& c, double v) {
       c.argument_sets.value = v != 0 ? ArgumentSets::First : ArgumentSets::ByOrder;
     }},
    {"6010", 0, "EIA code of *", kKnown, Inferred, nullptr},
    {"6011", 0, "EIA code of =", kKnown, Inferred, nullptr},
    {"6012", 0, "EIA code of #", kKnown, Inferred, nullptr},
    {"6013", 0, "EIA code of [", kKnown, Inferred, nullptr},
    {"6014", 0, "EIA code of ]", kKnown, Inferred, nullptr},
    {"6030", 0, "the M code that calls from the external device, 0 = M198", kKnown, Inferred,
     nullptr},
    {"6032", 0, "the M code of a program-entry call", kKnown, Inferred, nullptr},
    {"6033", 0, "the M code that permits macro interrupts, 0 = M96", kKnown, Inferred, nullptr},
    {"6034", 0, "the M code that forbids macro interrupts, 0 = M97", kKnown, Inferred, nullptr},
    {"6038", 0, "the first of a range of G codes that call macros", kKnown, Inferred, nullptr},
    {"6039", 0, "the program that the first G code of the range calls", kKnown, Inferred, nullptr},
    {"6040", 0, "how many G codes the range has", kKnown, Inferred, nullptr},
    {"6041", 0, "the first of a range of G codes with one decimal that call macros", kKnown,
     Inferred, nullptr},
    {"6042", 0, "the program that the first G code of that range calls", kKnown, Inferred, nullptr},
    {"6043", 0, "how many G codes with one decimal the range has", kKnown, Inferred, nullptr},
    {"6044", 0, "the first of a range of M codes that call subprograms", kKnown, Inferred, nullptr},
    {"6045", 0, "the program that the first M code of the range calls", kKnown, Inferred, nullptr},
    {"6046", 0, "how many M codes the range has", kKnown, Inferred, nullptr},
    {"6047", 0, "the first of a range of M codes that call macros", kKnown, Inferred, nullptr},
    {"6048", 0, "the program that the first M code of that range calls", kKnown, Inferred, nullptr},
    {"6049", 0, "how many M codes that range has", kKnown, Inferred, nullptr},
    {"6090", 0, "the letter (as its ASCII number) that calls O9004", kPmi39, Manual, nullptr},
    {"6091", 0, "the letter (as its ASCII number) that calls O9005", kPmi39, Manual, nullptr},
};

// Motion and modal state.
constexpr ParameterRow kMotionParameters[] = {
    {"0001#1", 0, "FCV: 1 = cycles in the one-block form of the Series 10/11/15", kKnown, Inferred,
     nullptr},
    {"1201#2", 0, "ZCL: 1 = the reference point return ends the local coordinate system", kKnown,
     Inferred, nullptr},
    {"1202#3", 0, "RLC: 1 = reset ends the local coordinate system", kKnown, Inferred, nullptr},
    {"1240", 0, "the first reference point, machine coordinates", kKnown, Inferred, nullptr},
    {"1241", 0, "the second reference point, machine coordinates", kKnown, Inferred, nullptr},
    {"1242", 0, "the third reference point, machine coordinates", kKnown, Inferred, nullptr},
    {"1243", 0, "the fourth reference point, machine coordinates", kKnown, Inferred, nullptr},
    {"1401#1", 0, "LRP: G00 moves 0 = each axis at its own rate, 1 = on a straight line", k30i,
     Manual, nullptr},
    {"1411", 0, "the feed in force at power-on, 0 = none", kKnown, Inferred, nullptr},
    {"3402#0", 0, "G01: at power-on 0 = G00, 1 = G01", kKnown, Inferred, nullptr},
    {"3402#1", 0, "G18: 1 = G18 at power-on (mills)", kKnown, Inferred, nullptr},
    {"3402#2", 0, "G19: 1 = G19 at power-on (mills)", kKnown, Inferred, nullptr},
    {"3402#3", 0, "G91: at power-on 0 = G90, 1 = G91", kKnown, Inferred, nullptr},
    {"3402#4", 0, "FPM: lathes at power-on 0 = feed per revolution, 1 = feed per minute", kKnown,
     Inferred, nullptr},
    {"3402#6", 0,
     "CLR: reset, M02 and M30 0 = keep the modal codes, 1 = go back to the power-on state", kKnown,
     Inferred, nullptr},
    {"3402#7", 0, "G23: at power-on 0 = G22, 1 = G23", kKnown, Inferred, nullptr},
    {"3403#4", 0,
     "RER: an arc whose radius is too small: 0 = a half circle inside the tolerance of 3410, 1 = "
     "alarm",
     kKnown, Inferred, nullptr},
    {"3403#5", 0, "CIR: an arc without R, I, J and K: 0 = a straight line, 1 = alarm", kKnown,
     Inferred, nullptr},
    {"3405#4", 0, "CCR: 1 = C and R make corners without a comma (lathes)", kKnown, Inferred,
     nullptr},
    {"3406", 0, "with CLR, the groups of G codes that reset does not change, first byte", kKnown,
     Inferred, nullptr},
    {"3407", 0, "with CLR, the groups of G codes that reset does not change, second byte", kKnown,
     Inferred, nullptr},
    {"3410", 0, "how much the radius of an arc's end may differ from its start's, 0 = not checked",
     k16Tc, Manual, nullptr},
    {"5001#0", 0, "TLC: 1 = the length offset works on the axis named in the block (type C)",
     kKnown, Inferred, nullptr},
    {"5001#1", 0, "TLB: 1 = the length offset works on the axis normal to the plane (type B)",
     kKnown, Inferred, nullptr},
    {"5003#0", 0, "SUP: the start-up of the radius offset is 0 = type A, 1 = type B", k16Mc, Manual,
     nullptr},
    {"5004#2", 0, "ODI: D is 0 = a radius, 1 = a diameter", kKnown, Inferred, nullptr},
    {"5114", 0, "the retract d of G73, mm", k30iM, Manual, nullptr},
    {"5115", 0, "the clearance d of G83, mm", k30iM, Manual, nullptr},
    {"5130", 0, "the run-out of a thread cycle", kKnown, Inferred, nullptr},
};

void add_parameter(Control& c, const ParameterRow& row) {
  c.parameters.push_back({row.name, row.value, row.meaning, row.source, row.evidence, row.effect});
}

/// Parameters of the same meaning: one a code, or one a buffering stop.
void add_parameters(Control& c, int first, int last, const char* meaning, const char* source,
                    Evidence evidence) {
  for (int number = first; number <= last; ++number)
    c.parameters.push_back({std::to_string(number), 0, meaning, source, evidence, nullptr});
}

void parameters_16i(Control& c) {
  for (const ParameterRow& row : kParameters) add_parameter(c, row);
  add_parameters(c, 3411, 3420, "an M code that stops the reading ahead", kTb35, Manual);
  add_parameters(c, 3421, 3432, "a limit of a range of M codes that stop the reading ahead", kTb35,
                 Manual);
  add_parameters(c, 6050, 6059,
                 "a G code that calls a macro: 6050 O9010 to 6059 O9019; negative = modal like G66",
                 kSource002, SourceDocument);
  add_parameters(c, 6071, 6079, "an M code that calls a subprogram: 6071 O9001 to 6079 O9009",
                 kSource002, SourceDocument);
  add_parameters(c, 6080, 6089, "an M code that calls a macro: 6080 O9020 to 6089 O9029",
                 kSource002, SourceDocument);
  for (const ParameterRow& row : kMotionParameters) add_parameter(c, row);
}

// ---- variables ----

struct VariableRow {
  int first;
  int last;
  VariableKind kind;
  Access access;
  char address;
  const char* source;
  Evidence evidence;
};

constexpr Access kReadWrite = Access::ReadWrite;
constexpr Access kReadOnly = Access::ReadOnly;
constexpr Access kWriteOnly = Access::WriteOnly;

// The numbers of a mill with tool offset memory C and eight axes.
constexpr VariableRow kVariables[] = {
    {0, 0, VariableKind::Vacant, kReadOnly, 0, kJix, Secondary},
    {1, 33, VariableKind::Local, kReadWrite, 0, kJix, Secondary},
    {1000, 1015, VariableKind::Input, kReadOnly, 0, kA51, Secondary},
    {1032, 1032, VariableKind::InputWord, kReadOnly, 0, kA51, Secondary},
    {1100, 1115, VariableKind::Output, kReadWrite, 0, kKnown, Inferred},
    {1132, 1133, VariableKind::OutputWord, kReadWrite, 0, kKnown, Inferred},
    {2001, 2200, VariableKind::LengthWear, kReadWrite, 0, kKnown, Inferred},
    {2201, 2400, VariableKind::LengthGeometry, kReadWrite, 0, kKnown, Inferred},
    {3000, 3000, VariableKind::UserAlarm, kWriteOnly, 0, kGed, Secondary},
    {3001, 3001, VariableKind::Milliseconds, kReadWrite, 0, kReg, Secondary},
    {3002, 3002, VariableKind::Hours, kReadWrite, 0, kReg, Secondary},
    {3003, 3004, VariableKind::Control1, kReadWrite, 0, kZap, Secondary},
    {3005, 3005, VariableKind::Settings, kReadWrite, 0, kKnown, Inferred},
    {3006, 3006, VariableKind::Message, kWriteOnly, 0, kZap, Secondary},
    {3007, 3007, VariableKind::Mirror, kReadOnly, 0, kKnown, Inferred},
    {3008, 3008, VariableKind::Restart, kReadOnly, 0, kKnown, Inferred},
    {3011, 3011, VariableKind::Date, kReadOnly, 0, kReg, Secondary},
    {3012, 3012, VariableKind::Time, kReadOnly, 0, kReg, Secondary},
    {3901, 3902, VariableKind::PartsCount, kReadWrite, 0, kKnown, Inferred},
    {4001, 4022, VariableKind::ModalCode, kReadOnly, 0, kReg, Secondary},
    {4102, 4102, VariableKind::ModalWord, kReadOnly, 'B', kReg, Secondary},
    {4107, 4107, VariableKind::ModalWord, kReadOnly, 'D', kReg, Secondary},
    {4109, 4109, VariableKind::ModalWord, kReadOnly, 'F', kReg, Secondary},
    {4111, 4111, VariableKind::ModalWord, kReadOnly, 'H', kReg, Secondary},
    {4113, 4113, VariableKind::ModalWord, kReadOnly, 'M', kReg, Secondary},
    {4114, 4114, VariableKind::ModalWord, kReadOnly, 'N', kReg, Secondary},
    {4115, 4115, VariableKind::ModalWord, kReadOnly, 'O', kReg, Secondary},
    {4119, 4119, VariableKind::ModalWord, kReadOnly, 'S', kReg, Secondary},
    {4120, 4120, VariableKind::ModalWord, kReadOnly, 'T', kReg, Secondary},
    {4130, 4130, VariableKind::ModalWord, kReadOnly, 'P', kKnown, Inferred},
    {5001, 5008, VariableKind::BlockEnd, kReadOnly, 0, kZap, Secondary},
    {5021, 5028, VariableKind::MachinePosition, kReadOnly, 0, kZap, Secondary},
    {5041, 5048, VariableKind::WorkPosition, kReadOnly, 0, kZap, Secondary},
    {5061, 5068, VariableKind::SkipPosition, kReadOnly, 0, kZap, Secondary},
    {5081, 5088, VariableKind::ActiveLength, kReadOnly, 0, kZap, Secondary},
    {5101, 5108, VariableKind::ServoError, kReadOnly, 0, kZap, Secondary},
    {5201, 5328, VariableKind::WorkOffset, kReadWrite, 0, kKnown, Inferred},
    {7001, 7948, VariableKind::ExtraWorkOffset, kReadWrite, 0, kKnown, Inferred},
    {10001, 10999, VariableKind::LengthWear, kReadWrite, 0, kKnown, Inferred},
    {11001, 11999, VariableKind::LengthGeometry, kReadWrite, 0, kKnown, Inferred},
    {12001, 12999, VariableKind::RadiusWear, kReadWrite, 0, kKnown, Inferred},
    {13001, 13999, VariableKind::RadiusGeometry, kReadWrite, 0, kKnown, Inferred},
};

// What the 30i adds: the running block's modal state, 300 work systems.
constexpr VariableRow kVariables30i[] = {
    {4201, 4230, VariableKind::ActiveCode, kReadOnly, 0, kKnown, Inferred},
    {4302, 4302, VariableKind::ActiveWord, kReadOnly, 'B', kKnown, Inferred},
    {4307, 4307, VariableKind::ActiveWord, kReadOnly, 'D', kKnown, Inferred},
    {4309, 4309, VariableKind::ActiveWord, kReadOnly, 'F', kKnown, Inferred},
    {4311, 4311, VariableKind::ActiveWord, kReadOnly, 'H', kKnown, Inferred},
    {4313, 4313, VariableKind::ActiveWord, kReadOnly, 'M', kKnown, Inferred},
    {4314, 4314, VariableKind::ActiveWord, kReadOnly, 'N', kKnown, Inferred},
    {4315, 4315, VariableKind::ActiveWord, kReadOnly, 'O', kKnown, Inferred},
    {4319, 4319, VariableKind::ActiveWord, kReadOnly, 'S', kKnown, Inferred},
    {4320, 4320, VariableKind::ActiveWord, kReadOnly, 'T', kKnown, Inferred},
    {4330, 4330, VariableKind::ActiveWord, kReadOnly, 'P', kKnown, Inferred},
    {14001, 19988, VariableKind::ExtraWorkOffset, kReadWrite, 0, kKnown, Inferred},
    // The positions once more, for more than 20 axes.
    {100001, 100050, VariableKind::BlockEnd, kReadOnly, 0, kKnown, Inferred},
    {100051, 100100, VariableKind::MachinePosition, kReadOnly, 0, kKnown, Inferred},
    {100101, 100150, VariableKind::WorkPosition, kReadOnly, 0, kKnown, Inferred},
    {100151, 100200, VariableKind::SkipPosition, kReadOnly, 0, k15iM, Secondary},
    {100201, 100250, VariableKind::ActiveLength, kReadOnly, 0, kKnown, Inferred},
    {100251, 100300, VariableKind::ServoError, kReadOnly, 0, kKnown, Inferred},
};

void add_variable(Control& c, const VariableRow& row) {
  c.variables.push_back(
      {row.first, row.last, row.kind, row.access, row.address, row.source, row.evidence});
}

/// The commons and what else of variables is bought. The addition is fitted here.
void variable_choices(Control& c) {
  c.commons = {"100-199 500-999", cite({kJix, "with the addition"}), Secondary};
  c.variable_options = {"", kPolicy, Inferred};
  c.variable_choices = {
      {"basic-commons",
       "the custom macro without added common variables",
       "100-149 500-531",
       {},
       kXia,
       Secondary},
      {"added-commons",
       "addition of custom macro common variables",
       "100-199 500-999",
       {},
       cite({kJix, "its name general knowledge"}),
       Inferred},
      {"commons-from-100", "common variables from #100 to #999", "100-999", {}, kKnown, Inferred},
  };
  VariableOption work{"work-offsets-by-axis",
                      "the work offsets of a mill by axis, #2500 to #2806",
                      "",
                      {},
                      cite({"real programs", "general knowledge"}),
                      Inferred};
  for (int first = 2500; first <= 2800; first += 100)
    work.variables.push_back(
        {first, first + 6, VariableKind::AxisWorkOffset, kReadWrite, 0, work.source, Inferred});
  c.variable_choices.push_back(std::move(work));
}

/// The embedded macro has commons of its own.
void embedded_macro(Control& c) {
  c.variable_choices.push_back({"embedded-macro",
                                "common variables #98000 to #98499",
                                "100-199 500-999 98000-98499",
                                {},
                                kKnown,
                                Inferred});
}

// ---- calls by code ----

/// The codes that call programs. G and M codes may be registered inside the given limits.
void code_calls(Control& c, int last_g, int first_sub_m, int last_sub_m, int first_macro_m,
                int last_macro_m) {
  using Form = CodeCall::Form;
  using Kind = CodeCallKind;
  const std::string sub_source = cite({kSource002, "the limits general knowledge"});
  c.code_calls = {
      // A negative number makes the call modal.
      {Form::List, 'G', Kind::Macro, 6050, 9010, 10, "", 0, 1, last_g, "", sub_source,
       SourceDocument},
      {Form::Range, 'G', Kind::Macro, 6038, 6039, 6040, "", 0, 1, last_g, "", kKnown, Inferred},
      {Form::List, 'M', Kind::Macro, 6080, 9020, 10, "", 0, first_macro_m, last_macro_m, "",
       sub_source, SourceDocument},
      {Form::Range, 'M', Kind::Macro, 6047, 6048, 6049, "", 0, first_macro_m, last_macro_m, "",
       kKnown, Inferred},
      {Form::List, 'M', Kind::Subprogram, 6071, 9001, 9, "", 0, first_sub_m, last_sub_m, "",
       sub_source, SourceDocument},
      {Form::Range, 'M', Kind::Subprogram, 6044, 6045, 6046, "", 0, first_sub_m, last_sub_m, "",
       kKnown, Inferred},
      {Form::Switch, 'T', Kind::Subprogram, 0, 9000, 0, "6001#5", 149, 0, 99999999, "",
       cite({kSource002, kPmi39}), SourceDocument},
      {Form::Switch, 'S', Kind::Subprogram, 0, 9029, 0, "6007#1", 147, 0, 99999999, "", kKnown,
       Inferred},
      {Form::Switch, 'B', Kind::Subprogram, 0, 9028, 0, "6007#2", 146, 0, 99999999, "", kKnown,
       Inferred},
      // The parameter holds the letter.
      {Form::List, '@', Kind::Subprogram, 6090, 9004, 1, "", 146, 0, 99999999, "", kPmi39, Manual},
      {Form::List, '@', Kind::Subprogram, 6091, 9005, 1, "", 147, 0, 99999999, "", kPmi39, Manual},
  };
}

// ---- alarms ----

constexpr const char* k16iList = "general knowledge of the 16i alarm list";
constexpr const char* k30iList = "general knowledge of the 30i alarm list";

/// What the 0i-D, 0i-F and 30i show for a function outside its domain; the 0i-D keeps the 16i's
/// overflow.
void domain_alarms(Control& c, Cause shown) {
  for (const Cause cause : {Cause::LogarithmOfNonPositive, Cause::ArcSineOutOfRange}) {
    c.alarms[cause] = c.alarms[shown];
    c.alarms[cause].source += " has the number; that it is raised here is inferred";
    c.alarms[cause].evidence = Inferred;
  }
}

// ---- G codes ----

// Mills and lathes (systems A, B and C) together, options included. Three-digit codes are the other
// spelling of codes with a point: G107 is G07.1, G112 and G113 are G12.1 and G13.1, G150-G152 are
// G40.1-G42.1, G250 and G251 are G50.2 and G51.2.
constexpr const char* kCodes16i =
    "0 1 2 2.1 2.2 2.3 3 3.1 3.2 3.3 4 5 5.1 5.4 6.2 7 7.1 8 9 10 10.6 11 12.1 13.1 15 16 17 18 19 "
    "20 21 22 23 24 25 26 "
    "27 28 29 30 30.1 31 31.1 31.2 31.3 31.8 32 33 34 35 36 37 39 40 40.1 41 41.1 42 42.1 43 44 45 "
    "46 47 48 49 50 50.1 "
    "50.2 50.3 51 51.1 51.2 52 53 54 54.1 54.2 55 56 57 58 59 60 61 62 63 64 65 66 67 68 69 70 71 "
    "72 72.1 72.2 73 74 75 "
    "76 77 78 79 80 81 81.1 82 83 84 84.2 84.3 85 86 87 88 89 90 91 92 92.1 93 94 95 96 97 98 99 "
    "107 112 113 150 151 152 "
    "160 161 250 251";
constexpr const char* kCodes0iD =
    "0 1 2 3 4 5 5.1 5.4 7.1 8 9 10 11 12.1 13.1 15 16 17 18 19 20 21 22 23 24 25 26 27 28 29 30 "
    "30.1 31 31.8 32 33 34 "
    "36 37 37.1 37.2 39 40 40.1 41 41.1 42 42.1 43 44 45 46 47 48 49 50 50.1 50.2 50.3 50.4 50.5 "
    "50.6 51 51.1 51.2 51.4 "
    "51.5 51.6 52 53 54 54.1 55 56 57 58 59 60 61 62 63 64 65 66 66.1 67 68 69 70 71 72 73 74 75 "
    "76 77 78 79 80 80.4 81 "
    "81.1 81.4 82 83 84 84.2 85 86 87 88 89 90 91 91.1 92 92.1 93 94 95 96 96.1 96.2 96.3 96.4 97 "
    "98 99 107 112 113 150 "
    "151 152 160 161 250 251";
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
constexpr const char* kCodes30i =
    "0 1 2 2.1 2.2 2.3 2.4 3 3.1 3.2 3.3 3.4 4 4.1 5 5.1 5.4 6.2 7 7.1 8 9 10 10.3 10.6 10.9 11 "
    "12.1 12.4 13.1 13.4 15 "
    "16 17 17.1 18 19 20 21 22 23 24 25 26 27 28 28.2 29 30 30.1 30.2 31 31.8 31.9 32 33 34 35 36 "
    "37 37.1 37.2 37.3 38 39 "
    "40 40.1 41 41.1 41.2 41.3 41.4 41.5 41.6 42 42.1 42.2 42.4 42.5 42.6 43 43.1 43.3 43.4 43.5 "
    "43.7 43.8 43.9 44 44.1 "
    "44.7 45 46 47 48 49 49.1 50 50.1 50.2 50.3 50.4 50.5 50.6 50.9 51 51.1 51.2 51.4 51.5 51.6 52 "
    "53 53.1 53.2 53.6 54 "
    "54.1 54.2 54.3 54.4 55 56 57 58 59 60 61 62 63 64 65 66 66.1 67 68 68.1 68.2 68.3 68.4 69 "
    "69.1 70 70.7 71 71.7 72 "
    "72.1 72.2 72.7 73 73.7 74 74.7 75 75.7 76 76.7 77 78 79 80 80.4 80.5 80.8 81 81.1 81.4 81.5 "
    "81.8 82 83 83.1 83.5 "
    "83.6 84 84.2 84.3 85 86 87 87.5 87.6 88 89 90 91 91.1 92 92.1 93 94 95 96 96.1 96.2 96.3 96.4 "
    "97 98 99 107 112 113 "
    "150 151 152 160 161 250 251";

// ---- the rules ----

void reading(Control& c) {
  c.semicolon = {Semicolon::EndOfBlock, cite({kPb155, "that a typed one ends the block is policy"}),
                 Inferred};
  c.percent_programs = {false, cite({kGed, "% opens and closes the file"}), Secondary};
  c.named_programs = {false, kKnown, Inferred};
  c.file_name_wins = {false, kKnown, Inferred};
  c.max_program_number = {9999, cite({kKnown, "eight digits are an option"}), Inferred};
  c.max_sequence_number = {99999, cite({kPb155, kXGo}), Manual};
  c.zero_numbers = {true, cite({kPb155, "0 must not be used, but no alarm is named: policy"}),
                    Inferred};
  c.sequence_number_first = {false, kPolicy, Inferred};
  c.cuts_fine_digits = {true, "general knowledge", Inferred};
  c.late_sequence_numbers = {true, kPolicy, Inferred};
  c.max_words = {26,
                 cite({kAlm, "5006", "not counted: the arguments of a macro call, up to 33 (ZAP)"}),
                 Secondary};
  c.max_block_length = {0, kPolicy, Inferred};
  c.max_digits = {8, cite({kKnown, "alarm text from ALM"}), Inferred};
  c.block_skip = {BlockSkip::Anywhere,
                  cite({kGed, kIso, "the slash inside a block general knowledge"}), Inferred};
  c.repeated_address = {RepeatedAddress::LastWins, cite({kKnown, "3403#6 AD2"}), Inferred};
  c.open_comment = {OpenComment::RestOfBlock, kPolicy, Inferred};
  c.point_addresses = {"ABCEFIJKQRUVWXYZ",
                       cite({kSin, kAlm, "the list, and E of threads, general knowledge"}),
                       Inferred};
  c.minus_addresses = {"ABCEFHIJKQRSUVWXYZ", cite({kKnown, "alarm 006 for M and P from ALM"}),
                       Inferred};
  c.whole_numbers = {WholeNumbers::Increments, cite({kKnown, "3401#0 DPI; GED has seen both"}),
                     Inferred};
  c.missing_end = {MissingEnd::Alarm, cite({kAlm, "5010; 3404#6 EOR"}), Secondary};
  c.m_codes_per_block = {1, cite({kKnown, "3404#7 M3B", kCex487}), Inferred};
  c.m_codes_alarm = {false, cite({kKnown, "3404#7 M3B"}), Inferred};
  c.m_codes_alone = {true, cite({kKnown, "alarm text 5016 from ALM"}), Inferred};
  c.bare_g = {false, cite({kKnown, "005"}), Inferred};
  c.g_codes = {kCodes16i, cite({kReg, kCncs, "the rest general knowledge"}), Inferred};
}

void calls_and_returns(Control& c) {
  c.name_marks = {"+-_.", "general knowledge", Inferred};
  c.return_alone_in_modal = {false, "no such alarm is known here", Inferred};
  c.program_word = {ProgramWord::CountAndNumber, cite({kGed, kRob}), Secondary};
  c.max_program_digits = {8, kGed, Secondary};
  c.count_and_l = {CountAndL::AllNumber, kKnown, Inferred};
  c.bracket_names = {false, kKnown, Inferred};
  c.max_name_length = {32, kKnown, Inferred};
  c.wide_names = {false, kKnown, Inferred};
  c.call_values = {CallValues::Rounded, cite({kSin, kJix}), Secondary};
  c.zero_count_alarms = {false, kPolicy, Inferred};
  c.omitted_program = {OmittedProgram::Alarm, cite({kKnown, "076"}), Inferred};
  c.start_word = {StartWord::None, cite({kKnown, "GED knows M98 Q on an 18i-T"}), Inferred};
  c.self_call = {SelfCall::Allowed, cite({kKnown, "only the nesting limit ends it"}), Inferred};
  c.caller_call = {CallerCall::Allowed, cite({kKnown, "only the nesting limit ends it"}), Inferred};
  c.max_repeats = {9999, kRob, Secondary};
  c.zero_repeats = {ZeroRepeats::Once, kPolicy, Inferred};
  c.too_many_repeats = {TooManyRepeats::Alarm, kPolicy, Inferred};
  c.max_nesting = {4, cite({kGed, kCwS, "MC52"}), Secondary};
  c.nesting_counts_macros = {false, cite({kRw, "4 + 4 levels"}), Secondary};
  c.max_macro_nesting = {4, kPb304, Manual};
  c.max_total_nesting = {8, cite({kRw, "4 + 4 levels"}), Secondary};
  c.mdi_calls = {MdiCalls::Allowed, "general knowledge; source 003 says no, for older controls",
                 Inferred};
  c.external_calls = {true, kCl198, Secondary};
  c.device_word = {false, kKnown, Inferred};
  c.return_search = {ReturnSearch::FromHead, cite({"policy", kFin}), Inferred};
  c.return_with_p = {ReturnWithP::AtOnce, kPolicy, Inferred};
  c.return_with_l = {ReturnWithL::Ignored, cite({kKnown, "unsure"}), Inferred};
  c.main_return = {MainReturn::Restarts, cite({kSource003, kGed, "WEI"}), SourceDocument};
  c.jump_m97 = {false, kKnown, Inferred};
  c.restart_m_code = {0, kKnown, Inferred};
  c.calls_in_modal = {CallsInModal::Allowed, kKnown, Inferred};
  c.codes_not_with_return = {"", kKnown, Inferred};
  c.codes_not_with_call = {"", kKnown, Inferred};
  c.words_with_call_in_cycle = {true, cite({kKnown, "5329 only in late editions"}), Inferred};
}

void macro_statements(Control& c) {
  c.reset_clears_locals = {true, "CW-G, parameter 6001#7 CLV", Secondary};
  c.reset_clears_commons = {true, "CW-G, parameter 6001#6 CCV", Secondary};
  c.vacant_system_writes = {true, kPolicy, Inferred};
  c.max_constant_digits = {8, "general knowledge", Inferred};
  c.max_condition_length = {0, kPolicy, Inferred};
  c.statements = {"# [ IF WHILE DO DPRNT BPRNT POPEN PCLOS", cite({kXGo, kFin, kAlm}), Secondary};
  c.if_form = {IfForm::GotoThen, cite({kXGo, kFin}), Secondary};
  c.loop_form = {LoopForm::DoEnd, cite({kXGo, kAlm}), Secondary};
  c.jumps = {true, kXGo, Secondary};
  c.jumps_in_mdi = {false, cite({kAlm, "0123"}), Secondary};
  c.jump_search = {JumpSearch::ForwardThenHead, cite({kFin, "the order is policy"}), Inferred};
  c.max_jump_number = {99999, kXGo, Secondary};
  c.max_loop_number = {3, cite({kAlm, kIso}), Secondary};
  c.max_loops = {3, cite({kKnown, kIso}), Inferred};
  c.loops_count_across_calls = {false, kPolicy, Inferred};
  c.max_ifs = {0, cite({kFin, "no IF blocks: THEN takes one statement"}), Secondary};
  c.max_brackets = {5, cite({kXNul, kAlm}), Secondary};
  c.angle_unit = {AngleUnit::Degrees, kAli, Secondary};
  c.atan_range = {AngleRange::FullTurn, cite({kAli, "6004#0 NAT"}), Secondary};
  c.asin_range = {AngleRange::FullTurn, cite({kAli, "6004#0 NAT"}), Secondary};
  c.joined_conditions = {false, kKnown, Inferred};
  c.comparison_symbols = {false, kKnown, Inferred};
  c.conditions_without_brackets = {false, kXGo, Secondary};
  c.short_functions = {true, kKnown, Inferred};
  c.functions = {"SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP BIN BCD", kAli,
                 Secondary};
  c.modulo = {false, kKnown, Inferred};
  c.vacant_address = {VacantAddress::Ignored, cite({kXia, kJix}), Secondary};
  c.vacant_comparison = {VacantComparison::Distinguished, cite({kM7v, "TSN"}), Secondary};
  c.variable_point = {false, kPolicy, Inferred};
  c.indirect_9nnn = {false, kKnown, Inferred};
  c.negative_logic = {true, cite({kAli, "on 32-bit whole numbers, general knowledge"}), Inferred};
  c.variable_names = {false, kKnown, Inferred};
}

void macro_calls(Control& c) {
  c.codes_not_with_macro_call = {"", "G as an argument is illegal-argument", Inferred};
  c.m_codes_not_with_macro_call = {"", "M is the argument #13", Inferred};
  c.codes_not_with_modal_call = {"", "G as an argument is illegal-argument", Inferred};
  c.macro_calls = {true, cite({kSource002, kPb304}), SourceDocument};
  c.modal_every_block = {false, kKnown, Inferred};
  c.max_macro_digits = {8, cite({kKnown, "a number that no program has is not found"}), Inferred};
  c.argument_sets = {ArgumentSets::ByOrder,
                     cite({kKnown, "6008#7 IJK; agrees with source 002 and PB304"}), Inferred};
  c.numbered_axis_arguments = {false, cite({kZap, "INT"}), Secondary};
  c.call_passes_words = {false, kPb304, Manual};
  c.words_before_macro_call = {WordsBeforeMacroCall::Alarm, cite({"policy", kX65, kPmi39}),
                               Inferred};
  c.repeated_argument = {RepeatedAddress::LastWins, kKnown, Inferred};
  c.modal_locals = {ModalLocals::Kept, kKnown, Inferred};
  c.modal_trigger = {ModalTrigger::Move, cite({kM7v, kNct, kCwA}), Secondary};
  c.modal_calls_stack = {true, cite({kNct, kM7v}), Secondary};
  c.max_modal_calls = {3, "general knowledge: 122, the macro modal call is specified four-fold",
                       Inferred};
  c.cancel_alone = {CancelAlone::Ignored, cite({kKnown, "unsure"}), Inferred};
  c.h_codes = {false, kKnown, Inferred};
  c.code_cascade = {CodeCascade::None, cite({kRw, kKnown}), Secondary};
  c.user_alarm_offset = {3000, cite({kKnown, kGed}), Inferred};
  c.user_alarm_last = {200, kKnown, Inferred};
  c.h99_offset = {0, kKnown, Inferred};
  c.logic_binds_last = {false, cite({kNct, kKnown}), Secondary};
}

Control fanuc_16i() {
  Control c;
  c.name = "fanuc-16i";
  c.title = "FANUC Series 16i/18i/21i, 0i-A/B/C";
  reading(c);
  calls_and_returns(c);
  macro_statements(c);
  macro_calls(c);
  parameters_16i(c);
  for (const VariableRow& row : kVariables) add_variable(c, row);
  variable_choices(c);
  code_calls(c, 255, 1, 97, 6, 255);
  take_list(c, fanuc_16i_alarms(), "", k16iList);
  for (const auto& [cause, source] : {std::pair{Cause::Overflow, kJix},
                                      {Cause::LogarithmOfNonPositive, kAli},
                                      {Cause::ArcSineOutOfRange, kAli}}) {
    c.alarms[cause].source = source;
    c.alarms[cause].evidence = Secondary;
  }
  return c;
}

/// Like the 16i, with deeper nesting, G66.1, M98 Q, joined conditions and the alarm numbers of the
/// 30i.
Control fanuc_0i_d() {
  Control c = fanuc_16i();
  c.name = "fanuc-0i-d";
  c.return_alone_in_modal = {true, "ALM PS1093", Secondary};
  c.max_constant_digits = {12, "general knowledge", Inferred};
  c.title = "FANUC Series 0i-D";
  c.g_codes = {kCodes0iD, cite({k0iMd, kReg, "the rest general knowledge"}), Inferred};
  c.max_nesting = {10, kKnown, Inferred};
  c.nesting_counts_macros = {false, kKnown, Inferred};
  c.max_macro_nesting = {5, kKnown, Inferred};
  c.max_modal_calls = {5, cite({kKnown, "ALM PS0122 counts them as other macro calls"}), Inferred};
  c.max_total_nesting = {15, cite({kKnown, "ALM PS0077 speaks of the total number"}), Inferred};
  c.start_word = {StartWord::None, cite({kKnown, "Q with 6005#0 SQC, GED for its meaning"}),
                  Inferred};
  c.omitted_program = {OmittedProgram::Alarm, cite({kKnown, "M98 Q with 6005#0 SQC"}), Inferred};
  c.return_with_l = {ReturnWithL::ReplacesCount,
                     cite({kKnown, "unsure; ALM PS1093 lets L stand with M99"}), Inferred};
  c.words_with_call_in_cycle = {false, cite({kAlm, "PS5329"}), Secondary};
  c.joined_conditions = {false, cite({kKnown, "6006#0 MLG"}), Inferred};
  c.short_functions = {true, "0i-MD shops", Secondary};
  c.functions = {"SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP POW BIN BCD",
                 cite({kAli, "POW general knowledge, unsure"}), Inferred};
  c.modulo = {true, kKnown, Inferred};
  c.variable_names = {true, cite({kAlm, "PS1096 to PS1142"}), Secondary};
  c.modal_every_block = {true, cite({kAlm, "PS0129 names it"}), Secondary};
  c.cancel_alone = {CancelAlone::Alarm, cite({kAlm, "PS1100; 6000#0"}), Secondary};

  add_parameter(c, {"6000#0", 0, "G67: G67 without a modal call: 0 = alarm, 1 = ignored", kKnown,
                    Inferred, [](Control& k, double v) {
                      k.cancel_alone.value = v != 0 ? CancelAlone::Ignored : CancelAlone::Alarm;
                    }});
  add_parameter(
      c, {"6005#0", 0, "SQC: 1 = M98 Q starts at a sequence number; without P in the own program",
          kKnown, Inferred, [](Control& k, double v) {
            k.start_word.value = v != 0 ? StartWord::Q : StartWord::None;
            k.omitted_program.value = v != 0 ? OmittedProgram::OwnFromStart : OmittedProgram::Alarm;
          }});
  add_parameter(c, {"6006#0", 0, "MLG: 1 = AND, OR and XOR may join conditions", kKnown, Inferred,
                    [](Control& k, double v) { k.joined_conditions.value = v != 0; }});

  code_calls(c, 9999, 3, 99999999, 3, 99999999);
  c.alarms.clear();
  take_list(c, fanuc_30i_alarms(), kAlm, k30iList);
  domain_alarms(c, Cause::Overflow);
  c.user_alarm_prefix = "MC";
  c.user_alarm_digits = 4;
  return c;
}

/// Like the 0i-D, with program names, eight-digit numbers and the functions of the 30i.
Control fanuc_0i_f() {
  Control c = fanuc_0i_d();
  c.name = "fanuc-0i-f";
  c.title = "FANUC Series 0i-F";
  c.named_programs = {true, kKnown, Inferred};
  c.max_program_number = {99999999, kKnown, Inferred};
  c.max_sequence_number = {99999999, cite({kAlm, "PS1128; that the 0i-F has it is unsure"}),
                           Inferred};
  c.max_jump_number = {99999999, cite({kAlm, "PS1128; that the 0i-F has it is unsure"}), Inferred};
  c.max_digits = {9, kKnown, Inferred};
  c.g_codes = {kCodes0iF, cite({k0iMd, kReg, kCncs, "the rest general knowledge"}), Inferred};
  c.functions = {"SIN COS TAN ASIN ACOS ATAN SQRT ABS ROUND FIX FUP LN EXP POW BIN BCD ADP PRM",
                 cite({kAli, "POW, ADP and PRM general knowledge"}), Inferred};
  domain_alarms(c, Cause::ArgumentOutOfRange);
  embedded_macro(c);
  return c;
}

/// Like the 0i-F, with more variables, repeat counts of eight digits and an alarm for M99 in the
/// main program to choose.
Control fanuc_30i() {
  Control c = fanuc_0i_f();
  c.name = "fanuc-30i";
  c.title = "FANUC Series 30i/31i/32i";
  c.max_sequence_number = {99999999, cite({kAlm, "PS1128"}), Secondary};
  c.max_jump_number = {99999999, cite({kAlm, "PS1128"}), Secondary};
  c.max_repeats = {99999999, kKnown, Inferred};
  c.g_codes = {kCodes30i, cite({kReg, kCncs, kAlm, "the rest general knowledge"}), Inferred};
  add_parameter(c, {"7712#4", 0, "AMM: M99 in the main program: 0 = starts it over, 1 = alarm",
                    kAlm, Secondary, [](Control& k, double v) {
                      k.main_return.value = v != 0 ? MainReturn::Alarm : MainReturn::Restarts;
                    }});
  add_parameter(
      c, {"19607#2", 0, "the radius offset goes round an acute corner 0 = on lines, 1 = on an arc",
          kKnown, Inferred, nullptr});
  for (const VariableRow& row : kVariables30i) add_variable(c, row);
  c.commons = {"100-199 500-999 98000-98499", cite({kJix, "#98000 general knowledge"}), Inferred};
  for (VariableRange& range : c.variables) {
    if (range.kind == VariableKind::Date || range.kind == VariableKind::Time)
      range.access = Access::ReadWrite;
    if (range.kind == VariableKind::InputWord) range.last = 1035;  // general knowledge, as #4030
    if (range.kind == VariableKind::ModalCode) range.last = 4030;
    // Positions of 20 axes. [15iM p.564: #5061 to #5080]
    if (range.first % 20 == 1 && range.first >= 5001 && range.first <= 5101) {
      range.last = range.first + 19;
      if (range.kind == VariableKind::SkipPosition) range.source = k15iM;
    }
  }
  return c;
}

}  // namespace

std::vector<Control> fanuc_controls() {
  return {fanuc_16i(), fanuc_0i_d(), fanuc_0i_f(), fanuc_30i()};
}

}  // namespace cncsub
