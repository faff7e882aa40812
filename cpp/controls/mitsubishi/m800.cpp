// Mitsubishi M800, M80, E80.
#include "controls/mitsubishi/family.hpp"

namespace cncsub {

using namespace mitsubishi;

/// Like the M700, with ten levels, and IF blocks with ELSE and ENDIF.
Control mitsubishi_m800() {
  Control c = family();
  c.title = "Mitsubishi M800, M80, E80";
  c.calls.max_nesting = {10, kCW + "ten levels", Secondary};
  c.calls.nesting_counts_macros = {true, kGeneral, Inferred};
  c.macros.if_form = {IfForm::ThenBlocks, kGeneral, Inferred};
  c.macros.max_ifs = {10, kGeneral + ": P288", Inferred};
  c.alarms[Cause::IfTooDeep] = {"P288", "IF EXCEEDED", kGeneral, Inferred};
  c.alarms[Cause::IfWithoutEnd] = {"P289", "IF/ENDIF MISMATCH", kGeneral, Inferred};
  return c;
}

}  // namespace cncsub
