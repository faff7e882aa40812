// Mitsubishi MELDAS before the M700, the control of source 004.
#include "controls/mitsubishi/family.hpp"

namespace cncsub {

using namespace mitsubishi;

/// The control of source 004: four levels, M98 without P jumps; no file names, no devices.
Control mitsubishi_meldas() {
  Control c = family();
  c.macros.if_form = {IfForm::GotoOnly, kGeneral + ": IF THEN came with the M700", Inferred};
  c.title = "Mitsubishi MELDAS before the M700";
  c.calls.max_nesting = {4, k004 + "note on levels", SourceDocument};
  c.calls.nesting_counts_macros = {
      true, "inferred from source 004, note on levels, and SM, difference (6)", Inferred};
  c.calls.omitted_program = {OmittedProgram::Jump, k004 + "P omitted; P, H and L omitted",
                             SourceDocument};
  lacks(c.reading.program_heads, {ProgramHead::Name, ProgramHead::File},
        kGeneral + ": file names came with the M700", Inferred);
  no_role(c.calls.roles, {"M198"}, kGeneral + ": no M198", Inferred);
  c.calls.device_word = {false, kGeneral + ": ,D came with the M700", Inferred};
  return c;
}

}  // namespace cncsub
