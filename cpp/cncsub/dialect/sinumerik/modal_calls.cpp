// MCALL, the call after each block that moves.
#include <utility>

#include "cncsub/dialect/sinumerik/block.hpp"

namespace cncsub::sinumerik {

/// Read MCALL SUB(5), or MCALL, which ends the modal call. [PGZ p.2-48, modal call]
bool BlockReader::modal_call(Block& block, Words& words, std::uint32_t at) {
  line_.pass(5);
  words.modal = at;
  if (line_.at_end()) return true;
  const std::string_view name = line_.name();
  if (name.empty() || is_not_computed(capitals(name)))
    return refuse(block, Cause::StatementFormat, "MCALL without the name of a program", at);
  return call(block, words, name);
}

/// Make the block a modal call, or the end of one.
bool BlockReader::write_modal_call(Block& block, const Words& words) {
  const bool alone = !words.any && words.statements.empty() && !words.print && !words.back;
  if (!alone)
    return refuse(block, Cause::IllegalWordWithCall, "MCALL must be alone in its block",
                  *words.modal);
  to_.words(block, {});
  if (!words.call) {
    block.op = Op::CancelModal;
    return true;
  }
  CallRecord call = *words.call;
  call.code_kind = CodeCallKind::Modal;
  to_.become(block, Op::ModalCall, std::move(call));
  return true;
}

}  // namespace cncsub::sinumerik
