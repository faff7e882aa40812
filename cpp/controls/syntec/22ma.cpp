// Syntec 22MA, the control of Syil mills: its ISO programs, not its own language (%@MACRO).
#include "controls/mitsubishi/family.hpp"

namespace cncsub {

/// Calls as a Mitsubishi does: H says where to start, and without P a program calls a part of
/// itself. What no source tells is the Mitsubishi's, less everything that has a number there.
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
  give_role(c.calls.roles, "G65", Role::MacroCall, "SYP: G65 P9810 Z", Secondary);

  lacks(c.common.refuses, {Cause::ArcFeedZero, Cause::CornerNextShort},
        "policy: the numbers of Mitsubishi's list alone tell them from a missing feed and a long "
        "corner",
        Inferred);

  // Numbers are Mitsubishi's own: of alarms, of parameters, of codes that a parameter makes call.
  c.alarms.clear();
  c.user_alarm_number.clear();
  c.parameters.clear();
  c.code_calls.clear();
  return c;
}

}  // namespace cncsub
