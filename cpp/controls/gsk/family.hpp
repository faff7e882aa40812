// The parts that the GSK controls share: the 988s, the 980s, and the lathes among them.
#pragma once

#include "controls/alarm_list.hpp"
#include "controls/facts.hpp"
#include "controls/settings.hpp"

namespace cncsub::gsk {

using enum Evidence;

// Keys of sources.def.
inline const std::string k000 = "source 000, ";
inline const std::string k001 = "source 001, ";
inline const std::string kTA = "TA";
inline const std::string kTApar = "TApar ";
inline const std::string kTalm = "Talm ";
inline const std::string kTDi = "TDi";
inline const std::string kTDipar = "TDipar ";
inline const std::string kMDia = "MDia ";
inline const std::string kMDib = "MDib ";
inline const std::string kMDipar = "MDipar ";
inline const std::string kT928 = "928T1, ";
inline const std::string kGeneral = "general knowledge";
// A default, to be changed where a machine is known to differ.
inline const std::string kPolicy = "policy: nobody says";

/// Return the rules of the 988TA and the 988T.
Control family_988();
void add_988_motion(Control& c);

/// Return the rules of the 980TDi and the 980MDi for reading, calls and macros. Their motion is
/// that of a lathe and of a mill.
Control family_980();

/// Return the alarms of the 980MDi's own paper; the list of its manual is the family's.
const AlarmList& alarms_980mdi_b();

/// Add the motion of the lathes.
void add_lathe_motion(Control& c);

/// Add #4102 to #4120: the modal words of the block before.
void modal_words(Control& c, const std::string& addresses, const std::string& source,
                 Evidence evidence);

CodeCall code_call(CodeCall::Form form, char address, CodeCallKind kind, std::int32_t parameter,
                   std::int32_t program, std::int32_t count);

}  // namespace cncsub::gsk
