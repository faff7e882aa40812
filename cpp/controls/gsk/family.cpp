#include "controls/gsk/family.hpp"

namespace cncsub::gsk {

void modal_words(Control& c, const std::string& addresses, const std::string& source,
                 Evidence evidence) {
  for (const char address : addresses) {
    const std::int32_t number = modal_word_number(address);
    c.variables.push_back(
        {number, number, VariableKind::ModalWord, Access::ReadOnly, address, source, evidence});
  }
}

CodeCall code_call(CodeCall::Form form, char address, CodeCallKind kind, std::int32_t parameter,
                   std::int32_t program, std::int32_t count) {
  CodeCall call;
  call.form = form;
  call.address = address;
  call.kind = kind;
  call.parameter = parameter;
  call.program = program;
  call.count = count;
  return call;
}

void add_lathe_motion(Control& c) {
  c.motion.machine = {MachineType::LatheA, "TDi 2: X Z absolute, U W increments", Manual};
  c.turning.escape = {ReturnedEscape::Feed, "TDi 23.1 step 4; TA 8", Manual};
  c.turning.lead_apart = {true, "TDi 24.1: F of a thread stays until the next one", Manual};
  c.turning.lead_growth = {"R", "TDi 24.4; TA 17", Manual};
}

}  // namespace cncsub::gsk
