// GSK 988T lathe.
#include "controls/gsk/family.hpp"

namespace cncsub {

using namespace gsk;

/// Like the 988TA, but without calls in MDI, calls of an open program, and M98 without P.
Control gsk_988t() {
  Control c = family_988();
  c.title = "GSK 988T lathe";
  c.calls.omitted_program = {OmittedProgram::Alarm, kTalm + "081", Manual};
  c.calls.self_call = {SelfCall::Refused, kTalm + "084", Manual};
  c.calls.caller_call = {CallerCall::Refused, kTalm + "084", Manual};
  c.calls.mdi_calls = {MdiCalls::Refused, kTalm + "085", Manual};
  c.calls.max_nesting = {12, kTalm + "082", Manual};
  c.calls.max_macro_nesting = {4, kTalm + "207", Manual};
  c.calls.calls_in_modal = {CallsInModal::Refused, kTalm + "204", Manual};
  c.turning.max_pockets = {10, "Talm 140", Manual};
  // The papers of the 988TA say that such a block is not executed, or takes the sign. [TA 12, 13]
  has(c.common.refuses, {Cause::GrooveAxis, Cause::GrooveEscape, Cause::ThreadRunOutAcross},
      "Talm 040, 154, 157; the 988TA goes no further than the start: TA 18 note 5", Manual);
  // A feed must be commanded. [Talm 021]
  add_parameter(
      c, {"1411", 0, "the feed at power-on", "TApar", Manual, {number(rule::power_on_feed)}});
  return c;
}

}  // namespace cncsub
