// Syntec 22MA, the control of Syil mills: its ISO programs, not its own language (%@MACRO).
#include "controls/mitsubishi/family.hpp"

namespace cncsub {

namespace {

/// Set the variables: all locals of a level, and the commons. None of those beyond #999 is the
/// Mitsubishi's.
void variables(Control& c) {
  using enum Evidence;
  constexpr const char* kSources = "SYM: #1 to #400 are of the level, #401 to #999 kept";
  c.variables = {{0, 0, VariableKind::Vacant, Access::ReadOnly, 0, "SYM: #0 is vacant", Secondary},
                 {1, 400, VariableKind::Local, Access::ReadWrite, 0, kSources, Secondary}};
  c.variable_choices.clear();
  c.macros.commons = {"401-999", kSources, Secondary};
  c.macros.unlisted_variables = {UnlistedVariable::NotKnown,
                                 "SYM: system variables from #1000 on, which are not known here",
                                 Secondary};
}

}  // namespace

/// Calls as a Mitsubishi makes them: H says where to start, and without P a program calls a part of
/// itself. What no source says is as on the Mitsubishi, except for all that has a number there.
Control syntec_22ma() {
  using enum Evidence;
  Control c = mitsubishi::family();
  c.title = "Syntec 22MA mill";
  c.calls.start_word = {StartWord::H, "SYP, M98 H9000; PWR p.149, M98 P H L", Secondary};
  c.calls.omitted_program = {OmittedProgram::Own,
                             "SYP: M98 H9000 calls what N9000 heads in its own program; PWR p.149",
                             Secondary};
  c.calls.mdi_calls = {MdiCalls::Allowed, "PWR p.149: without P in memory and MDI", Secondary};
  c.calls.return_with_p = {c.calls.return_with_p.value,
                           "PWR p.150: M99 P is a block of the caller; in which pass nobody says",
                           Inferred};
  c.calls.return_to_line = {true, "SYM: M99 Q is a line number of the file", Secondary};
  c.calls.end_in_subprogram = {EndInSubprogram::Returns,
                               "SYM: M02 and M30 in a subprogram return to the caller", Secondary};
  give_role(c.calls.roles, "G65", Role::MacroCall, "SYP: G65 P9810 Z", Secondary);
  // The macro of G66.1 is called after the block, which is executed, and has its own arguments.
  no_role(c.calls.roles, {"G66.1"}, "SYM: each block is executed before the macro", Secondary);
  c.motion.g_meanings = {
      "31.1=skip 31.2=skip 31.3=skip 37=not-computed 37.1=measuring "
      "66.1=not-computed",
      "SYM: G66.1; the others are the Mitsubishi's", Inferred};
  // G200 to G999 call the programs G0200 to G0999.
  c.reading.unlisted_codes = {UnlistedCode::NotKnown, "SYM: G200 to G999 are extension codes",
                              Secondary};

  lacks(c.common.refuses, {Cause::ArcFeedZero, Cause::CornerNextShort},
        "policy: the numbers of Mitsubishi's list alone tell them from a missing feed and a long "
        "corner",
        Inferred);

  // The numbers of alarms, parameters and codes that a parameter registers are Mitsubishi's own.
  variables(c);
  c.alarms.clear();
  c.alarms[Cause::ProgramNumberMissing] = {"",        "",    "SYM",
                                           Secondary, false, {{"EX", "COR-052", ""}}};
  c.user_alarm_number.clear();
  c.parameters.clear();
  c.code_calls.clear();
  return c;
}

}  // namespace cncsub
