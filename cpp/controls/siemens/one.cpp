// Siemens SINUMERIK ONE, a mill, in its own language (not in ISO mode).
// The keys of the sources stand in sources.def. What they do not say is as in the family.
#include "controls/facts.hpp"
#include "controls/siemens/family.hpp"

namespace cncsub {
namespace {

using enum Evidence;

using siemens::kKnown;
constexpr const char* kManual = "SONE p.45, the words that end a program";

void calls_and_returns(Control& c) {
  leave_out(c, RuleGroup::TurningRules, kManual, Inferred);
  c.calls.max_nesting = {15, "828D p.490: 16 program levels, the main program is on the first",
                         Secondary};
  c.calls.main_return = {MainReturn::Ends, kManual, Manual};
  c.calls.max_repeats = {9999, kKnown, Inferred};
  c.calls.zero_repeats = {ZeroRepeats::Alarm, kKnown, Inferred};
  give_role(c.calls.roles, "M17", Role::Return, kManual, Manual);
  give_role(c.calls.roles, "M2", Role::End, kManual, Manual);
  give_role(c.calls.roles, "M30", Role::End, kManual, Manual);
  no_role(c.calls.roles, {"M29", "M98", "M99", "M198", "G65", "G66", "G66.1", "G67"},
          "NCI, ggroups.json: no codes of its own language", Secondary);
}

void alarms(Control& c) {
  using enum Cause;
  constexpr const char* kJump = "NCI, sinumerik-execution-model.md: 14080";
  c.alarms[JumpTargetNotFound] = {"14080", "jump destination not found", kJump, Secondary};
  c.alarms[GCodeNotAvailable] = {"12470", "G function unknown",
                                 "NCI, sinumerik-execution-model.md: 12470", Secondary};
  c.alarms[StructureMarked] = {"12630", "skip or label at a control structure",
                               "general knowledge of the SINUMERIK alarms", Inferred};
  c.alarms[NestingTooDeep] = {"14012", "lowest subprogram level exceeded", "CW-S, 14012",
                              Secondary};
  c.alarms[NamedProgramNotFound] = {"14011", "program does not exist",
                                    "general knowledge of the SINUMERIK alarms", Inferred};
  c.alarms[VariableGivenTwice] = {"12170", "name defined several times",
                                  "general knowledge of the SINUMERIK alarms", Inferred};
  c.alarms[ArrayElement] = {"12400", "element of array does not exist",
                            "general knowledge of the SINUMERIK alarms", Inferred};
  c.alarms[TooManyArguments] = {"14020", "wrong value or wrong number of parameters",
                                "general knowledge of the SINUMERIK alarms", Inferred};
  c.alarms[RadiusTolerance] = {"14040", "error in end point of circle", "HSA 14040", Secondary};
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
