// MCALL, the call after each block that moves.
#include <utility>

#include "cncsub/dialect/sinumerik/open_block.hpp"

namespace cncsub::sinumerik {

/// Read MCALL SUB(5), or MCALL, which ends the modal call. [PGZ p.2-48, modal call]
bool modal_call(OpenBlock& open, Block& block, Words& words, std::uint32_t at) {
  open.line.pass(5);
  words.modal = at;
  if (open.line.at_end()) return true;
  const std::string_view name = open.line.name();
  if (name.empty() || is_not_computed(capitals(name)))
    return open.refuse(block, Cause::StatementFormat, "MCALL without the name of a program", at);
  return call(open, block, words, name);
}

/// Make the block a modal call, or the end of one.
bool write_modal_call(OpenBlock& open, Block& block, const Words& words) {
  if (!words.is_call_alone())
    return open.refuse(block, Cause::IllegalWordWithCall, "MCALL must be alone in its block",
                       words.modal.value_or(0));
  open.to.words(block, {});
  if (!words.call) {
    block.op = Op::CancelModal;
    return true;
  }
  CallRecord call = *words.call;
  call.code_kind = CodeCallKind::Modal;
  open.to.become(block, Op::ModalCall, std::move(call));
  return true;
}

}  // namespace cncsub::sinumerik
