// The parts that the FANUC controls share.
#pragma once

#include "controls/alarm_list.hpp"
#include "controls/facts.hpp"
#include "controls/settings.hpp"

namespace cncsub::fanuc {

using enum Evidence;

// Keys of sources.def.
inline constexpr const char* kSource002 = "source 002";
inline constexpr const char* kSource003 = "source 003";
inline constexpr const char* kPb304 = "PB304";
inline constexpr const char* kPb155 = "PB155";
inline constexpr const char* kTb35 = "TB35";
inline constexpr const char* kPmi39 = "PMI39";
inline constexpr const char* kCex487 = "CEX487";
inline constexpr const char* k16Mc = "16MC p.293";
inline constexpr const char* k16Tc = "16TC p.67";
inline constexpr const char* k30i = "30i p.82";
inline constexpr const char* k30iM = "30iM p.73";
inline constexpr const char* k15iM = "15iM p.564";
inline constexpr const char* kAlm = "ALM";
inline constexpr const char* kReg = "REG";
inline constexpr const char* kGed = "GED";
inline constexpr const char* kRob = "ROB";
inline constexpr const char* kSin = "SIN";
inline constexpr const char* kZap = "ZAP";
inline constexpr const char* kCwS = "CW-S";
inline constexpr const char* kCwA = "CW-A";
inline constexpr const char* kCwG = "CW-G";
inline constexpr const char* kCl198 = "CL198";
inline constexpr const char* kX65 = "X-65";
inline constexpr const char* kXGo = "X-GO";
inline constexpr const char* kXNul = "X-NUL";
inline constexpr const char* kJix = "JIX";
inline constexpr const char* kXia = "XIA";
inline constexpr const char* kAli = "ALI";
inline constexpr const char* kFin = "FIN";
inline constexpr const char* kIso = "ISO";
inline constexpr const char* kA51 = "A51";
inline constexpr const char* k0iMd = "0iMD";
inline constexpr const char* kCncs = "CNCS";
inline constexpr const char* kRw = "RW";
inline constexpr const char* kNct = "NCT";
inline constexpr const char* kWup = "WUP";
inline constexpr const char* kM7v = "M7V";
inline constexpr const char* kPolicy = "policy, nobody says";

/// Return the 16i with all that later controls share: calls, macros, motion, parameters, variables.
Control family();

// The parts of the family that have files of their own.
void add_family_parameters(Control& c);
void add_family_variables(Control& c);
void add_family_motion(Control& c);

struct VariableRow {
  int first;
  int last;
  VariableKind kind;
  Access access;
  char address;
  const char* source;
  Evidence evidence;
};

inline constexpr Access kReadWrite = Access::ReadWrite;
inline constexpr Access kReadOnly = Access::ReadOnly;
inline constexpr Access kWriteOnly = Access::WriteOnly;

void add_variable(Control& c, const VariableRow& row);

/// Add the codes that call programs. G and M codes may be registered inside the given limits.
void code_calls(Control& c, int last_g, int first_sub_m, int last_sub_m, int first_macro_m,
                int last_macro_m);

/// Set the alarm that the 0i-D, 0i-F and 30i show for a function outside its domain; the 0i-D keeps
/// the 16i's overflow.
void domain_alarms(Control& c, Cause shown);

}  // namespace cncsub::fanuc
