// Siemens SINUMERIK ONE, a mill, in its own language (not in ISO mode).
// The keys of the sources stand in sources.def. What they do not say is as in the family.
#include "controls/alarm_list.hpp"
#include "controls/facts.hpp"
#include "controls/siemens/family.hpp"

namespace cncsub {
namespace {

using enum Evidence;

using siemens::kKnown;
// The list of M commands in the ISO dialect of a sister, which names those of both languages.
constexpr const char* kIsoM = "802DM p.44, list of M commands";
constexpr const char* kManual = "SONE p.45, the words that end a program";

void calls_and_returns(Control& c) {
  leave_out(c, RuleGroup::TurningRules, kManual, Inferred);
  c.calls.max_nesting = {15, "828D p.490: 16 program levels, the main program is on the first",
                         Secondary};
  c.calls.search_path = {"SPF.DIR CALLPATH CUS.DIR CMA.DIR CST.DIR",
                         "SONE p.559-560: search path for subprogram call", Manual};
  c.calls.main_return = {MainReturn::Ends, kManual, Manual};
  c.calls.max_repeats = {9999, kKnown, Inferred};
  c.calls.zero_repeats = {ZeroRepeats::Alarm, kKnown, Inferred};
  c.calls.end_in_subprogram = {
      EndInSubprogram::Returns,
      "MD840, MD 20800: M17 and M2, M30 are the M functions of a subprogram's end", Secondary};
  give_role(c.calls.roles, "M17", Role::Return, kManual, Manual);
  give_role(c.calls.roles, "M0", Role::Stop, kIsoM, Secondary);
  give_role(c.calls.roles, "M1", Role::OptionalStop, kIsoM, Secondary);
  give_role(c.calls.roles, "M3", Role::SpindleForward, kIsoM, Secondary);
  give_role(c.calls.roles, "M4", Role::SpindleBackward, kIsoM, Secondary);
  give_role(c.calls.roles, "M5", Role::SpindleStop, kIsoM, Secondary);
  give_role(c.calls.roles, "M6", Role::ToolChange, kIsoM, Secondary);
  give_role(c.calls.roles, "M2", Role::End, kManual, Manual);
  give_role(c.calls.roles, "M30", Role::End, kManual, Manual);
  no_role(c.calls.roles, {"M29", "M98", "M99", "M198", "G65", "G66", "G66.1", "G67"},
          "NCI, ggroups.json: no codes of its own language", Secondary);
}

void alarms(Control& c) {
  using enum Cause;
  take_list(c, {"",
                Inferred,
                false,
                "general knowledge of the SINUMERIK alarms",
                {
#include "controls/siemens/alarms_840d.def"
                }});
}

}  // namespace

Control siemens_one() {
  Control c = siemens::family();
  c.title = "Siemens SINUMERIK ONE mill";
  calls_and_returns(c);
  alarms(c);
  return c;
}

}  // namespace cncsub
