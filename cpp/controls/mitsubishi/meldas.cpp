// Mitsubishi MELDAS before the M700, the control of source 004.
#include "controls/mitsubishi/family.hpp"

namespace cncsub {

using namespace mitsubishi;

/// The control of source 004: four levels, M98 without P jumps; no file names, no devices.
Control mitsubishi_meldas() {
  Control c = family();
  c.if_form = {IfForm::GotoOnly, kGeneral + ": IF THEN came with the M700", Inferred};
  c.title = "Mitsubishi MELDAS before the M700";
  c.max_nesting = {4, k004 + "note on levels", SourceDocument};
  c.nesting_counts_macros = {
      true, "inferred from source 004, note on levels, and SM, difference (6)", Inferred};
  c.omitted_program = {OmittedProgram::Jump, k004 + "P omitted; P, H and L omitted",
                       SourceDocument};
  c.named_programs = {false, kGeneral + ": file names came with the M700", Inferred};
  c.file_name_wins = {false, kGeneral + ": file names came with the M700", Inferred};
  c.external_calls = {false, kGeneral + ": no M198", Inferred};
  c.device_word = {false, kGeneral + ": ,D came with the M700", Inferred};
  return c;
}

}  // namespace cncsub
